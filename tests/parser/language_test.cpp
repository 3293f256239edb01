#include "parser/parse.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// data/language.txt: scenes of a line or two, and what POV-Ray 3.7 does with them.
namespace {

struct Case {
    std::string text, debug;
    bool raw = false, accepted = true;
    int line = 0;  // that POV-Ray names; 0: it names none, or another than the mistake's
};

std::vector<Case> cases()
{
    std::ifstream in(WHITTLE_TEST_DATA "/language.txt");
    std::vector<Case> all;
    bool verdict = false;
    for (std::string line; std::getline(in, line);) {
        if (line == "---") {
            all.emplace_back();
            verdict = true;
        } else if (all.empty()) {
            continue;
        } else if (verdict) {
            Case& one = all.back();
            one.raw = line.rfind("raw ", 0) == 0;
            if (one.raw) line = line.substr(4);
            one.accepted = line == "accept";
            if (line.size() > 7 && !one.accepted) one.line = std::stoi(line.substr(7));
            verdict = false;
        } else if (line.rfind("> ", 0) == 0) {
            all.back().debug += line.substr(2) + '\n';
        } else {
            all.back().text += line + '\n';
        }
    }
    return all;
}

std::string trimmed(std::string text)
{
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

}  // namespace

TEST_CASE("what POV-Ray accepts and rejects, and what it prints", "[parser][language]")
{
    const std::string prologue = "#version 3.7; global_settings{assumed_gamma 1} sphere{0,1}\n";
    const std::vector<Case> all = cases();
    CHECK(all.size() > 800);
    for (std::size_t i = 0; i < 2 * all.size(); ++i) {
        const Case& one = all[i / 2];
        parser::Options options;
        options.blocks = i % 2 == 0;
        INFO(one.text << (options.blocks ? "" : " read word by word"));
        std::string debug, error;
        try {
            const parser::Result result =
                parser::parse_text((one.raw ? "" : prologue) + trimmed(one.text), "t.pov", options);
            for (const parser::Message& message : result.messages)
                if (message.severity == parser::Severity::Debug) debug += message.text;
        } catch (const parser::Error& failed) {
            error = failed.what();
        }
        INFO(error);
        CHECK(error.empty() == one.accepted);
        if (one.accepted) CHECK(trimmed(debug) == trimmed(one.debug));
        else if (one.line > 0)
            CHECK(error.rfind("t.pov:" + std::to_string(one.line + (one.raw ? 0 : 1)) + ":", 0) == 0);
    }
}

TEST_CASE("every standard include file can be included", "[parser][language]")
{
    const std::filesystem::path folder = "/usr/share/povray-3.7/include";
    if (!std::filesystem::is_directory(folder)) return;  // the package is optional
    parser::Options options;
    options.library_path = {folder.string()};
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".inc") continue;
        INFO(entry.path());
        // Some ask for these two, as their own texts say.
        const std::string text = "#version 3.7; global_settings { assumed_gamma 1 } #include \"colors.inc\" #include "
                                 "\"shapes.inc\" #include \"" +
                                 entry.path().filename().string() + "\" sphere { 0, 1 }";
        CHECK_NOTHROW(parser::parse_text(text, "test.pov", options));
    }
}
