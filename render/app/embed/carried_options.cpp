#include "render/app/embed/carried_options.h"

#include "render/app/embed/carried.h"
#include "render/app/options/effective_ini.h"
#include "render/app/options/option_table.h"
#include "render/app/views/views.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace app {
namespace {

constexpr std::string_view kKeywords[] = {"Antialias",
                                          "Antialias_Confidence",
                                          "Antialias_Depth",
                                          "Antialias_Gamma",
                                          "Antialias_Threshold",
                                          "Bits_Per_Color",
                                          "Bits_Per_Colour",
                                          "Clock",
                                          "Compression",
                                          "Cyclic_Animation",
                                          "Declare",
                                          "Display_Gamma",
                                          "Dither",
                                          "Dither_Method",
                                          "End_Column",
                                          "End_Row",
                                          "File_Gamma",
                                          "Final_Clock",
                                          "Final_Frame",
                                          "Frame_Step",
                                          "Grayscale_Output",
                                          "Greyscale_Output",
                                          "Height",
                                          "Initial_Clock",
                                          "Initial_Frame",
                                          "Jitter",
                                          "Jitter_Amount",
                                          "Motion_Samples",
                                          "Output_Alpha",
                                          "Output_File_Type",
                                          "Quality",
                                          "Radiosity_From_File",
                                          "Render_Block_Size",
                                          "Sampling_Method",
                                          "Shutter",
                                          "Split_Unions",
                                          "Start_Column",
                                          "Start_Row",
                                          "Stochastic_Seed",
                                          "Version",
                                          "Width",
                                          "Work_Threads"};
constexpr std::string_view kFileKeywords[] = {"Include_Header", "Input_File_Name", "Library_Path",
                                              "Radiosity_File_Name"};
constexpr std::string_view kOwn[] = {"denoise",    "embed",         "error",   "faithful", "frames",
                                     "integrator", "no-extensions", "no-lean", "povray",   "samples",
                                     "seed",       "time",          "views"};

template <class Names>
bool has(const Names& names, std::string_view name)
{
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool plain(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '.' || c == '_' ||
           c == '+' || c == '-' || c == '%' || c == ',' || c == ':' || c == '=';
}

/// Numbers with all of their digits: an INI file of Create_Ini has six, as POV-Ray's.
std::string whole_line(const Option& option, const std::string& text)
{
    const bool number = option.kind == ValueKind::Number || option.kind == ValueKind::Integer;
    if (!number || text.empty() || !std::all_of(text.begin(), text.end(), plain)) return ini_line(option, text);
    return std::string(option.keyword) + "=" + text;
}

/// A name from that folder leads to something that was taken out, by whatever steps up.
bool stays_inside(const std::string& folder, std::string_view name)
{
    if (name.starts_with('/')) return false;
    const std::string whole = (std::filesystem::path(folder) / name).lexically_normal().string();
    return is_inner_name(whole) || (name == "." && !folder.empty());
}

}  // namespace

std::string file_option(const char* keyword, const std::string& name, const std::string& folder)
{
    const std::filesystem::path from = folder.empty() ? "." : folder;
    return fmt::format("{}=\"{}\"", keyword, std::filesystem::path(name).lexically_relative(from).string());
}

std::vector<std::string> picture_options(const Settings& settings, const int* frame)
{
    std::vector<std::string> lines{fmt::format("Width={}", settings.width), fmt::format("Height={}", settings.height)};
    for (const Option& option : option_table()) {
        const auto given = settings.given.find(option.keyword);
        const std::string_view keyword = option.keyword;
        if (given == settings.given.end() || !has(kKeywords, keyword) || keyword == "Width" || keyword == "Height")
            continue;
        if (keyword == "Work_Threads" && !settings.faithful) continue;  // it changes no byte
        for (const std::string& text : given->second) lines.push_back(whole_line(option, text));
    }
    for (const std::string& word : settings.given_own) {
        const std::string_view name = std::string_view(word).substr(2, word.find('=') - 2);
        if (name == "views" && !is_view_words(settings.views)) continue;  // a file
        if (has(kOwn, name) && !(name == "frames" && frame)) lines.push_back(word);
    }
    if (frame) lines.push_back(fmt::format("--frames={}", *frame));
    return lines;
}

bool may_bring(const std::string& line, const std::string& folder)
{
    if (std::any_of(line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; })) return false;
    if (line.starts_with("--"))
        return has(kOwn, std::string_view(line).substr(2, line.find('=') - 2)) &&
               std::all_of(line.begin(), line.end(), plain);
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) return false;
    const std::string_view keyword = std::string_view(line).substr(0, equals),
                           value = std::string_view(line).substr(equals + 1);
    if (has(kFileKeywords, keyword))
        return value.size() > 2 && value.front() == '"' && value.back() == '"' &&
               stays_inside(folder, value.substr(1, value.size() - 2));
    if (!has(kKeywords, keyword)) return false;
    if (keyword == "Declare") return true;  // taken as it stands, whatever it is
    if (value.size() > 1 && value.front() == '"' && value.back() == '"')
        return std::all_of(value.begin() + 1, value.end() - 1, plain);
    return std::all_of(value.begin(), value.end(), plain);
}

}  // namespace app
