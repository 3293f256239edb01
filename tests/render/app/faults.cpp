// What is asked for and cannot be had is said clearly.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

using support::run_program;

namespace {

const std::string kBareScene = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                               "camera { location -4*z look_at 0 } light_source { -9*z rgb 1 }\n";

support::Ended rendered(const support::TemporaryFolder& folder, const std::string& text,
                        std::vector<std::string> more = {})
{
    support::write_text(folder / "s.pov", kBareScene + text);
    more.insert(more.begin(), {"s.pov", "+W16", "+H12"});
    return run_program(folder.path(), WHITTLE_PROGRAM, more);
}

}  // namespace

TEST_CASE("a function that gives no number is named, with its place", "[program][faults]")
{
    const support::TemporaryFolder folder;
    const std::string box = " contained_by { box { -1, 1 } } pigment { rgb 1 } }\n";
    const auto none = rendered(folder, "isosurface { function { sqrt(x - 5) + y }" + box);
    CHECK(none.status == 0);
    CHECK(none.err.find("s.pov:3:1: the function of this isosurface gives no number at 125 of 125 places") !=
          std::string::npos);
    const auto half = rendered(folder, "union { sphere { 5*x, 1 } isosurface { function { sqrt(x) + y }" + box + "}\n");
    CHECK(half.err.find("of this isosurface gives no number at 50 of 125 places") != std::string::npos);
    const auto sheet = rendered(folder,
                                "parametric { function { ln(-1 - u*u) } function { u } function { v } <0,0>, <1,1> "
                                "contained_by { box { -1, 1 } } pigment { rgb 1 } }\n");
    CHECK(sheet.err.find("of this parametric surface gives no number") != std::string::npos);
    CHECK(rendered(folder, "isosurface { function { x*x + y*y + z*z - .5 }" + box).err.find("no number") ==
          std::string::npos);
}

TEST_CASE("samples that are no numbers are told, and spoil no other", "[program][faults]")
{
    const support::TemporaryFolder folder;
    // No normal above the middle: what is lit there has no color.
    const std::string text = "#declare N = function { sqrt(-y) }\n"
                             "plane { z, 3 pigment { rgb 1 } normal { function { N(x, y, z) } } }\n";
    const auto told = [&](std::vector<std::string> words) { return rendered(folder, text, std::move(words)).err; };
    const std::string sampled = told({"--samples=4", "+Oa.png"});
    CHECK(sampled.find(" of 768 samples are no numbers") != std::string::npos);
    CHECK(sampled.find("nan") == std::string::npos);
    CHECK(sampled.find("expected from the spread") != std::string::npos);
    CHECK(rendered(folder, "sphere { 0, 1 pigment { rgb 1 } }\n", {"--samples=4"}).err.find("no numbers") ==
          std::string::npos);
}

TEST_CASE("no time, no error and no samples are refused before the scene is read", "[program][faults]")
{
    const support::TemporaryFolder folder;
    for (const char* option : {"--time", "--error", "--samples"})
        for (const char* value : {"0", "-1", "nan"}) {
            const auto ended = rendered(folder, "sphere { 0, 1 }\n", {std::string(option) + "=" + value});
            CHECK(ended.status == 1);
            CHECK(ended.err.find(std::string(option) + " wants a number above 0") != std::string::npos);
            CHECK_FALSE(std::filesystem::exists(folder / "s.png"));
        }
}

TEST_CASE("a scene without light is rendered", "[program][faults]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "dark.pov", "#version 3.7; camera { location -4*z look_at 0 } sphere { 0, 1 }\n");
    CHECK(run_program(folder.path(), WHITTLE_PROGRAM, {"dark.pov", "+W16", "+H12"}).status == 0);
}

TEST_CASE("a heat picture that cannot be written is an error", "[program][faults][heat]")
{
    const support::TemporaryFolder folder;
    const auto lost = rendered(folder, "sphere { 0, 1 }\n", {"--heat=no/such/heat.png", "--parse-only"});
    CHECK(lost.status == 1);
    CHECK(lost.err.find("no/such/heat.png") != std::string::npos);
    CHECK(rendered(folder, "sphere { 0, 1 }\n", {"--heat=heat.png", "--parse-only"}).status == 0);
    CHECK(std::filesystem::exists(folder / "heat.png"));
    CHECK_FALSE(std::filesystem::exists(folder / "s.png"));
    const auto cost = rendered(folder, "sphere { 0, 1 pigment { rgb 1 } }\n", {"--explain=cost", "--parse-only"});
    CHECK(cost.status == 0);
    CHECK(cost.err.find("ns a ray of the camera") != std::string::npos);
    CHECK(rendered(folder, "sphere { 0, 1 }\n", {"--explain=price"}).err.find("--explain wants cost") !=
          std::string::npos);
}

TEST_CASE("deep nests of declared things are rendered, deeper ones refused with their place", "[program][faults]")
{
    struct Nest {
        const char *first, *next, *use;
        bool limited;
    };
    const Nest nest = GENERATE(
        Nest{"texture { pigment { rgb 1 } }", "texture { gradient x texture_map { [0 T] [1 pigment { rgb 0 }] } }",
             "plane { z, 0 texture { T } }", true},
        Nest{"pigment { rgb 1 }", "pigment { gradient x pigment_map { [0 T] [1 rgb 0] } }",
             "sky_sphere { pigment { T } }", true},
        Nest{"pigment { bozo }", "pigment { pigment_pattern { T } color_map { [0 rgb 0] [1 rgb 1] } }",
             "plane { z, 0 pigment { T } }", true},
        Nest{"normal { bumps }", "normal { gradient x normal_map { [0 T] [1 bumps] } }",
             "plane { z, 0 pigment { rgb 1 } normal { T } }", true},
        Nest{"density { spherical }", "density { gradient x density_map { [0 T] [1 rgb 1] } }",
             "sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { emission 1 density { T } } } }", true},
        Nest{"sphere { 0, 1 }", "difference { object { T } sphere { 5, 1 } }", "object { T pigment { rgb 1 } }",
             false});
    const auto nested = [&](int levels) {
        return "#declare T = " + std::string(nest.first) + "\n#declare I = 0; #while (I < " + std::to_string(levels) +
               ")\n#declare T = " + nest.next + "\n#declare I = I + 1; #end\n" + nest.use + "\n";
    };
    const support::TemporaryFolder folder;
    INFO(nest.next);
    const auto deep = rendered(folder, nested(2900), {"+WT2"});  // POV-Ray's own end lies between 8,000 and 20,000
    INFO(deep.err);
    CHECK(deep.status == 0);
    if (!nest.limited) return;
    const auto deeper = rendered(folder, nested(20000));
    CHECK(deeper.status == 1);
    CHECK(deeper.err.find("s.pov:5:") != std::string::npos);
    CHECK(deeper.err.find("patterns lie inside of each other more than 3000 deep") != std::string::npos);
}
