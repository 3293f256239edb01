#include "parser/parse.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// data/warnings.txt: scenes, options, and how many warnings POV-Ray 3.7 gives.
namespace {

struct Scene {
    std::string text;
    std::vector<std::string> words;  // of the options
    std::size_t warnings = 0;
};

std::vector<Scene> scenes()
{
    std::ifstream in(WHITTLE_TEST_DATA "/warnings.txt");
    std::vector<Scene> all;
    for (std::string line; std::getline(in, line);) {
        if (line == "---") {
            std::getline(in, line);
            std::istringstream answer(line);
            answer >> all.emplace_back().warnings;
            for (std::string word; answer >> word;) all.back().words.push_back(word);
        } else if (!all.empty()) {
            all.back().text += line + '\n';
        }
    }
    return all;
}

parser::Options options_of(const Scene& scene, const support::TemporaryFolder& folder)
{
    parser::Options options;
    options.library_path = {folder.path()};
    for (const std::string& word : scene.words) {
        if (word.starts_with("+HI")) options.include_header = word.substr(3);
        if (!word.starts_with("+MV")) continue;
        options.version_given = true;
        options.version = static_cast<int>(100.0 * std::stod(word.substr(3)) + 0.5);
    }
    return options;
}

}  // namespace

TEST_CASE("as many warnings as POV-Ray gives", "[parser][warnings]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "version.inc", "#version 3.7;\n");
    support::write_text(folder / "sphere.inc", "sphere{0,1}\n");
    const std::vector<Scene> all = scenes();
    CHECK(all.size() >= 40);
    for (const Scene& scene : all) {
        INFO(scene.text);
        const parser::Result result = parser::parse_text(scene.text, "t.pov", options_of(scene, folder));
        std::string told;
        for (const parser::Message& message : result.messages) {
            CHECK(message.severity == parser::Severity::Warning);
            CHECK(message.source.somewhere());
            told += message_text(message) + '\n';
        }
        INFO(told);
        CHECK(result.messages.size() == scene.warnings);
    }
}
