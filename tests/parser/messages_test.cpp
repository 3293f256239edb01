#include "parser/parse.h"
#include "parser/stream/texts/quoted_text.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <atomic>

namespace {

const std::string kBegin = "#version 3.7; global_settings { assumed_gamma 1 } ";

std::string error_of_file(const std::string& path, const parser::Options& options = {})
{
    try {
        parser::parse_file(path, options);
        return {};
    } catch (const parser::Error& error) {
        const std::string all = error.what();
        return all.substr(0, all.find('\n'));
    }
}

std::vector<scene::Message> errors_of(const std::string& text)
{
    try {
        parser::parse_text(kBegin + "\n" + text, "t.pov", {});
    } catch (const parser::Error& error) {
        std::string all;
        for (const scene::Message& message : error.messages()) {
            if (!all.empty()) all += '\n';
            all += message_text(message);
        }
        CHECK(all == error.what());
        return error.messages();
    }
    return {};
}

std::vector<std::string> warnings(const std::string& path)
{
    std::vector<std::string> all;
    try {
        parser::parse_file(
            path, {},
            [](void* to, const parser::Message& message) {
                static_cast<std::vector<std::string>*>(to)->push_back(message_text(message));
            },
            &all);
    } catch (const parser::Error&) {}
    return all;
}

/// First lines of all that is told of a text.
std::vector<std::string> told_of(const std::string& text, bool blocks = true)
{
    std::vector<std::string> all;
    parser::Options options;
    options.blocks = blocks;
    const auto listen = [](void* to, const parser::Message& message) {
        if (message.severity != parser::Severity::Debug)
            static_cast<std::vector<std::string>*>(to)->push_back(message_text(message));
    };
    try {
        parser::parse_text(kBegin + "\n" + text, "t.pov", options, listen, &all);
    } catch (const parser::Error& error) {
        for (const scene::Message& message : error.messages()) all.push_back(message_text(message));
    }
    for (std::string& one : all) one.resize(std::min(one.size(), one.find('\n')));
    return all;
}

}  // namespace

TEST_CASE("a missing include names the folders and the nearest file", "[parser][messages]")
{
    const support::TemporaryFolder folder, library;
    support::write_text(library / "colours.inc", "");
    support::write_text(library / "other.inc", "");
    parser::Options options;
    options.library_path = {library.path()};
    support::write_text(folder / "a.pov", "#include \"colors.inc\"");
    CHECK(error_of_file(folder / "a.pov", options) ==
          (folder / "a.pov") + ":1:10: error: cannot find the include file 'colors.inc' in the current folder, '" +
              library.path() + "', '" + folder.path() + "'; did you mean 'colours.inc'?");
    support::write_text(folder / "a.pov", "#include \"OTHR\"");
    CHECK_THAT(error_of_file(folder / "a.pov", options), Catch::EndsWith("; did you mean 'other.inc'?"));
    support::write_text(folder / "a.pov", "#include \"nothing_like_it.inc\"");
    CHECK_THAT(error_of_file(folder / "a.pov", options), Catch::EndsWith("'" + folder.path() + "'"));
}

TEST_CASE("a scene that is not there is said to be absent", "[parser][messages]")
{
    const support::TemporaryFolder folder;
    CHECK(error_of_file(folder / "nothere.pov") == (folder / "nothere.pov") + ": error: there is no such file");
    support::write_text(folder / "nowhere.pov", "");
    CHECK_THAT(error_of_file(folder / "nothere.pov"),
               Catch::EndsWith(": error: there is no such file; did you mean '" + (folder / "nowhere.pov") + "'?"));
}

TEST_CASE("a loop whose reading is cancelled is named by its line", "[parser][messages]")
{
    const std::atomic<bool> cancel{true};
    parser::Options options;
    options.cancel = &cancel;
    std::string told;
    const auto listen = [](void* to, const parser::Message& message) {
        *static_cast<std::string*>(to) += message_text(message);
    };
    CHECK_THROWS_AS(parser::parse_text(kBegin + "\n#declare I = 0;\n#while (I >= 0)\n #declare I = I + 1;\n#end",
                                       "t.pov", options, listen, &told),
                    parser::Cancelled);
    CHECK_THAT(told, Catch::StartsWith("t.pov:"));
    std::atomic<bool> later{false};
    options.cancel = &later;
    told.clear();
    const auto cancel_at_debug = [](void* to, const parser::Message& message) {
        if (message.severity == parser::Severity::Debug)
            static_cast<std::pair<std::atomic<bool>*, std::string*>*>(to)->first->store(true);
        else *static_cast<std::pair<std::atomic<bool>*, std::string*>*>(to)->second += message_text(message);
    };
    std::pair<std::atomic<bool>*, std::string*> both{&later, &told};
    CHECK_THROWS_AS(
        parser::parse_text(
            kBegin + "\n#debug \"go\"\n#declare I = 0;\n#while (I >= 0)\n #if (1) #declare I = I + 1; #end\n#end",
            "t.pov", options, cancel_at_debug, &both),
        parser::Cancelled);
    CHECK(told == "t.pov:4:1: note: reading is cancelled, in this loop\n    4 | #while (I >= 0)\n      | ^");
}

TEST_CASE("source lines keep their characters", "[parser][messages]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "u.pov", kBegin + "\n#declare A = \"gr\xC3\xBC\xC3\x9F\xE2\x82\xAC\" shpere { }");
    std::string all;
    try {
        parser::parse_file(folder / "u.pov", {});
    } catch (const parser::Error& error) {
        all = error.what();
    }
    // One blank a character: the caret stands below its word.
    CHECK_THAT(
        all,
        Catch::Contains(
            "\n    2 | #declare A = \"gr\xC3\xBC\xC3\x9F\xE2\x82\xAC\" shpere { }\n      |                      ^"));
    CHECK(parser::printable("a\tb\x01\x7F\xC3\xBC\xC3(\xFF\xC0\xAF\xED\xA0\x80\xF0\x9F\x98\x80\xC2\x85") ==
          "a\tb??\xC3\xBC?(???"
          "???\xF0\x9F\x98\x80??");
    CHECK(parser::character_start("a\xE2\x82\xAC", 3) == 1);
    CHECK(parser::character_start("a\xE2\x82\xAC", 1) == 1);
}

TEST_CASE("a warning is told once, a #warning each time but in short", "[parser][messages]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "w.pov",
                        kBegin +
                            "sphere { 0, 1 }\n#for (I, 1, 5)\n union { sphere { 0, 1 } }\n #warning \"again\"\n#end");
    const std::vector<std::string> all = warnings(folder / "w.pov");
    REQUIRE(all.size() == 6);
    CHECK_THAT(all[0], Catch::Contains("should have at least two objects\n"));
    CHECK_THAT(all[1], Catch::Contains(": warning: again\n"));
    for (std::size_t i = 2; i < all.size(); ++i) CHECK(all[i] == (folder / "w.pov") + ":4:3: warning: again");
}

TEST_CASE("a file that includes itself is told in few words", "[parser][messages]")
{
    const support::TemporaryFolder folder;
    for (const char* body : {"", "camera { location -z }\nunion { sphere { 0, 1 } }\n", "#warning \"again\"\n",
                             "union { sphere { 0, 1 } }\nlight_source { 0, 1 orient }\n#declare\nversion = 3;"}) {
        INFO(body);
        support::write_text(folder / "s.pov", body + std::string("#include \"") + (folder / "s.pov") + "\"\n");
        std::size_t bytes = error_of_file(folder / "s.pov").size();
        for (const std::string& text : warnings(folder / "s.pov")) bytes += text.size();
        CHECK(bytes < 12'000);
        CHECK(bytes > 50);
    }
}

TEST_CASE("an error is kept in parts until it is told", "[parser][messages]")
{
    const auto errors = errors_of("#macro M(N)\n #if (N > 0) M(N - 1) #else sphere { 0, bad } #end\n#end\nM(3)\n");
    REQUIRE(errors.size() == 1);
    const scene::Message& error = errors.front();
    CHECK(error.severity == parser::Severity::Error);
    CHECK(error.place.path == "t.pov");
    CHECK(error.place.at.line == 3);
    CHECK(error.place.at.column == 41);
    CHECK(error.text == "expected the radius (a number), found 'bad', which is not declared");
    REQUIRE(error.quote);
    CHECK(error.quote->text.substr(error.quote->indent.size(), 3) == "bad");
    REQUIRE(error.related.size() == 2);
    CHECK(error.related[0].times == 3);
    CHECK(error.related[0].place.at.line == 3);
    CHECK(error.related[1].place.at.line == 5);
    CHECK(error.related[1].text == "in the expansion of macro M");
}

TEST_CASE("each statement that is wrong has a message of its own", "[parser][messages]")
{
    const auto errors = errors_of("sphere { 0 }\nbox { 0, 1 }\nplane { 7 }\n");
    REQUIRE(errors.size() == 2);
    CHECK(errors[0].place.at.line == 2);
    CHECK(errors[1].place.at.line == 4);
}

TEST_CASE("a mistake in a block is told alone, without what it makes of the block", "[parser][messages]")
{
    for (const char* text :
         {"difference { sphere { 0, 1 } shpere { 0, 2 } }", "union { sphere { 0, 1 } , }",
          "intersection { union { box { 0, 1 } box { 1, 2 } 7 } }", "merge { 5 }",
          "object { difference { plane { y, 0 } translate } }", "polygon { 3, <0, 0>, <1, 0>, <1, 1>, <0, 1> }",
          "prism { linear_sweep 0, 1, 3, <0, 0>, <1, 0>, <1, 1>, <0, 0> }"}) {
        INFO(text);
        const std::vector<std::string> told = told_of(text);
        REQUIRE(told.size() == 1);
        CHECK_THAT(told[0], Catch::StartsWith("t.pov:2:") && Catch::Contains(": error: "));
    }
    CHECK(told_of("union { union { sphere { 0, 1 } } translate x }\nsphere { 0 }") ==
          std::vector<std::string>{"t.pov:2:9: warning: union should have at least two objects",
                                   "t.pov:2:1: warning: union should have at least two objects",
                                   "t.pov:3:12: error: expected the radius (a number), found '}'"});
}

TEST_CASE("a name that is taken in place of the one before it is told once a place", "[parser][messages]")
{
    const std::string begin = "#declare P = 1; #declare Q = 2; #declare L = array[2] { 3, 4 } sphere { 0, 1 }\n"
                              "#macro M(A, B) #local S = A + B; #end #macro Sum(A, B) (A + B) #end\n"
                              "#declare F = function(x) { x } #declare G = function(x) { x }\n";
    const std::string warning = ": warning: 'Q' is taken in place of 'P', as in POV-Ray, because no comma stands "
                                "between them; write 'P, Q'";
    for (const bool blocks : {true, false}) {
        INFO(blocks);
        CHECK(told_of(begin + "#for (I, 1, 9)\n M(P Q)\n M(Q, P) M(P 5) M(P, Q) #end", blocks) ==
              std::vector<std::string>{"t.pov:6:4" + warning});
        CHECK(told_of(begin + "#for (I, 1, 9)\n #declare S = Sum(P Q); #end", blocks) ==
              std::vector<std::string>{"t.pov:6:19" + warning});
        CHECK(told_of(begin + "M(L[0] P) #declare K = array[2] { F G }", blocks) ==
              std::vector<std::string>{"t.pov:5:3: warning: 'P' is taken in place of 'L[...]', as in POV-Ray, because "
                                       "no comma stands between them; write 'L[...], P'",
                                       "t.pov:5:35: warning: 'G' is taken in place of 'F', as in POV-Ray, because no "
                                       "comma stands between them; write 'F, G'"});
        CHECK(
            told_of(begin + "M(P P) M(P L[0]) M(P+0 Q) M((P) Q) M(5 Q) #declare K = array[2] { F F }", blocks).empty());
        CHECK(told_of(begin + "M(P #if (1) #end, Q)", blocks) ==
              std::vector<std::string>{"t.pov:5:5: error: expected ',' or ')' after the argument, found a directive: a "
                                       "comma before it or parentheses around the argument help"});
        CHECK(told_of(begin + "M(P Sum(P, Q))", blocks) ==
              std::vector<std::string>{"t.pov:5:5: error: expected ',' or ')' after the argument, found a macro's "
                                       "name: a comma before it or parentheses around the argument help"});
    }
}

TEST_CASE("what stands nowhere or is a whole file is told without a line", "[parser][messages]")
{
    CHECK(scene::message_text({scene::Severity::Warning, "dark", {}, {}, {}, {}}) == "warning: dark");
    CHECK(scene::message_text({scene::Severity::Error, "bad", {"a.pov", {}}, {}, {}, {}}) == "a.pov: error: bad");
    CHECK(scene::message_text({scene::Severity::Debug, "as it is", {"a.pov", {1, 1}}, {}, {}, {}}) == "as it is");
}

TEST_CASE("a message quotes a long file, whose text is not kept, unless it has changed since", "[parser][messages]")
{
    const support::TemporaryFolder folder;
    const std::string begin = "#version 3.7; global_settings { assumed_gamma 1 }\n";
    std::string filling;
    while (filling.size() < (5u << 20)) filling += "// a line that is read over\n";
    const std::string end = "sphere { 0, 1 } cone { 0, wrong, 1, 2 }\n";
    const auto whole_error = [&](const std::string& before) {
        support::write_text(folder / "long.inc", filling + before + end);
        support::write_text(folder / "a.pov", begin + "#include \"long.inc\"");
        try {
            parser::parse_file(folder / "a.pov", {});
        } catch (const parser::Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK_THAT(whole_error(""), Catch::Contains(" | " + end));
    // It is written anew while it is read: shorter, and nothing of it is quoted.
    const std::string changed = whole_error("#fopen F \"" + (folder / "long.inc") + "\" write #fclose F\n");
    CHECK_THAT(changed, Catch::Contains("long.inc:") && !Catch::Contains("cone"));
}

TEST_CASE("a word that is no item of its block is told with the items", "[parser][messages]")
{
    const auto error = [](const std::string& text) { return errors_of(text).at(0).text; };
    CHECK(error("sphere { 0, 1 finish { shiny .5 } }") ==
          "'shiny' is no item of 'finish', and it is not declared; the items are ambient, brilliance, caustics, "
          "conserve_energy, crand, diffuse, emission, fresnel, ior, irid, metallic, phong, phong_size, reflection, "
          "reflection_exponent, refraction, roughness, specular, subsurface, use_alpha, whittle_cool_warm, "
          "whittle_ink, whittle_polished");
    CHECK(error("sphere { 0, 1 finish { reflection { 1 mirrored } } }") ==
          "'mirrored' is no item of 'reflection', and it is not declared; the items are exponent, falloff, fresnel, "
          "metallic, whittle_gloss, whittle_schlick");
    CHECK(error("sphere { 0, 1 finish { difuse .5 } }") == "'difuse' is not declared; did you mean 'diffuse'?");
    CHECK(error("sphere { 0, 1 glowing }") == "'glowing' is no item of 'sphere', and it is not declared");
}

TEST_CASE("numbers that should be a vector are told with the vector", "[parser][messages]")
{
    const auto error = [](const std::string& text) { return errors_of(text).at(0).text; };
    CHECK_THAT(error("box { 0, 1 rotate 45 y }"), Catch::EndsWith("found 'y'; did you mean '45*y'?"));
    CHECK_THAT(error("box { 0, 1 translate 1.50 x pigment { rgb 1 } }"), Catch::EndsWith("; did you mean '1.50*x'?"));
    CHECK_THAT(error("box { 0, 1 pigment { rgb 1 1 0 } }"), Catch::EndsWith("; did you mean 'rgb <1, 1, 0>'?"));
    CHECK_THAT(error("background { rgb 0.1, .2, 1 }"), Catch::EndsWith("; did you mean 'rgb <0.1, .2, 1>'?"));
    CHECK_THAT(error("box { 0, 1 pigment { granite color_map { [0 rgbt 1 1 0 .5] } } }"),
               Catch::EndsWith("; did you mean 'rgbt <1, 1, 0, .5>'?"));
    CHECK_THAT(error("box { 0, 1 translate 0 -1 2 3 }"), Catch::EndsWith("; did you mean 'translate <0, -1, 2>'?"));
    CHECK_THAT(error("box { 0, 1 scale 2 3 4 }"), Catch::EndsWith("; did you mean 'scale <2, 3, 4>'?"));
    CHECK_THAT(error("#declare T = transform { rotate 45 z }"), Catch::EndsWith("; did you mean '45*z'?"));
}
