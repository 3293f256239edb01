#include "render/app/options/ini_file.h"

#include "render/app/options/command_line.h"
#include "render/app/base/library_path.h"
#include "render/app/options/nearest.h"
#include "render/app/options/option_table.h"
#include "render/app/base/text.h"
#include "render/files/whole_file.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace app {

namespace {

/// INI files that name INI files end somewhere.
constexpr int kMostNested = 32;

/// Up to an unquoted `;` or `#`.
std::string_view without_comment(std::string_view line)
{
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == ';' || c == '#') {
            return line.substr(0, i);
        }
    }
    return line;
}

/// Values between unquoted commas, without their quotes.
std::vector<std::string> values_of(std::string_view text)
{
    std::vector<std::string> values(1);
    char quote = 0;
    for (const char c : text) {
        if (quote) {
            if (c == quote) quote = 0;
            else values.back() += c;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == ',') {
            values.emplace_back();
        } else {
            values.back() += c;
        }
    }
    for (std::string& value : values) value = std::string(trimmed(value));
    return values;
}

void apply_line(Settings& settings, std::string_view line)
{
    const std::size_t equals = line.find('=');
    const bool is_switch = line[0] == '+' || line[0] == '-';
    if (is_switch || equals == std::string_view::npos) {
        for (const std::string& word : words_of(std::string(line))) apply_word(settings, word);
        return;
    }
    const std::string_view keyword = trimmed(line.substr(0, equals));
    const Option* option = find_option(keyword);
    if (option && option->state == State::Obsolete) {
        settings.notes.push_back(std::string(option->keyword) + " is obsolete and has no effect");
        return;
    }
    const std::string_view text = line.substr(equals + 1);
    if (keyword.ends_with("_Command") || same_text(keyword, "Declare")) {
        // A command is taken as it stands; a declared string keeps its quotes.
        return set_option(settings, keyword, std::string(trimmed(text)));
    }
    for (const std::string& value : values_of(text)) set_option(settings, keyword, value);
}

/// Sizes that editors ask for by the name of an INI file of POV-Ray's distribution, where that is not installed.
const char* known_text(std::string_view name)
{
    if (name.ends_with(".ini")) name.remove_suffix(4);
    constexpr std::pair<std::string_view, const char*> kKnown[] = {
        {"res120", "Width=120\nHeight=90\n"},  {"res320", "Width=320\nHeight=200\n"},
        {"res640", "Width=640\nHeight=480\n"}, {"res800", "Width=800\nHeight=600\n"},
        {"res1k", "Width=1024\nHeight=768\n"},
    };
    for (const auto& [known, text] : kKnown)
        if (name == known) return text;
    return nullptr;
}

std::string found_file(const Settings& settings, const std::string& name)
{
    std::error_code ignored;
    std::vector<std::string> folders{""};
    for (const std::string& folder : settings.library_path) folders.push_back(folder + "/");
    for (const std::string& folder : default_library_path()) folders.push_back(folder + "/");
    const bool has_extension = !std::filesystem::path(name).extension().empty();
    for (const std::string& folder : folders) {
        if (has_extension && std::filesystem::is_regular_file(folder + name, ignored)) return folder + name;
        for (const char* extension : {".ini", ".INI"})
            if (std::filesystem::is_regular_file(folder + name + extension, ignored)) return folder + name + extension;
    }
    return {};
}

}  // namespace

void apply_ini_text(Settings& settings, const std::string& text, const std::string& section,
                    const std::string& file_name)
{
    thread_local int nested = 0;
    struct Level {
        Level() { ++nested; }
        ~Level() { --nested; }
    } level;
    if (nested > kMostNested) throw OptionError(file_name + ": INI files name each other without end");
    bool applies = true, found = section.empty();
    std::vector<std::string> sections;
    int number = 0;
    for (const std::string_view line : pieces_of(text, '\n')) {
        ++number;
        const std::string_view content = trimmed(without_comment(line));
        if (content.empty()) continue;
        if (content.front() == '[') {
            sections.emplace_back(trimmed(content.substr(1, content.find(']') - 1)));
            applies = !section.empty() && same_text(sections.back(), section);
            found |= applies;
            continue;
        }
        if (!applies) continue;
        try {
            apply_line(settings, content);
        } catch (const OptionError& error) {
            throw OptionError(file_name + ":" + std::to_string(number) + ": " + error.what());
        }
    }
    if (!found)
        throw OptionError(file_name + ": there is no section [" + section + "]" + did_you_mean(section, sections));
}

namespace {

/// False if it cannot be read.
bool read_path(Settings& settings, const std::string& path, const std::string& section)
{
    const std::optional<std::string> text = files::whole_file_if(path);
    if (!text) return false;
    if (std::find(settings.ini_files.begin(), settings.ini_files.end(), path) == settings.ini_files.end())
        settings.ini_files.push_back(path);
    apply_ini_text(settings, *text, section, path);
    return true;
}

}  // namespace

bool read_ini_file(Settings& settings, const std::string& name)
{
    const std::size_t bracket = name.ends_with(']') ? name.rfind('[') : std::string::npos;
    const std::string section = bracket == std::string::npos ? "" : name.substr(bracket + 1, name.size() - bracket - 2);
    const std::string path = found_file(settings, name.substr(0, bracket));
    if (path.empty()) {
        const char* text = known_text(name);
        if (text) apply_ini_text(settings, text, section, name);
        return text != nullptr;
    }
    return read_path(settings, path, section);
}

void read_default_ini_file(Settings& settings)
{
    const int usual_width = settings.width, usual_height = settings.height;
    settings.width = 160;  // POV-Ray's, which any INI file overrides
    settings.height = 120;
    if (const char* given = std::getenv("POVINI")) {
        if (read_ini_file(settings, given)) return;
        settings.notes.push_back(std::string("the INI file of POVINI cannot be read: ") + given);
    }
    if (read_path(settings, "povray.ini", "")) return;
    const char* home = std::getenv("HOME");
    if (home && read_path(settings, std::string(home) + "/.povray/3.7/povray.ini", "")) return;
    if (read_path(settings, "/etc/povray/3.7/povray.ini", "")) return;
    if (home && read_path(settings, std::string(home) + "/.povrayrc", "")) return;
    settings.width = usual_width;  // as in the INI file that Debian installs
    settings.height = usual_height;
}

}  // namespace app
