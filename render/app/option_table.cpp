#include "render/app/option_table.h"

#include "render/app/ini_file.h"
#include "render/app/text.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>

namespace app {

namespace {

image::FileType file_type_of(char letter)
{
    constexpr std::string_view kLetters = "NPTCJBEH";
    const char upper = upper_case(letter);
    if (kLetters.find(upper) == std::string_view::npos) throw OptionError(std::string("unknown output file type '") + letter + "'");
    return static_cast<image::FileType>(upper);
}

/// Declare=name=value: single precision, then six significant digits (spec 1, 18.5). The first declaration wins.
void declare(Settings& settings, const Value& value)
{
    const std::size_t equals = value.text.find('=');
    if (equals == std::string::npos || equals == 0) throw OptionError("Declare wants name=value, found '" + value.text + "'");
    const std::string name(trimmed(std::string_view(value.text).substr(0, equals)));
    const std::string text(trimmed(std::string_view(value.text).substr(equals + 1)));
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
        settings.declared_strings.emplace(name, text.substr(1, text.size() - 2));
        return;
    }
    char* end = nullptr;
    const float number = std::strtof(text.c_str(), &end);
    if (end == text.c_str()) throw OptionError("Declare wants a number or a quoted string for '" + name + "', found '" + text + "'");
    char printed[32];
    std::snprintf(printed, sizeof printed, "%.6g", static_cast<double>(number));
    settings.declared_numbers.emplace(name, std::strtod(printed, nullptr));
}

constexpr auto kFlag = ValueKind::Flag;
constexpr auto kInteger = ValueKind::Integer;
constexpr auto kNumber = ValueKind::Number;
constexpr auto kText = ValueKind::Text;
constexpr auto kGamma = ValueKind::Gamma;

/// An option that sets a member to the value's part of the same type.
template <auto Member> void set(Settings& settings, const Value& value)
{
    auto& target = settings.*Member;
    using Target = std::remove_reference_t<decltype(target)>;
    if constexpr (std::is_same_v<Target, bool> || std::is_same_v<Target, std::optional<bool>>) target = value.flag;
    else if constexpr (std::is_same_v<Target, int> || std::is_same_v<Target, std::optional<int>>) target = value.integer;
    else if constexpr (std::is_same_v<Target, std::string>) target = value.text;
    else if constexpr (std::is_same_v<Target, image::TransferCurve>) target = value.curve;
    else if constexpr (std::is_same_v<Target, double>) target = value.number;
    else target = static_cast<float>(value.number);
}

/// The same within a range.
template <auto Member, int Low, int High> void set_within(Settings& settings, const Value& value)
{
    auto& target = settings.*Member;
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(target)>, int>) target = std::clamp(value.integer, Low, High);
    else target = static_cast<float>(std::clamp(value.number, static_cast<double>(Low), static_cast<double>(High)));
}

void set_size(int& target, int value, const char* what)
{
    if (value < 1) throw OptionError(std::string(what) + " of the picture must be at least 1");
    target = value;
}

void set_version(Settings& s, const Value& v) { s.version = static_cast<int>(100.0 * std::clamp(v.number, 1.0, 100.0) + 0.5); }

void add_library_path(Settings& s, const Value& v)
{
    std::string folder = v.text;
    while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
    if (std::find(s.library_path.begin(), s.library_path.end(), folder) == s.library_path.end()) s.library_path.push_back(folder);
}

void set_block_size(Settings& s, const Value& v)
{
    if (v.integer < 4) throw OptionError("Render_Block_Size must be at least 4");
    s.block_size = v.integer;
}

void set_file_type(Settings& s, const Value& v)
{
    if (v.text.empty()) throw OptionError("Output_File_Type wants a letter");
    s.file_type = file_type_of(v.text[0]);  // digits behind it are ignored here, unlike in the switch
}

void include_ini(Settings& s, const Value& v)
{
    if (!read_ini_file(s, v.text)) throw OptionError("no INI file is called '" + v.text + "'");
}

/// Every keyword of POV-Ray 3.7 (spec 1, data/01-options.csv), in alphabetical order.
constexpr Option kOptions[] = {
    {"All_Console", kFlag, State::Acts, set<&Settings::all_console>},
    {"All_File", kText, State::Acts, set<&Settings::all_file>},
    {"Antialias", kFlag, State::Acts, set<&Settings::antialias>},
    {"Antialias_Depth", kInteger, State::Acts, set_within<&Settings::antialias_depth, 1, 9>},
    {"Antialias_Gamma", kNumber, State::Acts, set<&Settings::antialias_gamma>},
    {"Antialias_Threshold", kNumber, State::Acts, set_within<&Settings::antialias_threshold, 0, 1>},
    {"Append_File", kFlag, State::Acts, set<&Settings::append_file>},
    {"Bits_Per_Color", kInteger, State::Acts, set<&Settings::bits_per_color>},
    {"Bits_Per_Colour", kInteger, State::Acts, set<&Settings::bits_per_color>},
    {"Bounding", kFlag, State::Settled, nullptr},
    {"Bounding_Method", kInteger, State::Settled, nullptr},
    {"Bounding_Threshold", kInteger, State::Settled, nullptr},
    {"BSP_BaseAccessCost", kNumber, State::Settled, nullptr},
    {"BSP_ChildAccessCost", kNumber, State::Settled, nullptr},
    {"BSP_ISectCost", kNumber, State::Settled, nullptr},
    {"BSP_MaxDepth", kInteger, State::Settled, nullptr},
    {"BSP_MissChance", kNumber, State::Settled, nullptr},
    {"Buffer_Output", kText, State::Obsolete, nullptr},
    {"Buffer_Size", kText, State::Obsolete, nullptr},
    {"Clock", kNumber, State::Acts, [](Settings& s, const Value& v) { s.clock = static_cast<float>(v.number); }},
    {"Clockless_Animation", kFlag, State::NotYet, nullptr},
    {"Compression", kInteger, State::Acts, set_within<&Settings::compression, 0, 100>},
    {"Continue_Trace", kFlag, State::Acts, set<&Settings::continue_trace>},
    {"Create_Histogram", kText, State::Obsolete, nullptr},
    {"Create_Ini", kText, State::NotYet, nullptr},
    {"Cyclic_Animation", kFlag, State::Acts, set<&Settings::cyclic>},
    {"Debug_Console", kFlag, State::Acts, set<&Settings::debug_console>},
    {"Debug_File", kText, State::Acts, set<&Settings::debug_file>},
    {"Declare", kText, State::Acts, declare},
    {"Display", kFlag, State::Settled, nullptr},
    {"Display_Gamma", kGamma, State::Acts, set<&Settings::display_gamma>},
    {"Dither", kFlag, State::NotYet, nullptr},
    {"Dither_Method", kText, State::NotYet, nullptr},
    {"Draw_Vistas", kFlag, State::Settled, nullptr},
    {"End_Column", kNumber, State::Acts, set<&Settings::end_column>},
    {"End_Row", kNumber, State::Acts, set<&Settings::end_row>},
    {"Fatal_Console", kFlag, State::Acts, set<&Settings::fatal_console>},
    {"Fatal_Error_Command", kText, State::NotYet, nullptr},
    {"Fatal_Error_Return", kText, State::NotYet, nullptr},
    {"Fatal_File", kText, State::Acts, set<&Settings::fatal_file>},
    {"Field_Render", kFlag, State::Settled, nullptr},
    {"File_Gamma", kGamma, State::Acts, set<&Settings::file_gamma>},
    {"Final_Clock", kNumber, State::Acts, set<&Settings::final_clock>},
    {"Final_Frame", kInteger, State::Acts, set<&Settings::final_frame>},
    {"Frame_Step", kInteger, State::Acts, set<&Settings::frame_step>},
    {"Grayscale_Output", kFlag, State::Acts, set<&Settings::greyscale>},
    {"Height", kInteger, State::Acts, [](Settings& s, const Value& v) { set_size(s.height, v.integer, "the height"); }},
    {"High_Reproducibility", kFlag, State::Settled, nullptr},
    {"Histogram_Grid_Size", kText, State::Obsolete, nullptr},
    {"Histogram_Name", kText, State::Obsolete, nullptr},
    {"Histogram_Type", kText, State::Obsolete, nullptr},
    {"Include_Header", kText, State::Acts, set<&Settings::include_header>},
    {"Include_Ini", kText, State::Acts, include_ini},
    {"Initial_Clock", kNumber, State::Acts, set<&Settings::initial_clock>},
    {"Initial_Frame", kInteger, State::Acts, set<&Settings::initial_frame>},
    {"Input_File_Name", kText, State::Acts, set<&Settings::input_file>},
    {"Jitter", kFlag, State::Acts, set<&Settings::jitter>},
    {"Jitter_Amount", kNumber, State::Acts, set_within<&Settings::jitter_amount, 0, 1>},
    {"Library_Path", kText, State::Acts, add_library_path},
    {"Light_Buffer", kFlag, State::Settled, nullptr},
    {"Max_Image_Buffer_Memory", kInteger, State::Settled, nullptr},
    {"Odd_Field", kFlag, State::Settled, nullptr},
    {"Output_Alpha", kFlag, State::Acts, set<&Settings::alpha>},
    {"Output_File_Name", kText, State::Acts, set<&Settings::output_file>},
    {"Output_File_Type", kText, State::Acts, set_file_type},
    {"Output_To_File", kFlag, State::Acts, set<&Settings::output_to_file>},
    {"Palette", kText, State::Settled, nullptr},
    {"Pause_When_Done", kFlag, State::Settled, nullptr},
    {"Post_Frame_Command", kText, State::NotYet, nullptr},
    {"Post_Frame_Return", kText, State::NotYet, nullptr},
    {"Post_Scene_Command", kText, State::NotYet, nullptr},
    {"Post_Scene_Return", kText, State::NotYet, nullptr},
    {"Pre_Frame_Command", kText, State::NotYet, nullptr},
    {"Pre_Frame_Return", kText, State::NotYet, nullptr},
    {"Pre_Scene_Command", kText, State::NotYet, nullptr},
    {"Pre_Scene_Return", kText, State::NotYet, nullptr},
    {"Preview_End_Size", kInteger, State::Settled, nullptr},
    {"Preview_Start_Size", kInteger, State::Settled, nullptr},
    {"Quality", kInteger, State::Acts, set_within<&Settings::quality, 0, 11>},
    {"Radiosity_File_Name", kText, State::NotYet, nullptr},
    {"Radiosity_From_File", kFlag, State::NotYet, nullptr},
    {"Radiosity_To_File", kFlag, State::NotYet, nullptr},
    {"Radiosity_Vain_Pretrace", kFlag, State::NotYet, nullptr},
    {"Real_Time_Raytracing", kFlag, State::NotYet, nullptr},
    {"Remove_Bounds", kFlag, State::Settled, nullptr},
    {"Render_Block_Size", kInteger, State::Acts, set_block_size},
    {"Render_Block_Step", kInteger, State::Settled, nullptr},
    {"Render_Console", kFlag, State::Acts, set<&Settings::render_console>},
    {"Render_File", kText, State::Acts, set<&Settings::render_file>},
    {"Render_Pattern", kInteger, State::Settled, nullptr},
    {"Sampling_Method", kInteger, State::Acts, set_within<&Settings::sampling_method, 0, 2>},
    {"Split_Unions", kFlag, State::Acts, set<&Settings::split_unions>},
    {"Start_Column", kNumber, State::Acts, set<&Settings::start_column>},
    {"Start_Row", kNumber, State::Acts, set<&Settings::start_row>},
    {"Statistic_Console", kFlag, State::Acts, set<&Settings::statistic_console>},
    {"Statistic_File", kText, State::Acts, set<&Settings::statistic_file>},
    {"Subset_End_Frame", kNumber, State::Acts, set<&Settings::subset_end_frame>},
    {"Subset_Start_Frame", kNumber, State::Acts, set<&Settings::subset_start_frame>},
    {"Test_Abort", kFlag, State::Settled, nullptr},
    {"Test_Abort_Count", kInteger, State::Settled, nullptr},
    {"User_Abort_Command", kText, State::NotYet, nullptr},
    {"User_Abort_Return", kText, State::NotYet, nullptr},
    {"Verbose", kFlag, State::Acts, set<&Settings::verbose>},
    {"Version", kNumber, State::Acts, set_version},
    {"Video_Mode", kText, State::Settled, nullptr},
    {"Vista_Buffer", kFlag, State::Settled, nullptr},
    {"Warning_Console", kFlag, State::Acts, set<&Settings::warning_console>},
    {"Warning_File", kText, State::Acts, set<&Settings::warning_file>},
    {"Warning_Level", kInteger, State::Settled, nullptr},
    {"Width", kInteger, State::Acts, [](Settings& s, const Value& v) { set_size(s.width, v.integer, "the width"); }},
    {"Work_Threads", kInteger, State::Acts, set_within<&Settings::threads, 1, 512>},
};

/// Numbers are read as far as they go: 9x is 9.
Value value_of(const Option& option, const std::string& text)
{
    Value value{text, truth_of(text), 0, 0.0, {}};
    const std::string keyword(option.keyword);
    char* end = nullptr;
    switch (option.kind) {
        case ValueKind::Flag:
        case ValueKind::Text: return value;
        case ValueKind::Integer: value.integer = static_cast<int>(std::strtol(text.c_str(), &end, 10)); break;
        case ValueKind::Gamma:
            if (same_text(text, "srgb")) {
                value.curve = image::TransferCurve::srgb();
                return value;
            }
            [[fallthrough]];
        case ValueKind::Number: value.number = std::strtod(text.c_str(), &end); break;
    }
    if (end == text.c_str()) throw OptionError(keyword + " wants a number, found '" + text + "'");
    if (option.kind != ValueKind::Gamma) return value;
    if (!(value.number > 0.0)) throw OptionError(keyword + " wants a number above 0 or sRGB, found '" + text + "'");
    value.curve = image::TransferCurve::power(static_cast<float>(value.number));
    return value;
}

}  // namespace

std::span<const Option> option_table() { return kOptions; }

const Option* find_option(std::string_view keyword)
{
    const auto* found = std::find_if(std::begin(kOptions), std::end(kOptions), [&](const Option& o) { return same_text(o.keyword, keyword); });
    return found == std::end(kOptions) ? nullptr : found;
}

void set_option(Settings& settings, std::string_view keyword, const std::string& text)
{
    const Option* option = find_option(keyword);
    if (!option) throw OptionError("unknown option '" + std::string(keyword) + "'");
    const Value value = value_of(*option, text);
    if (option->state == State::Acts) return option->apply(settings, value);
    if (option->state == State::Obsolete) throw OptionError(std::string(option->keyword) + " is obsolete");
    // Asking for what happens anyway needs no remark: -TH, Radiosity_To_File=off.
    if (option->state != State::NotYet || (option->kind == ValueKind::Flag && !value.flag)) return;
    const std::string name(option->keyword);
    auto& noted = settings.not_acted_on;
    if (std::find(noted.begin(), noted.end(), name) == noted.end()) noted.push_back(name);
}

bool truth_of(std::string_view text)
{
    for (const std::string_view word : {"on", "true", "yes", "1"}) {
        const std::size_t length = std::min(word.size(), text.size());
        if (same_text(word.substr(0, length), text.substr(0, length))) return true;
    }
    return false;
}

void set_file_type_switch(Settings& settings, const std::string& text)
{
    settings.file_type = file_type_of(text[0]);
    const std::string_view rest = std::string_view(text).substr(1);
    if (rest.empty()) return;
    if (same_text(rest, "g")) {
        settings.greyscale = true;
        return;
    }
    int bits = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), bits);
    if (error != std::errc() || end != rest.data() + rest.size()) throw OptionError("unknown output file type '" + text + "'");
    settings.bits_per_color = bits;
}

}  // namespace app
