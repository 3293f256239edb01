#include "render/image/files.h"

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>

namespace {

using support::text_of;
using support::write_text;

struct Run {
    int status;
    std::string out, err;
};

/// Runs the program in `folder` with arguments as a shell reads them.
Run run(const support::TemporaryFolder& folder, const std::string& arguments)
{
    const support::TemporaryFolder streams;
    const std::string out = streams / "out", err = streams / "err";
    const std::string command = "cd " + folder.path() + " && HOME=" + folder.path() + " " WHITTLE_PROGRAM " " +
                                arguments + " >" + out + " 2>" + err;
    const int result = std::system(command.c_str());
    return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, text_of(out), text_of(err)};
}

constexpr const char* kScene = "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
                               "camera { location <0, 0, -4> look_at 0 }\nlight_source { <-5, 5, -5>, 1 }\n"
                               "sphere { 0, 1 pigment { rgb <1, 0.5, 0.25> } }\n"
                               "background { rgb <0.125, 0.375, 0.875> }\n";

}  // namespace

TEST_CASE("a scene becomes a picture beside it", "[program]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kScene);
    const Run result = run(folder, "scene.pov +W40 +H30 -D -P");
    INFO(result.err);
    REQUIRE(result.status == 0);
    CHECK(result.out.empty());
    CHECK(folder.names() == std::vector<std::string>{"scene.png", "scene.pov"});
    const image::Picture picture = image::Files().read(folder / "scene.png");
    CHECK(picture.width == 40);
    CHECK(picture.height == 30);
    CHECK(picture.channels == 3);
    CHECK(picture.bits == 8);
    // The background at a corner: linear light 0.125, 0.375, 0.875 as sRGB.
    const std::array<float, 4> corner = picture.at(0, 0);
    CHECK(std::lround(255.0 * static_cast<double>(corner[0])) == 99);
    CHECK(std::lround(255.0 * static_cast<double>(corner[1])) == 165);
    CHECK(std::lround(255.0 * static_cast<double>(corner[2])) == 240);
    for (const char* word : {"parse ", "trace ", "rays ", "camera 1200", "million rays per second"})
        CHECK_THAT(result.err, Catch::Contains(word));
    CHECK_THAT(result.err, !Catch::Contains("\r"));  // no progress bar in a pipe
}

TEST_CASE("standard output carries the picture and nothing else", "[program]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kScene);
    REQUIRE(run(folder, "scene.pov +W16 +H12 -D").status == 0);
    const Run piped = run(folder, "scene.pov +W16 +H12 -D +O-");
    REQUIRE(piped.status == 0);
    CHECK(piped.out == text_of(folder / "scene.png"));
}

TEST_CASE("a failed run has status 1 and leaves an existing picture as it was", "[program]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", "sphere { 0 1");
    write_text(folder / "scene.png", "old");
    for (const char* arguments :
         {"scene.pov", "scene.pov +W0", "scene.pov +ZZ", "scene.pov Widht=3", "scene.pov +W8 +H8 +EC9"}) {
        const Run result = run(folder, arguments);
        INFO(arguments);
        CHECK(result.status == 1);
        CHECK(result.out.empty());
        CHECK_THAT(result.err, Catch::Contains("error:"));
        CHECK(text_of(folder / "scene.png") == "old");
    }
    CHECK(folder.names() == std::vector<std::string>{"scene.png", "scene.pov"});
    CHECK_THAT(run(folder, "missing.pov").err, Catch::Contains("missing.pov"));
    CHECK(run(folder, "missing.pov").status == 1);
    CHECK(run(folder, "").status == 1);
}

TEST_CASE("help and version go to standard output", "[program]")
{
    const support::TemporaryFolder folder;
    const Run help = run(folder, "--help");
    CHECK(help.status == 0);
    CHECK_THAT(help.out, Catch::Contains("usage: whittle"));
    CHECK(run(folder, "--version").out == "whittle 0.1.0\n");
}

TEST_CASE("options without effect are named in one line", "[program]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kScene);
    const Run result = run(folder, "scene.pov +W8 +H6 Real_Time_Raytracing=on -D");
    CHECK(result.status == 0);
    CHECK_THAT(result.err, Catch::Contains("note: accepted without effect for now: Real_Time_Raytracing\n"));
}

TEST_CASE("an animation writes a picture per frame and continues where it stopped", "[program]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kScene);
    write_text(folder / "scene2.png", "there");
    REQUIRE(run(folder, "scene.pov +W8 +H6 +KFF3 +C").status == 0);
    CHECK(folder.names() == std::vector<std::string>{"scene.pov", "scene1.png", "scene2.png", "scene3.png"});
    CHECK(text_of(folder / "scene2.png") == "there");
}

TEST_CASE("each stage can be printed", "[program]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kScene);
    for (const char* stage : {"tokens", "scene", "plan"}) {
        const Run result = run(folder, std::string("scene.pov --dump=") + stage);
        INFO(stage << ": " << result.err);
        CHECK(result.status == 0);
        CHECK_FALSE(result.out.empty());
    }
    const Run parsed = run(folder, "scene.pov --parse-only");
    CHECK(parsed.status == 0);
    CHECK(folder.names() == std::vector<std::string>{"scene.pov"});
}

TEST_CASE("the same bytes for one thread and for several", "[program]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kScene);
    REQUIRE(run(folder, "scene.pov +W80 +H60 +A0.1 +WT1 +Oone.png").status == 0);
    REQUIRE(run(folder, "scene.pov +W80 +H60 +A0.1 +WT4 +Ofour.png").status == 0);
    CHECK(text_of(folder / "one.png") == text_of(folder / "four.png"));
}

TEST_CASE("the picture stands where POV-Ray puts it", "[program]")
{
    const support::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "sub");
    const auto pictures = [&](const std::string& arguments) {
        const Run result = run(folder, arguments + " +W8 +H6 -D");
        INFO(arguments << "\n" << result.err);
        CHECK(result.status == 0);
        std::vector<std::string> found;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
            if (entry.path().extension() != ".png") continue;
            found.push_back(std::filesystem::relative(entry.path(), folder.path()).string());
        }
        for (const std::string& name : found) std::filesystem::remove(folder / name);
        return found;
    };
    write_text(folder / "sub/d.pov", kScene);
    using Names = std::vector<std::string>;
    CHECK(pictures("sub/d.pov") == Names{"sub/d.png"});  // beside the scene
    CHECK(pictures("+Isub/d") == Names{"sub/d.png"});
    CHECK(pictures("+Isub/d.pov +Oe.png") == Names{"e.png"});
    CHECK(pictures("sub/d.pov +Osub/") == Names{"sub/d.png"});
    CHECK(pictures("sub/d.pov +Osub") == Names{"sub.png"});  // a folder needs its slash
    CHECK(pictures("+Lsub +Id.pov") == Names{"d.png"});  // found by the library path: the name as it was given counts
}
