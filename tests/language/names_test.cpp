#include "language/names/symbol.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>

using namespace language;

namespace {

/// Texts of an editor, by name; nothing is on disk.
Files files_with(std::initializer_list<std::pair<const char*, const char*>> texts)
{
    Files files({});
    for (const auto& [path, text] : texts) files.open(path, text);
    return files;
}

/// The byte at which the n-th `word` of a text begins, from 1.
std::uint32_t nth(Files& files, const std::string& path, const std::string& word, int n)
{
    const std::string& text = files.text(path);
    std::size_t at = text.find(word);
    while (--n > 0) at = text.find(word, at + 1);
    REQUIRE(at != std::string::npos);
    return static_cast<std::uint32_t>(at);
}

/// "path:byte path:byte ..." of all places of the name there.
std::string places(Files& files, const std::string& path, std::uint32_t at)
{
    const auto symbol = symbol_at(*files.find(path), at);
    if (!symbol) return "none";
    std::string out;
    for (const At& one : places_of(files, *symbol)) out += one.path + ":" + std::to_string(one.range.begin) + " ";
    return out;
}

std::string declared(Files& files, const std::string& path, std::uint32_t at)
{
    const auto symbol = symbol_at(*files.find(path), at);
    const auto found = symbol ? declaration_of(files, *symbol, at) : std::nullopt;
    return found ? found->at().path + ":" + std::to_string(found->at().range.begin) : "none";
}

}  // namespace

TEST_CASE("brackets find their partners, whatever stands between", "[names]")
{
    const Document document("/a", "union { box { 0, (1 } sphere { <0, f(1)> } ]");
    std::string out;
    for (std::size_t at = 0; at < document.tokens().size(); ++at)
        if (document.partner(at) != kNone) out += std::to_string(at) + "-" + std::to_string(document.partner(at)) + " ";
    // union { box { 0 , ( 1 } sphere { < 0 , f ( 1 ) > } ]  : the '(' and the first '{' stay alone
    CHECK(out == "3-8 8-3 10-19 15-17 17-15 19-10 ");
    CHECK(document.open_brace(21) == 1);
    CHECK(document.open_brace(14) == 3);
    CHECK(document.open_brace(3) == kNone);
}

TEST_CASE("comments are found, and no text is one", "[names]")
{
    const auto ranges = [](const char* text) {
        std::string out;
        for (const Range& one : comments_of(Document("/a", text)))
            out += std::to_string(one.begin) + "-" + std::to_string(one.end) + " ";
        return out;
    };
    CHECK(ranges("a // b\nc") == "2-6 ");
    CHECK(ranges("/* a /* b */ c */ d // e") == "0-17 20-24 ");
    CHECK(ranges("\"// no\" / 2 /* open") == "12-19 ");
    CHECK(ranges("mesh { triangle { <0,0,0>,<1,0,0>,<0,1,0> } /* in */ }") == "44-52 ");
}

TEST_CASE("names of macros and functions are their own", "[names]")
{
    Files files = files_with({{"/a.pov", "#declare R = 1;\n"  // R at 9
                                         "#macro Ball(R, C)\n  #local S = R * 2;\n  sphere { C, S + R }\n#end\n"
                                         "#declare F = function(R, t) { R + t };\n"
                                         "Ball(R, 0)\nsphere { 0, R }\n"}});
    const std::string text = files.text("/a.pov");
    const auto at = [&](const char* before, std::size_t behind) {
        return static_cast<std::uint32_t>(text.find(before) + behind);
    };
    const std::uint32_t call = at("Ball(R, 0)", 5), last = at("sphere { 0, R", 12), parameter = at("Ball(R, C)", 5);
    const std::uint32_t product = at("R * 2", 0), sum = at("S + R", 4), function = at("function(R", 9),
                        body = at("{ R + t", 2);
    const auto list = [](std::initializer_list<std::uint32_t> places) {
        std::string out;
        for (const std::uint32_t one : places) out += "/a.pov:" + std::to_string(one) + " ";
        return out;
    };
    CHECK(places(files, "/a.pov", 9) == list({9, call, last}));
    CHECK(places(files, "/a.pov", sum) == list({parameter, product, sum}));
    CHECK(places(files, "/a.pov", body) == list({function, body}));
    CHECK(declared(files, "/a.pov", sum) == "/a.pov:" + std::to_string(parameter));
    CHECK(declared(files, "/a.pov", last) == "/a.pov:9");
    CHECK(declared(files, "/a.pov", call - 5) == "/a.pov:" + std::to_string(at("Ball(R, C)", 0)));
    CHECK(places(files, "/a.pov", 2) == "none");  // a keyword
}

TEST_CASE("names go through includes, and a file's own do not", "[names]")
{
    Files files = files_with({{"/s/a.pov", "#include \"b.inc\"\n#local Own = 2;\n#declare Two = One + Own + Mine;\n"},
                              {"/s/b.inc", "#declare One = 1;\n#local Mine = 3;\n#declare Three = One + Mine + Own;"},
                              {"/s/c.pov", "#declare One = 5;"}});
    CHECK(files.reached("/s/a.pov") == std::vector<std::string>{"/s/a.pov", "/s/b.inc"});
    CHECK(files.related("/s/b.inc") == std::vector<std::string>{"/s/b.inc", "/s/a.pov"});
    const std::uint32_t one = nth(files, "/s/a.pov", "One", 1);
    CHECK(declared(files, "/s/a.pov", one) == "/s/b.inc:9");
    CHECK(places(files, "/s/a.pov", one) == "/s/a.pov:" + std::to_string(one) + " /s/b.inc:9 /s/b.inc:52 ");
    // The scene's own name holds in what it includes.
    CHECK(places(files, "/s/a.pov", nth(files, "/s/a.pov", "Own", 1)) == "/s/a.pov:24 /s/a.pov:54 /s/b.inc:65 ");
    CHECK(places(files, "/s/b.inc", nth(files, "/s/b.inc", "Own", 1)) == "/s/b.inc:65 /s/a.pov:24 /s/a.pov:54 ");
    // An include file's own name does not hold in the scene.
    CHECK(places(files, "/s/b.inc", nth(files, "/s/b.inc", "Mine", 1)) == "/s/b.inc:25 /s/b.inc:58 ");
    CHECK(places(files, "/s/c.pov", 9) == "/s/c.pov:9 ");
}

TEST_CASE("the declaration in force is the nearest before the place", "[names]")
{
    Files files =
        files_with({{"/a.pov", "#declare A = 1; sphere { 0, A } #declare A = 2; box { 0, A } #declare B[0] = A;"}});
    CHECK(declared(files, "/a.pov", 28) == "/a.pov:9");
    CHECK(declared(files, "/a.pov", 57) == "/a.pov:41");
    CHECK(declared(files, "/a.pov", 70) == "none");  // an element of an array is no declaration
}

TEST_CASE("files on disk are read again when they change", "[names]")
{
    const support::TemporaryFolder folder;
    const std::string inc = folder / "d.inc", scene = folder / "d.pov";
    std::ofstream(inc) << "#declare D = 1;";
    Files files({});
    files.open(scene, "#include \"d\"\nsphere { D, 1 }");
    CHECK(declared(files, scene, 22) == inc + ":9");
    std::ofstream(inc) << "\n\n#declare D = 1;";
    CHECK(declared(files, scene, 22) == inc + ":11");
    files.open(inc, "");  // the editor's text lies over it
    CHECK(declared(files, scene, 22) == "none");
    files.close(inc);
    CHECK(declared(files, scene, 22) == inc + ":11");
}
