#include "parser/lexer/lexer.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

struct Lexed {
    parser::Names names;
    parser::SourceFile file;
    explicit Lexed(std::string text)
    {
        file.path = "test.pov";
        file.text = std::move(text);
        parser::tokenize(file, 0, names, true);
    }
    std::string kinds() const
    {
        std::string all;
        for (const parser::Token& token : file.tokens) {
            if (token.kind == parser::Kind::EndOfText) break;
            if (!all.empty()) all += ' ';
            all += token.kind == parser::Kind::Bad ? "BAD" : std::string(file.token_text(token));
        }
        return all;
    }
};

}  // namespace

TEST_CASE("words, marks and comments", "[parser][lexer]")
{
    CHECK(Lexed("sphere{<0,1>2}").kinds() == "sphere { < 0 , 1 > 2 }");
    CHECK(Lexed("a>=b !=c <-1").kinds() == "a >= b != c < - 1");
    CHECK(Lexed("a/* b /* c */ still */d// e\rf").kinds() == "a d f");
    CHECK(Lexed(std::string("a\0b\x1a", 4) + "c").kinds() == "a b c");
    CHECK(Lexed("\xEF\xBB\xBFsphere").kinds() == "sphere");
    CHECK(Lexed("a \xE9 b").kinds() == "a BAD b");
}

TEST_CASE("numbers", "[parser][lexer]")
{
    const auto value = [](const char* text) { return Lexed(text).file.tokens.at(0).number; };
    CHECK(value("5.") == 5.0);
    CHECK(value(".5") == 0.5);
    CHECK(value("1e") == 1.0);
    CHECK(value("2e+") == 2.0);
    CHECK(value("1e999") == std::numeric_limits<double>::infinity());
    CHECK(value("0.1") == 0.1);
    CHECK(Lexed("0x10").kinds() == "0 x10");
    CHECK(Lexed("1.5.x").kinds() == "BAD x");
}

TEST_CASE("lines end in four ways", "[parser][lexer]")
{
    const Lexed text("a\nb\rc\r\nd\n\re");
    for (std::uint32_t i = 0; i < 5; ++i) CHECK(text.file.locate(text.file.tokens[i].offset).line == i + 1);
}

TEST_CASE("both spellings of a word are one kind", "[parser][lexer]")
{
    CHECK(parser::keyword_of("colour_map") == parser::Kind::ColorMap);
    CHECK(parser::keyword_of("Sphere") == parser::Kind::Identifier);
    CHECK(parser::spelling(parser::Kind::Torus) == "torus");
}

TEST_CASE("every standard include file is made of tokens", "[parser][lexer]")
{
    const char* const folder = "/usr/share/povray-3.7/include";
    if (!std::filesystem::is_directory(folder)) return;  // the package is optional
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".inc") continue;
        INFO(entry.path());
        std::ifstream in(entry.path(), std::ios::binary);
        std::ostringstream bytes;
        bytes << in.rdbuf();
        CHECK(Lexed(bytes.str()).file.bad.empty());
    }
}
