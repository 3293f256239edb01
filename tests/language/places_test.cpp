#include "language/format/edit.h"
#include "language/places/colors.h"
#include "language/places/completion.h"
#include "language/places/hover.h"
#include "language/places/place_words.h"
#include "language/places/structure.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace language;

namespace {

/// Completion at the '|' of a text.
Completion complete(std::string text)
{
    const std::size_t at = text.find('|');
    REQUIRE(at != std::string::npos);
    text.erase(at, 1);
    Files files({});
    files.open("/a.pov", text);
    return completion_at(files, "/a.pov", static_cast<std::uint32_t>(at));
}

bool offers(const Completion& found, const std::string& word)
{
    return std::any_of(found.items.begin(), found.items.end(), [&](const Item& item) { return item.word == word; });
}

/// Whether all of some words, and none of others, are offered.
void check(const std::string& text, std::initializer_list<const char*> wanted,
           std::initializer_list<const char*> others)
{
    INFO(text);
    const Completion found = complete(text);
    for (const char* word : wanted) CHECK(offers(found, word));
    for (const char* word : others) CHECK_FALSE(offers(found, word));
}

std::string hovered(const std::string& text, const std::string& at, std::size_t into = 0)
{
    Files files({});
    files.open("/a.pov", text);
    const auto found = hover_at(files, "/a.pov", static_cast<std::uint32_t>(text.find(at) + into),
                                [](const std::string& name) { return name == "V" ? "2.5" : ""; });
    if (!found) return "nothing";
    return found->code + "|" + found->value + "|" + found->where + "|" + found->sentence;
}

}  // namespace

TEST_CASE("words fit their place", "[places]")
{
    check("sphere { 0, 1 finish { | } }", {"phong", "reflection", "diffuse"}, {"sphere", "pigment", "rgb", "declare"});
    check("sphere { 0, 1 pigment { | } }", {"rgb", "color_map", "granite", "turbulence"},
          {"phong", "finish", "sphere"});
    check("sphere { 0, 1 | }", {"pigment", "texture", "translate", "no_shadow"}, {"phong", "sphere", "camera", "open"});
    check("cylinder { 0, y, 1 op|", {"open", "texture"}, {"sturm"});
    check("union { | }", {"sphere", "difference", "texture"}, {"phong", "global_settings"});
    check("global_settings { | }", {"assumed_gamma", "max_trace_level", "radiosity"}, {"pigment", "sphere"});
    check("global_settings { radiosity { | } }", {"pretrace_end", "count"}, {"importance", "pigment"});
    check("box { 0, 1 radiosity { | } }", {"importance"}, {"pretrace_end"});
    check("sphere { 0, 1 finish { reflection { | } } }", {"fresnel", "falloff"}, {"phong"});
    check("light_source { 0, rgb 1 | }", {"spotlight", "area_light"}, {"pigment"});
    check("camera { | }", {"location", "look_at"}, {"pigment"});
    check("#|", {"declare", "macro", "include", "end"}, {"sphere", "pigment"});
    check("#dec|", {"declare"}, {"sphere"});
    check("|", {"camera", "sphere", "global_settings"}, {"phong", "rgb"});
    check("#declare A = |", {"sphere", "sqrt", "texture", "array"}, {"global_settings", "phong"});
    check("sphere { 0, 1 translate <0, s|in(1), 0> }", {"sin", "sqrt"}, {"pigment"});
    check("sphere { 0, 1 pigment { srgbft s|in(1) } }", {"sin", "sqrt"}, {"pigment", "granite"});
    check("#declare F = function(x, y) { | }", {"sin", "x"}, {"sphere"});
    check("union { box { 0, 1 } // a\n  sphere { 0, 1 } | }", {"sphere"}, {});
}

TEST_CASE("nothing is offered in comments, texts, numbers and where a name is made", "[places]")
{
    for (const char* text : {"// sph|", "/* a | b */", "/* a |", "#declare A = \"sp|here\";", "#warning \"sp|",
                             "#warning \"a b sp|\nsphere { 0, 1 }", "sphere { 0, 1|"}) {
        INFO(text);
        CHECK(complete(text).items.empty());
    }
    check("#declare A = 1;\n#declare |", {"A"}, {"sphere", "sin"});
}

TEST_CASE("declared names are offered where they hold", "[places]")
{
    const std::string text = "#declare Big = 2;\n#macro M(Arg)\n  #local Inner = 1;\n  sphere { 0, %1 }\n#end\nbox { "
                             "0, %2 }\n#declare Late = 1;";
    const auto with = [&](const char* mark) {
        std::string out = text;
        for (const std::string one : {"%1", "%2"}) out.replace(out.find(one), 2, one == mark ? "|" : "1");
        return out;
    };
    check(with("%1"), {"Big", "Arg", "Inner", "M"}, {"Late"});
    check(with("%2"), {"Big", "M"}, {"Arg", "Inner", "Late"});
}

TEST_CASE("every word of the lists is a word of the language", "[places]")
{
    std::size_t blocks = 0;
    const auto check_words = [](const std::vector<std::string>& words) {
        for (const std::string& word : words) {
            INFO(word);
            CHECK(parser::keyword_of(word) != parser::Kind::Identifier);
        }
    };
    check_words(directive_words());
    check_words(scene_words());
    check_words(value_words());
    check_words(number_words());
    for (std::size_t kind = 0; kind < parser::kKindCount; ++kind)
        for (const parser::Kind outer : {parser::Kind::EndOfText, parser::Kind::GlobalSettings, parser::Kind::Finish}) {
            const std::vector<std::string> words = block_words(static_cast<parser::Kind>(kind), outer);
            blocks += !words.empty();
            check_words(words);
        }
    CHECK(blocks > 150);
}

TEST_CASE("hover tells a declaration, a value or what a keyword does", "[places]")
{
    CHECK(hovered("#declare V = 5 / 2;\nsphere { 0, V }", "V }") == "#declare V = 5 / 2;|2.5|line 1|");
    CHECK(hovered("#macro M(A, B)\n sphere { A, B }\n#end\nM(0, 1)", "M(0") == "#macro M(A, B)||line 1|");
    CHECK(hovered("#declare T = texture { pigment { rgb 1 } }\nsphere { 0, 1 texture { T } }", "{ T }", 2) ==
          "#declare T = texture { pigment { rgb 1 } }||line 1|");
    CHECK(hovered("torus { 1, 0.2 }", "torus", 2) == "|||" + std::string(keyword_line(parser::Kind::Torus)));
    CHECK(hovered("sphere { 0, Unknown }", "Unknown") == "nothing");
    CHECK(hovered("sphere { 0, 1 }", "0,") == "nothing");
}

TEST_CASE("colours of numbers alone have swatches", "[places]")
{
    const auto colors = [](const char* text) {
        std::string out;
        const Document document("/a.pov", text);
        for (const Swatch& one : swatches_of(document, linear_light(document))) {
            const auto [red, green, blue, alpha] = screen_color(one);
            char line[100];
            std::snprintf(line, sizeof line, "%u-%u %.3f %.3f %.3f %.3f ", one.range.begin, one.range.end, red, green,
                          blue, alpha);
            out += line;
        }
        return out;
    };
    CHECK(colors("rgb <1, 0, 0.5>") == "0-15 1.000 0.000 0.500 1.000 ");
    CHECK(colors("#version 3.7; rgb 0.5") == "14-21 0.735 0.735 0.735 1.000 ");  // linear light on a screen
    CHECK(colors("#version 3.7; srgb 0.5") == "14-22 0.500 0.500 0.500 1.000 ");
    CHECK(colors("global_settings { assumed_gamma 2.2 } rgb 0.5") == "38-45 0.500 0.500 0.500 1.000 ");
    CHECK(colors("rgbf <1, 1, 1, 0.25> rgbt <0, 0, 0, 1>") ==
          "0-20 1.000 1.000 1.000 0.750 21-38 0.000 0.000 0.000 0.000 ");
    CHECK(colors("#version 3.7; srgbt <0.5, 0.5, 0.5, 1>") == "14-38 0.500 0.500 0.500 0.000 ");
    CHECK(colors("rgb A rgb <1, A, 0> rgb 1*A rgb <1, 1, 1>/2").empty());

    const Document document("/a.pov", "#version 3.7; rgb <1, 1, 1> rgbf <1, 1, 1, 0.5> srgb 1");
    const auto swatches = swatches_of(document, true);
    REQUIRE(swatches.size() == 3);
    CHECK(color_text(swatches[0], {1, 0, 0.7354, 1}) == "rgb <1, 0, 0.5>");
    CHECK(color_text(swatches[0], {1, 0, 0, 0.25}) == "rgbt <1, 0, 0, 0.75>");
    CHECK(color_text(swatches[1], {1, 0, 0, 0.25}) == "rgbf <1, 0, 0, 0.75>");
    CHECK(color_text(swatches[2], {1, 0.25, 0, 1}) == "srgb <1, 0.25, 0>");
}

TEST_CASE("outline and folds", "[places]")
{
    const Document document("/a.pov",
                            "// a\n// b\n#declare A = 1;\n#macro M(X)\n  #local L = X;\n  sphere { 0, L }\n#end\n"
                            "camera {\n  location 0\n}\n#if (A)\n  box { 0, 1 }\n#else\n  box { 0, 2 }\n#end\n"
                            "#declare T =\n  texture {\n  }\n");
    std::string out;
    const auto entries = entries_of(document, outline_of(document));
    for (const Entry& one : entries) {
        out += one.name + "(" + one.detail;
        for (const Entry& inner : one.inner) out += " " + inner.name;
        out += ") ";
    }
    CHECK(out == "A() M(macro L) camera() box() box() T(texture) ");
    CHECK(folds_of(document) ==
          std::vector<Fold>{{4, 6, false}, {8, 9, false}, {11, 12, false}, {13, 14, false}, {1, 2, true}});
}

TEST_CASE("a layout's edit is the part that changes, or the lines that are asked for", "[format]")
{
    using language::format::layout_edit;
    const std::string text = "box{0,1}\nsphere { 0, 1 }\n  cone{0,1,y,0}   \nbox{1,2}\n";
    const auto applied = [&](const std::optional<language::format::Edit>& edit) {
        if (!edit) return text;
        return text.substr(0, edit->begin) + edit->text + text.substr(edit->end);
    };
    CHECK(applied(layout_edit(text)) == language::format::formatted(text));
    CHECK_FALSE(layout_edit("box { 0, 1 }\n"));
    CHECK(applied(layout_edit(text, 26, 30)) == "box{0,1}\nsphere { 0, 1 }\ncone { 0, 1, y, 0 }\nbox{1,2}\n");
    CHECK(applied(layout_edit(text, 0, 9)) == "box { 0, 1 }\nsphere { 0, 1 }\n  cone{0,1,y,0}   \nbox{1,2}\n");
    CHECK_FALSE(layout_edit(text, 9, 24));
    // In a block the lines get the level that they have there.
    const std::string block = "union {\nbox{0,1}\n}\n";
    const auto edit = layout_edit(block, 8, 16);
    REQUIRE(edit);
    CHECK(edit->text == "  box { 0, 1 }");
}
