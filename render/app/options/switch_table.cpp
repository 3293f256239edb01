#include "render/app/options/switch_table.h"

#include "render/app/options/option_table.h"
#include "render/app/base/text.h"

#include <cstdlib>

namespace app {

namespace {

/// Tried in this order: the first whose letters begin the word and that has text behind them exactly if it wants some
/// (spec 1, 18.3). "A" with any number is ours: POV-Ray knows only numbers that begin with 0.
constexpr Switch kSwitches[] = {
    {"AC", true, nullptr, "Antialias_Confidence"},
    {"AG", true, nullptr, "Antialias_Gamma"},
    {"AM", true, nullptr, "Sampling_Method"},
    {"A0", true, "Antialias", "Antialias_Threshold", "0"},
    {"A", true, "Antialias", "Antialias_Threshold"},
    {"A", false, "Antialias", nullptr},
    {"BM", true, nullptr, "Bounding_Method"},
    {"BS", true, nullptr, "Render_Block_Size"},
    {"B", false, "Bounding", nullptr},
    {"CC", false, "Create_Continue_Trace_Log", nullptr},
    {"C", false, "Continue_Trace", nullptr},
    {"D", true, "Display", "Video_Mode"},
    {"D", false, "Display", nullptr},
    {"EC", true, nullptr, "End_Column"},
    {"EF0", true, nullptr, "Subset_End_Frame", "0"},
    {"EF", true, nullptr, "Subset_End_Frame"},
    {"EP", true, nullptr, "Preview_End_Size"},
    {"ER", true, nullptr, "End_Row"},
    {"F", true, "Output_To_File", "+F"},
    {"F", false, "Output_To_File", nullptr},
    {"GA", true, "All_Console", "All_File"},
    {"GA", false, "All_Console", nullptr},
    {"GD", true, "Debug_Console", "Debug_File"},
    {"GD", false, "Debug_Console", nullptr},
    {"GF", true, "Fatal_Console", "Fatal_File"},
    {"GF", false, "Fatal_Console", nullptr},
    {"GI", true, nullptr, "Create_Ini"},
    {"GP", false, "Append_File", nullptr},
    {"GR", true, "Render_Console", "Render_File"},
    {"GR", false, "Render_Console", nullptr},
    {"GS", true, "Statistic_Console", "Statistic_File"},
    {"GS", false, "Statistic_Console", nullptr},
    {"GW", true, "Warning_Console", "Warning_File"},
    {"GW", false, "Warning_Console", nullptr},
    {"HI", true, nullptr, "Include_Header"},
    {"HR", false, "High_Reproducibility", nullptr},
    {"H", true, nullptr, "Height"},
    {"I", true, nullptr, "Input_File_Name"},
    {"J", true, "Jitter", "Jitter_Amount"},
    {"J", false, "Jitter", nullptr},
    {"KC", false, "Cyclic_Animation", nullptr},
    {"KI", true, nullptr, "Initial_Clock"},
    {"KFF", true, nullptr, "Final_Frame"},
    {"KFI", true, nullptr, "Initial_Frame"},
    {"KF", true, nullptr, "Final_Clock"},
    {"KLA", false, "Clockless_Animation", nullptr},
    {"K", true, nullptr, "Clock"},
    {"L", true, nullptr, "Library_Path"},
    {"MB", true, "Bounding", "Bounding_Threshold"},
    {"MB", false, "Bounding", nullptr},
    {"MI", true, nullptr, "Max_Image_Buffer_Memory"},
    {"MV", true, nullptr, "Version"},
    {"O", true, nullptr, "Output_File_Name"},
    {"P", false, "Pause_When_Done", nullptr},
    {"Q", true, nullptr, "Quality"},
    {"RFI", false, "Radiosity_From_File", nullptr},
    {"RFO", false, "Radiosity_To_File", nullptr},
    {"RF", true, nullptr, "Radiosity_File_Name"},
    {"RS", true, nullptr, "Render_Block_Step"},
    {"RP", true, nullptr, "Render_Pattern"},
    {"RTR", false, "Real_Time_Raytracing", nullptr},
    {"RVP", false, "Radiosity_Vain_Pretrace", nullptr},
    {"R", true, nullptr, "Antialias_Depth"},
    {"SC", true, nullptr, "Start_Column"},
    {"SF0", true, nullptr, "Subset_Start_Frame", "0"},
    {"SF", true, nullptr, "Subset_Start_Frame"},
    {"SM", true, nullptr, "+SM"},  // not POV-Ray's: LeoCAD's
    {"SP", true, nullptr, "Preview_Start_Size"},
    {"SR", true, nullptr, "Start_Row"},
    {"SS", true, nullptr, "Stochastic_Seed"},
    {"STP", true, nullptr, "Frame_Step"},
    {"SU", false, "Split_Unions", nullptr},
    {"TH", true, "Dither", "Dither_Method"},
    {"TH", false, "Dither", nullptr},
    {"UA", false, "Output_Alpha", nullptr},
    {"UD", false, "Draw_Vistas", nullptr},
    {"UF", false, "Field_Render", nullptr},
    {"UL", false, "Light_Buffer", nullptr},
    {"UO", false, "Odd_Field", nullptr},
    {"UR", false, "Remove_Bounds", nullptr},
    {"UV", false, "Vista_Buffer", nullptr},
    {"V", false, "Verbose", nullptr},
    {"WL", true, nullptr, "Warning_Level"},
    {"WT", true, nullptr, "Work_Threads"},
    {"W", true, nullptr, "Width"},
    {"X", true, "Test_Abort", "Test_Abort_Count"},
    {"X", false, "Test_Abort", nullptr},
};

bool fits(const Switch& entry, std::string_view word)
{
    const std::string_view letters = entry.letters;
    return starts_with_text(word, letters) && (word.size() > letters.size()) == entry.parameter;
}

}  // namespace

std::span<const Switch> switch_table() { return kSwitches; }

SwitchText text_of(const Switch& entry)
{
    if (*entry.prefix) return {};
    const std::string_view set = entry.option ? entry.option : entry.flag;
    if (set == "+F")
        return {"+F<type>[bits]", "write the picture: type N PNG, P PPM, T C Targa, J JPEG, B BMP, E OpenEXR, H "
                                  "Radiance; g for grey, or bits a channel"};
    if (set == "+SM")
        return {"+SM<name>", "the same as --preview=<name>: a file in which LeoCAD watches the picture grow"};
    const Option& option = *find_option(set);
    const char* value = option.kind == ValueKind::Text ? "<name>" : option.kind == ValueKind::Integer ? "<n>" : "<x>";
    std::string form = entry.letters;
    form.insert(form.begin(), '+');
    return {entry.parameter ? form + value : form, option.meaning};
}

void apply_switch(Settings& settings, const std::string& word)
{
    const std::string_view body = std::string_view(word).substr(1);
    for (const Switch& entry : kSwitches) {
        if (!fits(entry, body)) continue;
        if (entry.flag) set_option(settings, entry.flag, word[0] == '+' ? "on" : "off");
        if (!entry.option) return;
        const std::string text = entry.prefix + std::string(body.substr(std::string_view(entry.letters).size()));
        if (std::string_view(entry.option) == "+F") return set_file_type_switch(settings, text);
        if (std::string_view(entry.option) == "+SM") {
            settings.preview_file = text;
            return;
        }
        // POV-Ray reads no threshold of 1 and above here; +A1 is a known mistake for +A.
        if (std::string_view(entry.letters) == "A" && std::strtod(text.c_str(), nullptr) > 1.0)
            throw OptionError("unknown switch '" + word + "': the threshold of +A lies from 0 to 1, as in +A0.3");
        return set_option(settings, entry.option, text);
    }
    throw OptionError("unknown switch '" + word + "'");
}

}  // namespace app
