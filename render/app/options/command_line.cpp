#include "render/app/options/command_line.h"

#include "render/app/options/ini_file.h"
#include "render/app/options/nearest.h"
#include "render/app/options/option_table.h"
#include "render/app/options/own_options.h"
#include "render/app/options/switch_table.h"
#include "render/app/base/text.h"

#include <filesystem>

namespace app {

namespace {

bool is_file(const std::string& name)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(name, ignored);
}

bool is_keyword_with_value(const std::string& word)
{
    const std::size_t equals = word.find('=');
    return equals != std::string::npos && equals > 0 && find_option(word.substr(0, equals)) != nullptr;
}

}  // namespace

std::vector<std::string> words_of(const std::string& argument)
{
    std::vector<std::string> words;
    std::string word;
    bool begun = false;
    char quote = 0;
    for (const char c : argument) {
        if (quote) {
            if (c == quote) quote = 0;
            else word += c;
        } else if (c == '"' || c == '\'') {
            quote = c;
            begun = true;
        } else if (is_blank(c)) {
            if (begun) words.push_back(std::move(word));
            word.clear();
            begun = false;
        } else {
            word += c;
            begun = true;
        }
    }
    if (begun) words.push_back(std::move(word));
    return words;
}

void apply_word(Settings& settings, const std::string& word)
{
    if (word.empty()) return;
    if (word == "-" || word == "+")
        throw OptionError("unknown switch '" + word + "': +I- reads the scene from standard input");
    if (word.starts_with("--")) {
        apply_own_option(settings, word, nullptr);
    } else if ((word[0] == '+' || word[0] == '-') && !(ends_with_text(word, ".pov") && is_file(word))) {
        apply_switch(settings, word);
    } else if (is_keyword_with_value(word)) {
        const std::size_t equals = word.find('=');
        set_option(settings, word.substr(0, equals), word.substr(equals + 1));
    } else if (ends_with_text(word, ".pov")) {
        set_option(settings, "Input_File_Name", word);
    } else if (word.back() == '/') {
        set_option(settings, "Library_Path", word);
    } else if (same_text(word, "/EXIT")) {
        // "Quit when done", as callers say it to POV-Ray's version with a window.
    } else if (word.find('=') != std::string::npos && !is_file(word)) {
        const std::string keyword = word.substr(0, word.find('='));
        throw OptionError("unknown option '" + keyword + "'" + nearest_keyword(keyword));
    } else if (!read_ini_file(settings, word)) {
        if (!is_file(word + ".pov")) throw OptionError("no INI file or scene is called '" + word + "'");
        set_option(settings, "Input_File_Name", word + ".pov");
    }
}

namespace {

/// A run renders one scene, the one that the last word names. One that a word before it named is told of; one of an INI
/// file is what a command line is there to replace.
class SceneWatch {
public:
    explicit SceneWatch(Settings& settings)
        : settings_(settings), scene_(settings.input_file), files_(settings.ini_files.size())
    {}
    void look()
    {
        if (settings_.input_file != scene_) {
            if (by_word_)
                settings_.notes.push_back("'" + scene_ + "' is not rendered: '" + settings_.input_file +
                                          "' follows it, and a run renders one scene");
            scene_ = settings_.input_file;
            by_word_ = files_ == settings_.ini_files.size();
        }
        files_ = settings_.ini_files.size();
    }

private:
    Settings& settings_;
    std::string scene_;
    std::size_t files_;
    bool by_word_ = false;
};

}  // namespace

void apply_command_line(Settings& settings, const std::vector<std::string>& arguments)
{
    SceneWatch scene(settings);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string& argument = arguments[i];
        if (is_file(argument) && ends_with_text(argument, ".pov")) {
            set_option(settings, "Input_File_Name",
                       argument);  // a name with blanks is one name if there is such a file
        } else if (argument.starts_with("--")) {
            const bool has_next = i + 1 < arguments.size();
            if (apply_own_option(settings, argument, has_next ? &arguments[i + 1] : nullptr)) ++i;
        } else {
            for (const std::string& word : words_of(argument)) {
                apply_word(settings, word);
                scene.look();
            }
        }
        scene.look();
    }
}

}  // namespace app
