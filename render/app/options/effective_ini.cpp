#include "render/app/options/effective_ini.h"

#include "render/app/options/option_table.h"
#include "render/app/base/text.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace app {

namespace {

std::string as_value(const Option& option, const std::string& text)
{
    if (option.kind == ValueKind::Flag) return truth_of(text) ? "On" : "Off";
    if (option.keyword == "Output_File_Type") return std::string(1, upper_case(text.empty() ? 'N' : text[0]));
    if (option.kind == ValueKind::Integer) return std::to_string(std::strtol(text.c_str(), nullptr, 10));
    if (option.kind == ValueKind::Number) return fmt::format("{:g}", std::strtof(text.c_str(), nullptr));
    if (option.keyword == "Palette" || option.keyword == "Video_Mode") return text;  // one character
    // A declaration carries its own quotes; a command is taken as it stands.
    if (option.kind != ValueKind::Text || option.keyword == "Declare" || option.keyword.ends_with("_Command"))
        return text;
    const char quote = text.find('"') == std::string::npos ? '"' : '\'';
    return quote + text + quote;
}

}  // namespace

std::string ini_line(const Option& option, const std::string& text)
{
    return std::string(option.keyword) + "=" + as_value(option, text);
}

std::string effective_ini(const Settings& settings)
{
    std::string ini;
    for (const Option& option : option_table()) {
        const auto given = settings.given.find(option.keyword);
        if (given == settings.given.end() || option.keyword == "Include_Ini") continue;
        for (const std::string& text : given->second) ini += ini_line(option, text) + "\n";
    }
    return ini;
}

void write_effective_ini(const Settings& settings)
{
    const std::string& name = settings.create_ini;
    if (name.empty() || same_text(name, "off") || same_text(name, "false") || same_text(name, "no")) return;
    std::string path = name;
    if (same_text(name, "on") || same_text(name, "true") || same_text(name, "yes"))
        path = std::filesystem::path(settings.input_file).replace_extension(".ini").string();
    std::ofstream out(path, std::ios::binary);
    out << effective_ini(settings);
    if (!out.flush()) throw OptionError("cannot write '" + path + "'");
}

}  // namespace app
