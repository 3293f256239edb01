#include "render/app/options/option_table.h"

#include "render/app/options/ini_file.h"
#include "render/app/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>

namespace app {

namespace {

/// Declare=name=value: single precision, then six significant digits (spec 1, 18.5). The first declaration wins.
void declare(Settings& settings, const Value& value)
{
    const std::size_t equals = value.text.find('=');
    if (equals == std::string::npos || equals == 0) {
        settings.notes.push_back("Declare wants name=value: '" + value.text + "' declares nothing");
        return;
    }
    const std::string name(trimmed(std::string_view(value.text).substr(0, equals)));
    const std::string text(trimmed(std::string_view(value.text).substr(equals + 1)));
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
        settings.declared_strings.emplace(name, text.substr(1, text.size() - 2));
        return;
    }
    char* end = nullptr;
    const float number = std::strtof(text.c_str(), &end);
    if (text.empty()) return;
    if (end == text.c_str())
        settings.notes.push_back("Declare wants a number or a quoted string: '" + name + "' is 0, not '" + text + "'");
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
template <auto Member>
void set(Settings& settings, const Value& value)
{
    auto& target = settings.*Member;
    using Target = std::remove_reference_t<decltype(target)>;
    if constexpr (std::is_same_v<Target, bool> || std::is_same_v<Target, std::optional<bool>>) target = value.flag;
    else if constexpr (std::is_same_v<Target, int> || std::is_same_v<Target, std::optional<int>>)
        target = value.integer;
    else if constexpr (std::is_same_v<Target, std::string>) target = value.text;
    else if constexpr (std::is_same_v<Target, image::TransferCurve>) target = value.curve;
    else if constexpr (std::is_same_v<Target, double>) target = value.number;
    else target = static_cast<float>(value.number);
}

/// The same within a range.
template <auto Member, int Low, int High>
void set_within(Settings& settings, const Value& value)
{
    auto& target = settings.*Member;
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(target)>, int>)
        target = std::clamp(value.integer, Low, High);
    else target = static_cast<float>(std::clamp(value.number, static_cast<double>(Low), static_cast<double>(High)));
}

template <Hook H>
void set_command(Settings& s, const Value& v)
{
    s.commands[static_cast<std::size_t>(H)] = v.text;
}
template <Hook H>
void set_return(Settings& s, const Value& v)
{
    s.command_returns[static_cast<std::size_t>(H)] = v.text;
}

void set_dither_method(Settings& s, const Value& v)
{
    using image::Dither;
    constexpr std::pair<std::string_view, Dither> kMethods[] = {{"AT", Dither::Atkinson},
                                                                {"B2", Dither::Ordered2},
                                                                {"B3", Dither::Ordered3},
                                                                {"B4", Dither::Ordered4},
                                                                {"BK", Dither::Burkes},
                                                                {"BN", Dither::BlueNoise},
                                                                {"BNX", Dither::BlueNoiseExchanged},
                                                                {"D1", Dither::Carry},
                                                                {"D2", Dither::Spread},
                                                                {"FS", Dither::FloydSteinberg},
                                                                {"JN", Dither::JarvisJudiceNinke},
                                                                {"S2", Dither::SierraTwoRows},
                                                                {"S3", Dither::SierraThreeRows},
                                                                {"ST", Dither::Stucki}};
    for (const auto& [name, method] : kMethods) {
        if (!same_text(v.text, name)) continue;
        s.dither_method = method;
        return;
    }
    throw OptionError("Dither_Method wants AT, B2, B3, B4, BK, BN, BNX, D1, D2, FS, JN, S2, S3 or ST, found '" +
                      v.text + "'");
}

void set_size(int& target, int value, const char* what)
{
    if (value < 1) throw OptionError(std::string(what) + " of the picture must be at least 1");
    target = value;
}

void set_threads(Settings& s, const Value& v)
{
    constexpr int kMost = 512;
    s.threads = std::clamp(v.integer, 1, kMost);
    if (s.threads != v.integer)
        s.notes.push_back(fmt::format("Work_Threads is 1 to {}: {} counts as {}", kMost, v.text, s.threads));
}

void set_version(Settings& s, const Value& v)
{
    s.version = static_cast<int>(100.0 * std::clamp(v.number, 1.0, 100.0) + 0.5);
}

void add_library_path(Settings& s, const Value& v)
{
    std::string folder = v.text;
    while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
    if (std::find(s.library_path.begin(), s.library_path.end(), folder) == s.library_path.end())
        s.library_path.push_back(folder);
}

void set_block_size(Settings& s, const Value& v)
{
    if (v.integer < 4) throw OptionError("Render_Block_Size must be at least 4");
    s.block_size = v.integer;
}

constexpr const char* kFileTypeLetters = "N PNG, P PPM, T or C Targa, J JPEG, B BMP, E OpenEXR, H Radiance";

void set_file_type(Settings& s, const Value& v)
{
    if (v.text.empty()) throw OptionError("Output_File_Type wants a letter");
    s.file_type = file_type_of(v.text[0]);  // digits behind it are ignored here, unlike in the switch
    if (v.text.find_first_not_of("0123456789", 1) == std::string::npos) return;
    const std::string_view usual = std::string_view(image::extension(s.file_type)).substr(1);
    for (const std::string_view name : {usual, std::string_view("jpeg"), std::string_view("targa")})
        if (same_text(v.text, name)) return;
    s.notes.push_back(fmt::format("Output_File_Type={} writes {}: only the first letter counts, {}", v.text, usual,
                                  kFileTypeLetters));
}

void include_ini(Settings& s, const Value& v)
{
    if (!read_ini_file(s, v.text)) throw OptionError("no INI file is called '" + v.text + "'");
}

/// Every keyword of POV-Ray 3.7 and 3.8 (spec 1, 18; docs/povray/data/01-options.csv), in alphabetical order.
constexpr Option kOptions[] = {
    {"All_Console", "text of every stream on the console; overrides the single switches", kFlag, State::Acts,
     set<&Settings::all_console>},
    {"All_File", "keep all text in this file, in the folder of the picture", kText, State::Acts,
     set<&Settings::all_file>},
    {"Antialias", "more samples where the picture is not smooth", kFlag, State::Acts, set<&Settings::antialias>},
    {"Antialias_Confidence", "of method 3: how sure a pixel's error is to be within the threshold, 0 to 1", kNumber,
     State::Acts, set_within<&Settings::antialias_confidence, 0, 1>},
    {"Antialias_Depth",
     "depth of antialiasing, 1 to 9: rows of samples in a pixel, levels of halving, or of method 3 a power of 4 "
     "samples",
     kInteger, State::Acts, set_within<&Settings::antialias_depth, 1, 9>},
    {"Antialias_Gamma", "gamma in which antialiasing compares colours", kNumber, State::Acts,
     set<&Settings::antialias_gamma>},
    {"Antialias_Threshold", "difference of neighbours from which more samples are taken, 0 to 1", kNumber, State::Acts,
     set_within<&Settings::antialias_threshold, 0, 1>},
    {"Append_File", "text files are appended to", kFlag, State::Acts, set<&Settings::append_file>},
    {"Bits_Per_Color", "bits a channel of the picture, 1 to 16 (of scenes before 3.8 from 5 on)", kInteger, State::Acts,
     set<&Settings::bits_per_color>},
    {"Bits_Per_Colour", "the same", kInteger, State::Acts, set<&Settings::bits_per_color>},
    {"Bounding", "bounding; always on", kFlag, State::Settled, nullptr},
    {"Bounding_Method", "kind of bounding hierarchy", kInteger, State::Settled, nullptr},
    {"Bounding_Threshold", "objects from which bounding is on", kInteger, State::Settled, nullptr},
    {"BSP_BaseAccessCost", "of a kind of bounding that is not used here", kNumber, State::Settled, nullptr},
    {"BSP_ChildAccessCost", "the same", kNumber, State::Settled, nullptr},
    {"BSP_ISectCost", "the same", kNumber, State::Settled, nullptr},
    {"BSP_MaxDepth", "the same", kInteger, State::Settled, nullptr},
    {"BSP_MissChance", "the same", kNumber, State::Settled, nullptr},
    {"Buffer_Output", "of earlier versions", kText, State::Obsolete, nullptr},
    {"Buffer_Size", "of earlier versions", kText, State::Obsolete, nullptr},
    {"Clock", "value of clock in a single picture", kNumber, State::Acts,
     [](Settings& s, const Value& v) { s.clock = static_cast<float>(v.number); }},
    {"Clockless_Animation", "for real-time raytracing; nothing else", kFlag, State::Settled, nullptr},
    {"Compression", "quality of JPEG, 2 to 100; of 3.8 PPM as text (0) and packed Targa (1)", kInteger, State::Acts,
     set_within<&Settings::compression, 0, 100>},
    {"Continue_Trace", "go on with a picture that was interrupted; leave one that is there", kFlag, State::Acts,
     set<&Settings::continue_trace>},
    {"Create_Continue_Trace_Log", "keep what +C goes on from while a picture is made", kFlag, State::Settled, nullptr},
    {"Create_Histogram", "of earlier versions", kText, State::Obsolete, nullptr},
    {"Create_Ini", "write the options in force as an INI file", kText, State::Acts, set<&Settings::create_ini>},
    {"Cyclic_Animation", "the frame behind the last is the first again", kFlag, State::Acts, set<&Settings::cyclic>},
    {"Debug_Console", "text of #debug on the console", kFlag, State::Acts, set<&Settings::debug_console>},
    {"Debug_File", "keep text of #debug in this file", kText, State::Acts, set<&Settings::debug_file>},
    {"Declare", "name=value: a variable of the scene, a number or a string in quotes", kText, State::Acts, declare},
    {"Display", "a window with the picture; there is none here", kFlag, State::Settled, nullptr},
    {"Display_Gamma", "gamma of the display: sRGB or a number", kGamma, State::Acts, set<&Settings::display_gamma>},
    {"Dither", "dither what is lost by rounding", kFlag, State::Acts, set<&Settings::dither>},
    {"Dither_Method", "how: AT B2 B3 B4 BK BN BNX D1 D2 FS JN S2 S3 ST", kText, State::Acts, set_dither_method},
    {"Draw_Vistas", "draw vista rectangles", kFlag, State::Settled, nullptr},
    {"End_Column", "last column to render, counted from 1, or a share of the width", kNumber, State::Acts,
     set<&Settings::end_column>},
    {"End_Row", "last row to render, counted from 1, or a share of the height", kNumber, State::Acts,
     set<&Settings::end_row>},
    {"Fatal_Console", "errors on the console", kFlag, State::Acts, set<&Settings::fatal_console>},
    {"Fatal_Error_Command", "command to run after an error", kText, State::Acts, set_command<Hook::FatalError>},
    {"Fatal_Error_Return",
     "what its exit status does: I S A Q U F (ignore, skip, all, quit, abort, fail), - in front: a status of 0", kText,
     State::Acts, set_return<Hook::FatalError>},
    {"Fatal_File", "keep errors in this file", kText, State::Acts, set<&Settings::fatal_file>},
    {"Field_Render", "alternate frames have alternate rows", kFlag, State::Settled, nullptr},
    {"File_Gamma", "gamma of the picture file: sRGB, BT709, BT2020 or a number", kGamma, State::Acts,
     set<&Settings::file_gamma>},
    {"Final_Clock", "clock of the last frame", kNumber, State::Acts, set<&Settings::final_clock>},
    {"Final_Frame", "number of the last frame", kInteger, State::Acts, set<&Settings::final_frame>},
    {"Frame_Step", "render every so many frames", kInteger, State::Acts, set<&Settings::frame_step>},
    {"Grayscale_Output", "a picture in shades of grey, PNG or PPM", kFlag, State::Acts, set<&Settings::greyscale>},
    {"Greyscale_Output", "the same", kFlag, State::Acts, set<&Settings::greyscale>},
    {"Height", "rows of the picture", kInteger, State::Acts,
     [](Settings& s, const Value& v) { set_size(s.height, v.integer, "the height"); }},
    {"High_Reproducibility", "the same picture each time; always so", kFlag, State::Settled, nullptr},
    {"Histogram_Grid_Size", "of earlier versions", kText, State::Obsolete, nullptr},
    {"Histogram_Name", "of earlier versions", kText, State::Obsolete, nullptr},
    {"Histogram_Type", "of earlier versions", kText, State::Obsolete, nullptr},
    {"Include_Header", "a file to include ahead of the scene", kText, State::Acts, set<&Settings::include_header>},
    {"Include_Ini", "another INI file", kText, State::Acts, include_ini},
    {"Initial_Clock", "clock of the first frame", kNumber, State::Acts, set<&Settings::initial_clock>},
    {"Initial_Frame", "number of the first frame", kInteger, State::Acts, set<&Settings::initial_frame>},
    {"Input_File_Name", "the scene; - is standard input", kText, State::Acts, set<&Settings::input_file>},
    {"Jitter", "move the samples of antialiasing at random", kFlag, State::Acts, set<&Settings::jitter>},
    {"Jitter_Amount", "how far, 0 to 1", kNumber, State::Acts, set_within<&Settings::jitter_amount, 0, 1>},
    {"Library_Path", "a folder to look for files in, after those given before", kText, State::Acts, add_library_path},
    {"Light_Buffer", "light buffer", kFlag, State::Settled, nullptr},
    {"Max_Image_Buffer_Memory", "memory for the picture", kInteger, State::Settled, nullptr},
    {"Motion_Samples", "moments of a picture with a Shutter, 1 to 4096; Whittle's own", kInteger, State::Acts,
     set_within<&Settings::motion_samples, 1, 4096>},
    {"Odd_Field", "which rows come first", kFlag, State::Settled, nullptr},
    {"Output_Alpha", "an alpha channel in the picture", kFlag, State::Acts, set<&Settings::alpha>},
    {"Output_File_Name", "the picture; - is standard output; a folder ends in /", kText, State::Acts,
     set<&Settings::output_file>},
    {"Output_File_Type", kFileTypeLetters, kText, State::Acts, set_file_type},
    {"Output_To_File", "write the picture to a file", kFlag, State::Acts, set<&Settings::output_to_file>},
    {"Palette", "palette of a display", kText, State::Settled, nullptr},
    {"Pause_When_Done", "wait for a key at the end; never here", kFlag, State::Settled, nullptr},
    {"Post_Frame_Command", "command to run after each frame", kText, State::Acts, set_command<Hook::PostFrame>},
    {"Post_Frame_Return",
     "what its exit status does: I S A Q U F (ignore, skip, all, quit, abort, fail), - in front: a status of 0", kText,
     State::Acts, set_return<Hook::PostFrame>},
    {"Post_Scene_Command", "command to run at the end", kText, State::Acts, set_command<Hook::PostScene>},
    {"Post_Scene_Return",
     "what its exit status does: I S A Q U F (ignore, skip, all, quit, abort, fail), - in front: a status of 0", kText,
     State::Acts, set_return<Hook::PostScene>},
    {"Pre_Frame_Command", "command to run before each frame", kText, State::Acts, set_command<Hook::PreFrame>},
    {"Pre_Frame_Return",
     "what its exit status does: I S A Q U F (ignore, skip, all, quit, abort, fail), - in front: a status of 0", kText,
     State::Acts, set_return<Hook::PreFrame>},
    {"Pre_Scene_Command", "command to run first", kText, State::Acts, set_command<Hook::PreScene>},
    {"Pre_Scene_Return",
     "what its exit status does: I S A Q U F (ignore, skip, all, quit, abort, fail), - in front: a status of 0", kText,
     State::Acts, set_return<Hook::PreScene>},
    {"Preview_End_Size", "last mosaic of the preview", kInteger, State::Settled, nullptr},
    {"Preview_Start_Size", "first mosaic of the preview", kInteger, State::Settled, nullptr},
    {"Quality", "0 to 11: what is left out for speed", kInteger, State::Acts, set_within<&Settings::quality, 0, 11>},
    {"Radiosity_File_Name", "file of radiosity samples", kText, State::Acts, set<&Settings::radiosity_file>},
    {"Radiosity_From_File", "read radiosity samples", kFlag, State::Acts, set<&Settings::radiosity_from_file>},
    {"Radiosity_To_File", "write radiosity samples", kFlag, State::Acts, set<&Settings::radiosity_to_file>},
    {"Radiosity_Vain_Pretrace", "light up what passes of radiosity see; it changes nothing", kFlag, State::Settled,
     nullptr},
    {"Real_Time_Raytracing", "frame after frame to a window", kFlag, State::NotYet, nullptr},
    {"Remove_Bounds", "drop bounded_by that does not help", kFlag, State::Settled, nullptr},
    {"Render_Block_Size", "side of the blocks that threads take, at least 4", kInteger, State::Acts, set_block_size},
    {"Render_Block_Step", "order of the blocks", kInteger, State::Settled, nullptr},
    {"Render_Console", "what will be done, on the console", kFlag, State::Acts, set<&Settings::render_console>},
    {"Render_File", "keep what will be done in this file", kText, State::Acts, set<&Settings::render_file>},
    {"Render_Pattern", "order of the blocks", kInteger, State::Settled, nullptr},
    {"Sampling_Method", "kind of antialiasing, 1 to 3", kInteger, State::Acts,
     set_within<&Settings::sampling_method, 0, 3>},
    {"Shutter",
     "motion blur: share of the time to the next frame, or of a clock of 1, that a picture is exposed for; Whittle's "
     "own",
     kNumber, State::Acts, set_within<&Settings::shutter, 0, 100>},
    {"Split_Unions", "treat the parts of bounded unions one by one", kFlag, State::Acts, set<&Settings::split_unions>},
    {"Start_Column", "first column to render, counted from 1, or a share of the width", kNumber, State::Acts,
     set<&Settings::start_column>},
    {"Start_Row", "first row to render, counted from 1, or a share of the height", kNumber, State::Acts,
     set<&Settings::start_row>},
    {"Statistic_Console", "counts and times on the console", kFlag, State::Acts, set<&Settings::statistic_console>},
    {"Statistic_File", "keep counts and times in this file", kText, State::Acts, set<&Settings::statistic_file>},
    {"Stochastic_Seed", "other random places of the samples of antialiasing by method 3", kInteger, State::Acts,
     set<&Settings::stochastic_seed>},
    {"Subset_End_Frame", "last frame to render of the animation, or a share", kNumber, State::Acts,
     set<&Settings::subset_end_frame>},
    {"Subset_Start_Frame", "first frame to render of the animation, or a share", kNumber, State::Acts,
     set<&Settings::subset_start_frame>},
    {"Test_Abort", "look for a key that ends the render", kFlag, State::Settled, nullptr},
    {"Test_Abort_Count", "how often", kInteger, State::Settled, nullptr},
    {"User_Abort_Command", "command to run when the user ends the render", kText, State::Acts,
     set_command<Hook::UserAbort>},
    {"User_Abort_Return",
     "what its exit status does: I S A Q U F (ignore, skip, all, quit, abort, fail), - in front: a status of 0", kText,
     State::Acts, set_return<Hook::UserAbort>},
    {"Verbose", "show progress", kFlag, State::Acts, set<&Settings::verbose>},
    {"Version", "language version of a scene that names none", kNumber, State::Acts, set_version},
    {"Video_Mode", "mode of a display", kText, State::Settled, nullptr},
    {"Vista_Buffer", "vista buffer", kFlag, State::Settled, nullptr},
    {"Warning_Console", "warnings on the console", kFlag, State::Acts, set<&Settings::warning_console>},
    {"Warning_File", "keep warnings in this file", kText, State::Acts, set<&Settings::warning_file>},
    {"Warning_Level", "which warnings", kInteger, State::Settled, nullptr},
    {"Width", "columns of the picture", kInteger, State::Acts,
     [](Settings& s, const Value& v) { set_size(s.width, v.integer, "the width"); }},
    {"Work_Threads", "threads, 1 to 512; usual: one a core", kInteger, State::Acts, set_threads},
};

}  // namespace

std::span<const Option> option_table() { return kOptions; }

const Option* find_option(std::string_view keyword)
{
    const auto* found = std::find_if(std::begin(kOptions), std::end(kOptions),
                                     [&](const Option& o) { return same_text(o.keyword, keyword); });
    return found == std::end(kOptions) ? nullptr : found;
}

}  // namespace app
