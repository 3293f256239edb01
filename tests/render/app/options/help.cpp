// The texts about options are made of the tables that options are read with: nothing is missing in any of them.
#include "render/app/options/help.h"

#include "render/app/options/option_table.h"
#include "render/app/options/own_options.h"
#include "render/app/options/switch_table.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <sstream>

using namespace app;

namespace {

using Words = std::vector<std::string>;

/// The word stands in the text with nothing of a name before or behind it.
bool has_name(const std::string& text, const std::string& name)
{
    const auto part_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !part_of_name(text[at - 1])) && (end == text.size() || !part_of_name(text[end]))) return true;
    }
    return false;
}

std::string roff(std::string text)
{
    for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\-");
    return text;
}

/// What bash offers for a line that ends at the cursor.
std::vector<std::string> offered(const std::string& line)
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "completion", bash_completion());
    support::write_text(folder / "scene.pov", "");
    support::write_text(folder / "text.txt", "");
    support::write_text(
        folder / "try.sh",
        "source ./completion\nCOMP_LINE='" + line +
            "' COMP_POINT=${#COMP_LINE}\n_whittle\nfor word in \"${COMPREPLY[@]}\"; do echo \"$word\"; done\n");
    std::istringstream lines(support::run_program(folder.path(), "/bin/bash", {"try.sh"}).out);
    std::vector<std::string> words;
    for (std::string word; std::getline(lines, word);) words.push_back(word);
    return words;
}

}  // namespace

TEST_CASE("help, manual page and completion name every option", "[app][help]")
{
    const std::string help = help_text(), page = manual_page();
    const std::string completion = GENERATE(bash_completion(), zsh_completion());
    for (const Option& option : option_table()) {
        const std::string keyword(option.keyword);
        INFO(keyword);
        const bool wanted = option.state != State::Obsolete;
        CHECK(has_name(help, keyword) == wanted);
        CHECK(has_name(page, keyword) == wanted);
        CHECK(has_name(completion, keyword + "=") == wanted);
        CHECK_FALSE(option.meaning.empty());
    }
    for (const OwnOption& option : own_options()) {
        const std::string name = "--" + std::string(option.name);
        INFO(name);
        CHECK(has_name(help, name));
        CHECK(has_name(page, roff(name)));
        CHECK(has_name(completion, name));
        CHECK_FALSE(option.meaning.empty());
    }
    for (const Switch& one : switch_table()) {
        const SwitchText shown = text_of(one);
        INFO(one.letters);
        if (shown.form.empty()) continue;
        CHECK(help.find("\n  " + shown.form + " ") != std::string::npos);
        CHECK(page.find("\n.B " + roff(shown.form) + "\n") != std::string::npos);
        CHECK(has_name(completion, std::string("+") + one.letters));
    }
    for (const ExitStatus& status : kExitStatuses) {
        CHECK(help.find(status.meaning) != std::string::npos);
        CHECK(page.find(roff(status.meaning)) != std::string::npos);
    }
}

TEST_CASE("each of Whittle's own options is understood as the texts show it", "[app][help]")
{
    for (const OwnOption& option : own_options()) {
        if (!option.apply) continue;
        Settings settings;
        const std::string name = "--" + std::string(option.name);
        std::string value(option.value.substr(0, option.value.find('|')));
        if (value == "I/N") value = "3/16";
        if (value == "SECONDS" || value == "MB" || value == "LEVELS" || value == "N" || value == "N or N%" ||
            value == "LIST")
            value = "3";
        INFO(name);
        if (option.value_may_lack) {  // only behind '='
            CHECK_FALSE(apply_own_option(settings, name, nullptr));
            CHECK_FALSE(apply_own_option(settings, name, &value));
            CHECK_FALSE(apply_own_option(settings, name + "=" + value, nullptr));
        } else if (value.empty()) {
            CHECK_FALSE(apply_own_option(settings, name, &value));
            CHECK_THROWS_AS(apply_own_option(settings, name + "=x", nullptr), OptionError);
        } else {
            CHECK_FALSE(apply_own_option(settings, name + "=" + value, nullptr));
            CHECK(apply_own_option(settings, name, &value));
            CHECK_THROWS_AS(apply_own_option(settings, name, nullptr), OptionError);
        }
    }
}

TEST_CASE("bash completes options, their values, switches, keywords and scenes", "[app][help]")
{
    CHECK(offered("whittle --qu") == Words{"--quiet"});
    CHECK(offered("whittle x.pov --dump=s") == Words{"scene"});  // '=' begins a new word for bash
    CHECK(offered("whittle sc") == Words{"scene.pov"});
    CHECK(offered("whittle te").empty());
    CHECK(offered("whittle +Isc") == Words{"+Iscene.pov"});
    CHECK(offered("whittle Antialias_T") == Words{"Antialias_Threshold="});
    CHECK(offered("whittle +SC") == Words{"+SC"});
    CHECK(offered("povray Input_File_Name=sc") == Words{"scene.pov"});
}

TEST_CASE("no switch is explained by itself", "[app][help]")
{
    for (const Switch& one : switch_table()) {
        const SwitchText shown = text_of(one);
        INFO(shown.form << ": " << shown.meaning);
        CHECK((shown.form.empty() || shown.meaning.find(shown.form) == std::string_view::npos));
    }
}
