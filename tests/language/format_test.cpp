#include "language/format/format.h"
#include "parser/lexer/lexer.h"
#include "tests/support/share.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace fs = std::filesystem;
using language::format::formatted;

namespace {

/// Tokens as the parser reads them, one a line: the formatter's own comparison is not asked.
std::string tokens_of(const std::string& text)
{
    parser::SourceFile file;
    file.text = text;
    parser::Names names;
    parser::tokenize(file, 0, names, true);
    std::ostringstream out;
    out.precision(17);
    for (const parser::Token& token : file.tokens) {
        out << spelling(token.kind) << ' ' << token.number << ' ' << token.jump;
        const bool text_inside = token.kind == parser::Kind::String || token.kind == parser::Kind::Bad;
        if (text_inside) out << file.strings[token.name];
        else if (token.kind == parser::Kind::Identifier) out << names.word(token.name);
        else out << token.name;
        out << '\n';
    }
    for (const double number : file.numbers) out << number << ' ';
    return out.str();
}

std::string text_of(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Scenes and include files; one in `every`.
std::vector<fs::path> texts_below(const fs::path& folder, std::size_t every = 1)
{
    std::vector<fs::path> found;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
        const std::string extension = entry.path().extension().string();
        if (extension == ".pov" || extension == ".inc" || extension == ".mcr") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    std::vector<fs::path> taken;
    for (std::size_t i = 0; i < found.size(); i += every) taken.push_back(found[i]);
    return taken;
}

/// Lays out each file and compares. Returns how many were.
std::size_t check_all(const std::vector<fs::path>& texts)
{
    std::size_t done = 0;
    for (const fs::path& path : texts) {
        INFO(path);
        const std::string text = text_of(path);
        std::string once;
        try {
            once = formatted(text);
        } catch (const language::format::Refused& refused) {
            parser::SourceFile file;
            file.text = text;
            parser::Names names;
            parser::tokenize(file, 0, names, true, false);
            CHECK_FALSE(file.bad.empty());  // nothing else is a reason
            continue;
        }
        CHECK(tokens_of(once) == tokens_of(text));
        CHECK(formatted(once) == once);
        ++done;
    }
    return done;
}

}  // namespace

TEST_CASE("tokens of our scenes stay as they are", "[format]") { CHECK(check_all(texts_below(WHITTLE_SCENES)) > 200); }

TEST_CASE("tokens of POV-Ray's scenes and include files stay as they are", "[format]")
{
    for (const char* folder : {"/usr/share/doc/povray/examples", "/usr/share/povray-3.7/include"}) {
        if (!fs::exists(folder)) continue;
        const std::vector<fs::path> texts = texts_below(folder, test::kEvery);
        const std::size_t done = check_all(texts);
        INFO(folder << ": " << done << " of " << texts.size());
        CHECK(done + 3 >= texts.size());
    }
}

TEST_CASE("blanks", "[format]")
{
    const auto line = [](const std::string& text) {
        const std::string out = formatted(text);
        return out.substr(0, out.size() - 1);
    };
    CHECK(line("sphere{<0,-1,2>,1}") == "sphere { <0, -1, 2>, 1 }");
    CHECK(line("#if(clock<3&A>=2)#end") == "#if (clock < 3 & A >= 2) #end");
    CHECK(line("#declare  A =array [ 2 ]{ 1,2 } ;") == "#declare A = array[2] { 1, 2 };");
    CHECK(line("color_map{[0 rgb<1,1,1>][1 rgb 0]}") == "color_map { [0 rgb <1, 1, 1>] [1 rgb 0] }");
    CHECK(line("#declare B=A [1] [2]*3;") == "#declare B = A[1][2]*3;");
    CHECK(line("#declare B=2* 3-sin (x.y) ;") == "#declare B = 2 * 3-sin(x.y);");
    CHECK(line("rotate (1+2)*y") == "rotate (1+2)*y");
    CHECK(line("T <1 -2, - 3>") == "T <1 -2, -3>");
    CHECK(line("#declare A=.5;box{A .5}") == "#declare A = .5; box { A .5 }");
    CHECK(line("union{}") == "union {}");
    CHECK(line("#declare A = ! B ? - 1 : 2;") == "#declare A = !B ? -1 : 2;");
    CHECK(line("#debug concat(\"a\\\\\",\"// b\\\"\")") == "#debug concat(\"a\\\\\", \"// b\\\"\")");
    CHECK(line("#declare A = B/ /*why*/2;") == "#declare A = B / /*why*/2;");
}

TEST_CASE("indentation follows braces and directives", "[format]")
{
    CHECK(formatted(
              "#macro M(A)\nunion{\nsphere{0,1\nscale 2}\n#if(A)\nbox{0,1}\n#else\ncone{0,1,x,0}\n#end\n}\n#end\n") ==
          "#macro M(A)\n  union {\n    sphere { 0, 1\n      scale 2 }\n    #if (A)\n      box { 0, 1 }\n    #else\n"
          "      cone { 0, 1, x, 0 }\n    #end\n  }\n#end\n");
    CHECK(
        formatted("#switch(A)\n#case(1)\nbox{0,1}\n#break\n#else\nsphere{0,1}\n#end\nplane{y,0}") ==
        "#switch (A)\n  #case (1)\n    box { 0, 1 }\n    #break\n  #else\n    sphere { 0, 1 }\n#end\nplane { y, 0 }\n");
    // Both branches open the brace that is closed behind them.
    CHECK(formatted("#if(A)\nunion{\n#else\nmerge{\n#end\nbox{0,1}\n}\nplane{y,0}\n") ==
          "#if (A)\n  union {\n#else\n  merge {\n#end\n  box { 0, 1 }\n}\nplane { y, 0 }\n");
    CHECK(formatted("#declare A =\n3 +\n4;\nbox { <0,\n1, 2>, 1 }\n") ==
          "#declare A =\n  3 +\n  4;\nbox { <0,\n    1, 2>, 1 }\n");
    // A guard around an include file takes no level.
    CHECK(formatted("#ifndef(X_Inc)\n#declare X_Inc=1;\n#end\n") == "#ifndef (X_Inc)\n#declare X_Inc = 1;\n#end\n");
    CHECK(formatted("union{\nbox{0,1}\n}", {.indent = 4, .tabs = true}) == "union {\n\tbox { 0, 1 }\n}\n");
}

TEST_CASE("comments and line ends are kept", "[format]")
{
    CHECK(formatted("#declare A=1;  // a\n#declare Bcd=1;// b\n") ==
          "#declare A = 1;    // a\n#declare Bcd = 1;  // b\n");
    CHECK(formatted("#declare A=1;    // a\n#declare Bcd=1;  // b\n                 // c\n") ==
          "#declare A = 1;    // a\n#declare Bcd = 1;  // b\n                   // c\n");
    CHECK(formatted("/* a\n   b */\n\n\n\nbox{0,1}\r\n") == "/* a\n   b */\n\nbox { 0, 1 }\n");
    CHECK(formatted("box{0,1}  \r\n\r\nbox{0,2}// x  \r\n") == "box { 0, 1 }\r\n\r\nbox { 0, 2 }  // x\r\n");
    CHECK(formatted("// format off\nbox{0,1\n     }\n// format on\nbox{0,1}\n") ==
          "// format off\nbox{0,1\n     }\n// format on\nbox { 0, 1 }\n");
    CHECK(formatted("\xEF\xBB\xBF// ä\nbox{0,1}") == "\xEF\xBB\xBF// ä\nbox { 0, 1 }\n");
    CHECK(formatted("") == "");
}

TEST_CASE("long lines are broken at blocks and lists", "[format]")
{
    CHECK(formatted("union{sphere{0,1 pigment{rgb 1} rotate x}box{0,1 texture{T}}}\n", {.width = 50}) ==
          "union {\n  sphere { 0, 1 pigment { rgb 1 } rotate x }\n  box { 0, 1 texture { T } }\n}\n");
    CHECK(formatted("#declare A=array[8]{\n100000,200000,300000,400000,500000,600000,700000,800000\n}\n",
                    {.width = 40}) ==
          "#declare A = array[8] {\n  100000, 200000, 300000, 400000,\n  500000, 600000, 700000, 800000\n}\n");
}

TEST_CASE("what holds no tokens is refused with its place", "[format]")
{
    try {
        formatted("box { 0, 1 }\n/* open");
        FAIL("laid out");
    } catch (const language::format::Refused& refused) {
        CHECK(refused.offset == 13);
    }
    CHECK_THROWS_AS(formatted("#declare A = \"open"), language::format::Refused);
    CHECK_THROWS_AS(formatted("box { \x80 }"), language::format::Refused);
}

TEST_CASE("random texts are laid out or refused, and only once", "[format]")
{
    const char* const words[] = {"box",     "{",     "}",       "<",      ">",   "(",      ")",    "[",   "]",     ",",
                                 ";",       "#",     "if",      "else",   "end", "-",      "+",    "*",   "/",     "=",
                                 "!",       "&",     "?",       ":",      "A",   "1",      ".5",   "1e",  "x",     ".",
                                 "\"a b\"", "\n",    "\n",      "// c\n", " ",   "  ",     "case", "for", "while", "\t",
                                 "5.",      "macro", "/* k */", "@",      "$",   "switch", "B2",   "\r\n"};
    std::mt19937 rng(22);
    for (int round = 0; round < test::share(4000); ++round) {
        std::string text;
        for (std::size_t n = rng() % 60; n-- > 0;) text += words[rng() % std::size(words)];
        INFO("round " << round << ": " << text);
        std::string once;
        try {
            once = formatted(text, {.width = 40});
        } catch (const language::format::Refused& refused) {
            REQUIRE(std::string(refused.what()).find("cannot be laid out") == std::string::npos);
            continue;
        }
        REQUIRE(tokens_of(once) == tokens_of(text));
        REQUIRE(formatted(once, {.width = 40}) == once);
    }
}
