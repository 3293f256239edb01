// The lines that programs read, and the exit statuses that tell them what to do next.
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <sstream>
#include <sys/mount.h>

namespace {

using Words = std::vector<std::string>;
using support::Ended;
using support::run_program;

constexpr const char* kBall = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -4*z look_at 0 }\n"
                              "light_source { <2, 4, -5> 1 }\nsphere { 0, 1 pigment { rgb <1, clock, 0> } }\n";

/// No type of file packs it well.
constexpr const char* kGrains =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location -4*z look_at 0 }\n"
    "plane { z, 0 pigment { cells color_map { [0 rgb <1, 0, .2>] [1 rgb <.1, 1, 1>] } scale .01 } "
    "finish { ambient 1 } }\n";

Ended ball(const support::TemporaryFolder& folder, Words words, const char* scene = kBall)
{
    support::write_text(folder / "ball.pov", scene);
    words.insert(words.begin(), {"ball.pov", "+W64", "+H64"});
    return run_program(folder.path(), WHITTLE_PROGRAM, words);
}

Words lines_with(const std::string& text, const std::string& beginning)
{
    Words found;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(beginning)) found.push_back(line.substr(beginning.size()));
    return found;
}

}  // namespace

TEST_CASE("Open Job Description's lines of progress", "[program][progress]")
{
    const support::TemporaryFolder folder;
    const Ended done = ball(folder, {"+KFF3", "--progress=openjd", "--quiet"});
    CHECK(done.status == 0);
    const Words percents = lines_with(done.err, "openjd_progress: ");
    REQUIRE(percents.size() >= 3);
    CHECK(percents.back() == "100.0");
    for (std::size_t i = 1; i < percents.size(); ++i) CHECK(std::stod(percents[i]) > std::stod(percents[i - 1]));
    const Words statuses = lines_with(done.err, "openjd_status: ");
    CHECK(statuses == Words{"frame 1: reading", "frame 1: rendering", "frame 2: reading", "frame 2: rendering",
                            "frame 3: reading", "frame 3: rendering", "done"});
    const Ended again = ball(folder, {"+KFF3", "--progress=openjd", "--quiet", "+C"});  // all frames are there
    CHECK(lines_with(again.err, "openjd_progress: ").back() == "100.0");
}

TEST_CASE("what fails is told in the program's dialect too", "[program][progress]")
{
    const support::TemporaryFolder folder;
    const Ended broken = ball(folder, {"--progress=openjd"}, "sphere { 0 }\n");
    CHECK(broken.status == 1);
    REQUIRE(lines_with(broken.err, "openjd_fail: ").size() == 1);
    CHECK_THAT(lines_with(broken.err, "openjd_fail: ")[0], Catch::StartsWith("ball.pov:1:12: error: "));
    const Ended options = ball(folder, {"--progress=json", "+KFF3", "--frames=9"});
    CHECK(options.status == 1);
    CHECK_THAT(lines_with(options.err, "{\"fail\": ").at(0), Catch::Contains("9 is not a frame of the animation"));
}

TEST_CASE("lines of JSON and of POV-Ray", "[program][progress]")
{
    const support::TemporaryFolder folder;
    const Ended json = ball(folder, {"--progress=json", "--quiet"});
    CHECK(lines_with(json.err, "{\"percent\": ").back() == "100.0}");
    CHECK(lines_with(json.err, "{\"status\": ") ==
          Words{"\"picture: reading\"}", "\"picture: rendering\"}", "\"done\"}"});
    const Ended povray = ball(folder, {"--progress=povray", "--quiet"});
    CHECK(lines_with(povray.err, "Rendered ").back() == "4096 of 4096 pixels (100%)");
}

TEST_CASE("a full disk is worth another try, whatever the type of file", "[program][progress]")
{
    const support::TemporaryFolder folder;
    const std::string small = folder / "small";
    std::filesystem::create_directories(small);
    if (mount("tmpfs", small.c_str(), "tmpfs", 0, "size=20k") != 0) {
        WARN("needs the right to mount");
        return;
    }
    support::write_text(small + "/filler", std::string(16384, 'x'));
    for (const char* type : {"+FN", "+FP", "+FT", "+FJ", "+FB", "+FE", "+FH"}) {
        INFO(type);
        const Ended full = ball(folder, {"+Osmall/ball", type}, kGrains);
        CHECK(full.status == 75);
        CHECK_THAT(full.err, Catch::Contains("error: "));
        CHECK(std::distance(std::filesystem::directory_iterator(small), {}) == 1);  // nothing is left lying about
    }
    support::write_text(small + "/rest", std::string(16384, 'x'));
    CHECK(ball(folder, {"--json=small/ball.json"}).status == 75);
    umount(small.c_str());
}

TEST_CASE("what another try cannot mend ends with status 1", "[program][progress]")
{
    const support::TemporaryFolder folder;
    CHECK(ball(folder, {}, "#include \"nowhere.inc\"\n").status == 1);
    CHECK(ball(folder, {"+Ono/such/folder/ball"}).status == 1);
    CHECK(ball(folder, {"+W1000000", "+H1000000", "+FP"}).status == 1);
}
