// Pictures asked for by samples, by error and by time: docs/error_and_time.md.
#include "render/image/files.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>

namespace {

using support::run_program;

const std::string kSampledScene = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                                  "camera { location <0,2,-5> look_at 0 }\n"
                                  "light_source { <3,5,-3> rgb 1 area_light x, z, 5, 5 adaptive 1 jitter }\n"
                                  "plane { y,-1 pigment { checker rgb 1 rgb .2 } }\n"
                                  "sphere { 0, 1 pigment { rgb <.8,.3,.2> } finish { reflection .2 phong .5 } }\n";

struct SampledFolder : support::TemporaryFolder {
    SampledFolder() { support::write_text(*this / "s.pov", kSampledScene); }
    support::Ended render(std::vector<std::string> words)
    {
        words.insert(words.begin(), {"s.pov", "+W96", "+H72", "+FN16"});
        return run_program(path(), WHITTLE_PROGRAM, words);
    }
};

}  // namespace

TEST_CASE("an error asked for is the error against many more samples", "[program][samples]")
{
    SampledFolder folder;
    REQUIRE(folder.render({"--samples=4096", "+Otruth.png"}).status == 0);
    for (const double asked : {4.0, 1.0}) {
        REQUIRE(folder.render({"--error", std::to_string(asked), "+Oa.png"}).status == 0);
        const auto compared = run_program(folder.path(), WHITTLE_PROGRAM, {"compare", "a.png", "truth.png"});
        const std::size_t at = compared.out.find("rmse");
        REQUIRE(at != std::string::npos);
        const double error = std::stod(compared.out.substr(at + 4));
        CHECK(error < asked);
        CHECK(error > 0.2 * asked);  // and not bought with ten times the samples
    }
}

TEST_CASE("--time is kept", "[program][samples]")
{
    SampledFolder folder;
    const auto start = std::chrono::steady_clock::now();
    const auto ended = folder.render({"--time=1", "+Oa.png"});
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    REQUIRE(ended.status == 0);
    CHECK(ended.err.find("expected from the spread") != std::string::npos);
    CHECK(took > 0.85);
    CHECK(took < 3.0);  // 1.03 on a machine that does nothing else
}

TEST_CASE("samples, errors and times that make no sense are told", "[program][samples]")
{
    SampledFolder folder;
    for (const char* word :
         {"--time=0", "--time=-3", "--time=soon", "--time=3x", "--error=0", "--error=nan", "--error=5m", "--samples=0",
          "--samples=2.5", "--samples=70000", "--samples=%", "--samples=inf"}) {
        INFO(word);
        const auto ended = folder.render({word, "+Ob.png"});
        CHECK(ended.status == 1);
        CHECK(ended.err.find("wants") != std::string::npos);
        CHECK(!std::filesystem::exists(folder / "b.png"));
    }
}

TEST_CASE("a shutter blurs what moves by the time that it is there", "[program][samples]")
{
    SampledFolder folder;
    // White where x < clock, of a view from -1 to 1: of a clock from 0 to 1 the share 1 - x of the time.
    support::write_text(folder / "m.pov", "#version 3.7; global_settings { assumed_gamma 1 }\n"
                                          "camera { orthographic location -z right 2*x up 1*y direction z }\n"
                                          "#debug concat(str(clock, 0, 6), \"\\n\")\n"
                                          "plane { z, 1 pigment {\n"
                                          "  function { select(x - clock, 1, 0) } color_map { [0 rgb 0] [1 rgb 1] } }\n"
                                          "  finish { ambient 1 diffuse 0 } }\n");
    const auto render = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"m.pov", "+W64", "+H8", "+FN16"});
        return run_program(folder.path(), WHITTLE_PROGRAM, words);
    };
    const auto ended = render({"Shutter=1", "Motion_Samples=64", "+Oa.png"});
    REQUIRE(ended.status == 0);
    CHECK(ended.err.find("0.007812") != std::string::npos);  // told once, at the first of the moments
    CHECK(ended.err.find("0.023438") == std::string::npos);
    const image::Picture picture = image::Files().read(folder / "a.png");
    for (int x = 0; x < 64; ++x) {
        const double at = (x + 0.5) / 32.0 - 1.0, share = std::clamp(1.0 - at, 0.0, 1.0);
        const auto light = static_cast<double>(image::TransferCurve::srgb().decode(picture.at(x, 4)[0]));
        CHECK(std::abs(light - share) < 1.6 / 64.0);
    }
    // In an animation the share of what is left to the next frame.
    REQUIRE(render({"Shutter=0.5", "Motion_Samples=8", "+KFI1", "+KFF5", "+SF3", "+EF3", "+Ob.png"}).status == 0);
    const image::Picture third = image::Files().read(folder / "b3.png");
    const auto light_at = [&](double at) {
        const int x = static_cast<int>((at + 1.0) * 32.0);
        return static_cast<double>(image::TransferCurve::srgb().decode(third.at(x, 4)[0]));
    };
    CHECK(light_at(0.45) == Approx(1.0).margin(1e-3));
    CHECK(light_at(0.5625) == Approx(0.5).margin(0.13));
    CHECK(light_at(0.66) == Approx(0.0).margin(1e-3));
    const auto refused = render({"Shutter=1", "--error=1"});
    CHECK(refused.status == 1);
    CHECK(refused.err.find("Shutter") != std::string::npos);
}

TEST_CASE("samples are the same on one thread and on four", "[program][samples]")
{
    SampledFolder folder;
    REQUIRE(folder.render({"--error=3", "+WT1", "+Oa.png"}).status == 0);
    REQUIRE(folder.render({"--error=3", "+WT4", "+Ob.png"}).status == 0);
    CHECK(support::text_of(folder / "a.png") == support::text_of(folder / "b.png"));
}
