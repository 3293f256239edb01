#include "tests/parser/stream_support.h"

#include "parser/stream/expression.h"

#include <catch2/catch.hpp>

#include <random>

namespace {

/// Reads expressions and plain tokens until the text ends or is refused.
void drive(const std::string& text)
{
    parser_test::NoGrammar grammar;
    parser::TokenStream stream({}, grammar);
    try {
        stream.open_text(text, "fuzz.pov");
        constexpr int kMostTokens = 2000;  // a loop without end must end here
        for (int i = 0; i < kMostTokens && stream.peek().kind != parser::Kind::EndOfText; ++i) {
            if (parser::at_expression(stream)) parser::untyped_expr(stream, parser::Level::Full);
            else stream.next();
        }
    } catch (const parser::Error&) {}
}

}  // namespace

TEST_CASE("no bytes crash lexer or stream", "[parser][fuzz]")
{
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        std::mt19937 random(seed);
        std::string text(random() % 200, ' ');
        for (char& c : text) c = static_cast<char>(random());
        drive(text);
    }
}

TEST_CASE("no tokens crash the stream", "[parser][fuzz]")
{
    // No #while and no #for: those may loop for ever without a token, as the language allows.
    static const char* const kPieces[] = {
        "#if(",  "#else",    "#elseif(", "#end",    "#macro M(", "#declare", "#local",   "#undef",     "A",
        "B",     "M",        "(",        ")",       "[",         "]",        "<",        ">",          "{",
        "}",     "=",        ";",        ",",       "1",         "0.5",      "+",        "-",          "*",
        "/",     "\"s\"",    "str(",     "concat(", "array",     "function", "x",        "t",          "rgb",
        "color", "#switch(", "#case(",   "#break",  "?",         ":",        "&",        "|",          ".",
        "sin(",  "rand(",    "seed(",    "vstr(",   "#ifdef(",   "#range(",  "defined(", "min(",       "#version",
        "3.7",   "M(",       "!",        "#debug",  "#include",  "select(",  "sphere",   "dimensions("};
    for (std::uint32_t seed = 0; seed < 20000; ++seed) {
        INFO("seed " << seed);
        std::mt19937 random(seed);
        std::string text = "#declare A=1; #declare B=array[2]{1,2} #macro M(p) p #end ";
        for (auto n = random() % 40; n > 0; --n) text += std::string(kPieces[random() % std::size(kPieces)]) + ' ';
        drive(text);
    }
}
