#include "parser/lexer/lexer.h"
#include "parser/parse.h"
#include "tests/support/share.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

// Scenes of scenes/ with a few tokens or bytes changed reach deep into the grammar, where texts of random tokens end at
// the first rule. Whatever comes out is a description or an Error.

namespace {

constexpr auto kTexts = static_cast<std::uint32_t>(test::share(30'000));

/// A scene as its tokens' text; blanks and comments stay with the token before them.
using Pieces = std::vector<std::string>;

Pieces pieces_of(const std::string& text)
{
    parser::SourceFile file;
    file.text = text;
    parser::Names names;
    parser::tokenize(file, 0, names, true);
    Pieces pieces;
    for (std::size_t i = 0; i + 1 < file.tokens.size(); ++i) {
        const std::uint32_t begin = i == 0 ? 0 : file.tokens[i].offset;
        pieces.push_back(text.substr(begin, file.tokens[i + 1].offset - begin));
    }
    return pieces;
}

std::vector<Pieces> corpus()
{
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(WHITTLE_SCENES))
        if (entry.path().extension() == ".pov") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());  // a seed means the same text everywhere
    std::vector<Pieces> scenes;
    for (const auto& path : paths) {
        std::ifstream in(path, std::ios::binary);
        scenes.push_back(pieces_of({std::istreambuf_iterator<char>(in), {}}));
        REQUIRE_FALSE(scenes.back().empty());
    }
    return scenes;
}

class Mutator {
public:
    Mutator(const std::vector<Pieces>& scenes, std::uint32_t seed) : scenes_(scenes), random_(seed) {}

    std::string text()
    {
        Pieces scene = scenes_[below(scenes_.size())];
        for (std::size_t changes = 1 + below(10) / 6; changes > 0; --changes) change(scene);
        std::string all;
        for (const std::string& piece : scene) all += piece;
        if (below(8) == 0 && !all.empty()) all[below(all.size())] = static_cast<char>(random_());
        if (below(16) == 0) all.resize(below(all.size() + 1));
        return all;
    }

private:
    std::size_t below(std::size_t count) { return random_() % count; }

    void change(Pieces& scene)
    {
        static constexpr std::array kOddNumbers{"0 ",    "-1 ",    "1e308 ",   "1e-320 ",
                                                "-1e9 ", "(0/1) ", "<0,0,0> ", "3.7 "};
        static constexpr std::array kOddTokens{"\"\" ", "#end ", "} ", "{ ", "( ", "x ", "<1,2,3,4,5> ", "rgbft "};
        if (scene.empty()) return;
        const std::size_t at = below(scene.size());
        const auto place = scene.begin() + static_cast<std::ptrdiff_t>(at);
        const auto run = static_cast<std::ptrdiff_t>(std::min(scene.size() - at, 1 + below(6)));
        switch (below(8)) {
        case 0: scene.erase(place); break;
        case 1: scene.erase(place, place + run); break;
        case 2: {
            const Pieces copy(place, place + run);
            scene.insert(place, copy.begin(), copy.end());
            break;
        }
        case 3: std::swap(*place, scene[below(scene.size())]); break;
        case 4: *place = kOddTokens[below(kOddTokens.size())]; break;
        case 5: {
            const auto number = std::find_if(place, scene.end(), is_number);
            if (number != scene.end()) *number = kOddNumbers[below(kOddNumbers.size())];
            break;
        }
        default: insert_item(scene, at);
        }
    }

    static bool is_number(const std::string& piece) { return piece[0] >= '0' && piece[0] <= '9'; }
    static bool is_brace(const std::string& piece) { return piece[0] == '{' || piece[0] == '}'; }

    /// `word { ... }` of another scene goes where items stand: behind the next brace.
    void insert_item(Pieces& scene, std::size_t at)
    {
        const Pieces& other = scenes_[below(scenes_.size())];
        const auto begin = other.begin() + static_cast<std::ptrdiff_t>(below(other.size()));
        const auto place = std::find_if(scene.begin() + static_cast<std::ptrdiff_t>(at), scene.end(), is_brace);
        const auto open = std::find_if(begin, other.end(), [](const std::string& piece) { return piece[0] == '{'; });
        if (place == scene.end() || open == other.end() || open == other.begin()) return;
        auto end = open;
        int depth = 0;
        do {
            if (is_brace(*end)) depth += (*end)[0] == '{' ? 1 : -1;
            ++end;
        } while (depth > 0 && end != other.end());
        scene.insert(place + 1, open - 1, end);
    }

    const std::vector<Pieces>& scenes_;
    std::mt19937 random_;
};

}  // namespace

TEST_CASE("no change of tokens or bytes makes a scene crash the parser", "[parser][fuzz]")
{
    const std::vector<Pieces> scenes = corpus();
    REQUIRE(scenes.size() >= 40);
    parser::Options options;
    options.most_tokens = 40'000;  // a changed loop may have no end
    int accepted = 0, refused = 0;
    for (std::uint32_t seed = 0; seed < kTexts; ++seed) {
        INFO("seed " << seed);
        const std::string text = Mutator(scenes, seed).text();
        try {
            parser::parse_text(text, "changed.pov", options);
            ++accepted;
        } catch (const parser::Error& error) {
            CHECK_FALSE(std::string(error.what()).empty());
            ++refused;
        }
    }
    // Both outcomes are common, or the changes are too mild or too wild to find anything.
    CHECK(accepted > static_cast<int>(kTexts / 20));
    CHECK(refused > static_cast<int>(kTexts / 20));
}

TEST_CASE("a loop without end is stopped where a limit of tokens is set", "[parser]")
{
    parser::Options options;
    options.most_tokens = 1000;
    for (const char* text :
         {"#while (1) #end", "#while (1) sphere { 0 1 } #end", "#macro M() M() #end M()", "#for (I, 0, 1e9) #end"})
        CHECK_THROWS_AS(parser::parse_text(text, "loop.pov", options), parser::Error);
}
