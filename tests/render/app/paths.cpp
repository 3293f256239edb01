// --integrator=path and --denoise as one asks for them: docs/path_tracing.md.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

using support::run_program;

namespace {

const std::string kHeading = "#version 3.7; global_settings { assumed_gamma 1 }\ncamera { location -4*z look_at 0 }\n";

}  // namespace

TEST_CASE("paths take samples, an error or a time as other pictures do", "[program][path]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "s.pov", kHeading + "background { rgb .5 }\nlight_source { <3,5,-5> rgb 1 }\n"
                                                     "sphere { 0, 1 pigment { rgb .8 } }\n");
    const auto ended = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"s.pov", "+W32", "+H24", "-D", "--integrator=path"});
        return run_program(folder.path(), WHITTLE_PROGRAM, words);
    };
    const auto usual = ended({});
    CHECK(usual.status == 0);
    CHECK(usual.err.find("samples") != std::string::npos);
    CHECK(usual.err.find("camera 49152") != std::string::npos);  // 64 in each pixel
    CHECK(ended({"--samples=4", "--denoise"}).err.find("camera 3072") != std::string::npos);
    CHECK(ended({"--error=4", "--denoise"}).status == 0);
    CHECK(ended({"--time=0.2"}).status == 0);
}

TEST_CASE("paths tell of what they cannot do", "[program][path]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "dark.pov", kHeading + "sphere { 0, 1 pigment { rgb .8 } finish { ambient 1 } }\n");
    support::write_text(folder / "sky.pov",
                        kHeading + "sky_sphere { pigment { image_map { hdr \"sky.hdr\" map_type 1 } } }\n");
    support::write_text(folder / "sky.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\nand no more");
    const auto ended = [&](const std::vector<std::string>& words) {
        return run_program(folder.path(), WHITTLE_PROGRAM, words);
    };
    const auto dark = ended({"dark.pov", "+W8", "+H6", "-D", "--integrator=path", "--samples=1"});
    CHECK(dark.status == 0);
    CHECK(dark.err.find("nothing in the scene gives light") != std::string::npos);
    const auto broken = ended({"sky.pov", "+W8", "+H6", "-D", "--integrator=path"});
    CHECK(broken.status == 1);
    CHECK(broken.err.find("sky.pov:3:") != std::string::npos);
    CHECK(broken.err.find("the Radiance file is broken") != std::string::npos);
    const auto other = ended({"dark.pov", "--integrator=photon"});
    CHECK(other.status == 1);
    CHECK(other.err.find("--integrator wants whitted|path, found 'photon'") != std::string::npos);
    const auto whitted = ended({"dark.pov", "--denoise"});
    CHECK(whitted.status == 1);
    CHECK(whitted.err.find("it goes with --integrator=path") != std::string::npos);
}

TEST_CASE("a report by paths measures the rest against them", "[program][report][path]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "s.pov", kHeading + "background { rgb .5 }\nsphere { 0, 1 pigment { rgb .8 } }\n");
    const auto ended = run_program(folder.path(), WHITTLE_PROGRAM,
                                   {"report", "s.pov", "-o", "r.html", "+W16", "+H12", "--povray=off",
                                    "--integrator=path", "--truth-error=1", "--truth-seconds=2"});
    CHECK(ended.status == 0);
    const std::string csv = support::text_of(folder / "r.csv");
    CHECK(csv.find("\"paths\",\"--integrator=path --samples=16\"") != std::string::npos);
    CHECK(csv.find("\"paths, filtered\",\"--integrator=path --samples=16 --denoise\"") != std::string::npos);
    CHECK(csv.find("\"samples\",\"--samples=16\"") != std::string::npos);
}
