#include "render/image/files.h"

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

// What cannot be read or written is told, in the program's own words, and the exit status says so.

namespace {

using support::write_text;

constexpr const char* kPlainScene =
    "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -4> look_at 0 }\n"
    "sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }\n";

/// With standard output on a device that takes nothing.
support::Ended run_on_full_device(const support::TemporaryFolder& folder, const std::string& arguments)
{
    const support::TemporaryFolder streams;
    const std::string command = "cd " + folder.path() + " && HOME=" + folder.path() + " " WHITTLE_PROGRAM " " +
                                arguments + " >/dev/full 2>" + (streams / "err");
    const int result = std::system(command.c_str());
    return {WIFEXITED(result) ? WEXITSTATUS(result) : -1, {}, support::text_of(streams / "err")};
}

support::Ended run_in(const support::TemporaryFolder& folder, const std::vector<std::string>& arguments)
{
    return support::run_program(folder.path(), WHITTLE_PROGRAM, arguments);
}

/// 4x4 pixels, opaque grey but for the last `clear` pixels.
void write_grey(const std::string& path, std::size_t clear)
{
    image::Raster raster{4, 4, 4, 8, {}};
    for (std::size_t i = 0; i < 16; ++i)
        raster.samples.insert(raster.samples.end(),
                              {128, 128, 128, static_cast<std::uint16_t>(i + clear < 16 ? 255 : 0)});
    image::Files().write(path, raster, image::FileType::Png, image::TransferCurve::srgb());
}

}  // namespace

TEST_CASE("what standard output does not take is an error", "[program][output]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kPlainScene);
    write_grey(folder / "a.png", 0);
    for (const char* arguments :
         {"--help", "--version", "--man", "--grammar", "scene.pov --deps", "scene.pov --dump=tokens",
          "scene.pov --dump=scene", "scene.pov --dump=plan", "scene.pov +W8 +H6 --json=-", "scene.pov +W8 +H6 +O-"}) {
        const support::Ended ended = run_on_full_device(folder, arguments);
        INFO(arguments << "\n" << ended.err);
        CHECK(ended.status == 1);
        CHECK_THAT(ended.err, Catch::Contains("error: cannot write to"));
    }
    CHECK(run_on_full_device(folder, "compare a.png a.png").status == 2);
    CHECK(run_on_full_device(folder, "scene.pov +W8 +H6").status == 0);  // prints nothing there
}

TEST_CASE("a journal that cannot be written is an error, and the picture stays", "[program][output]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kPlainScene);
    const support::Ended ended = run_in(folder, {"scene.pov", "+W8", "+H6", "--json=/nonexistent/x.json"});
    CHECK(ended.status == 1);
    CHECK_THAT(ended.err,
               Catch::Contains("whittle: error: cannot write '/nonexistent/x.json': No such file or directory\n"));
    CHECK(folder.names() == std::vector<std::string>{"scene.png", "scene.pov"});
}

TEST_CASE("pictures that cannot be read are told in the program's words", "[program][output]")
{
    const support::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "folder.png");
    write_text(folder / "empty.png", "");
    const std::string noise = "k\x93 no picture at all \x01\x02";
    struct Broken {
        std::string name, kind, head;
    };
    const std::vector<Broken> broken = {{"a.png", "PNG", "\x89PNG\r\n\x1a\n"},
                                        {"a.gif", "GIF", "GIF89a"},
                                        {"a.jpg", "JPEG", "\xff\xd8\xff\xe0"},
                                        {"a.tif", "TIFF", std::string("II*\0\x08", 5)},
                                        {"a.exr", "OpenEXR", "\x76\x2f\x31\x01"},
                                        {"a.hdr", "Radiance", "#?RADIANCE\n"},
                                        {"a.bmp", "BMP", "BM12"},
                                        {"a.ppm", "PPM", "P6\n"}};
    const auto told = [&](const std::string& name) {
        const support::Ended ended = run_in(folder, {"compare", name, name});
        INFO(name << "\n" << ended.err);
        CHECK(ended.status == 2);
        CHECK_THAT(ended.err, Catch::StartsWith("whittle: error: cannot read '" + name + "': ") &&
                                  !Catch::Contains("OpenImageIO"));
        CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
        return ended.err;
    };
    // The same without a program that loads the pictures' library each time.
    const auto told_here = [&](const std::string& name) -> std::string {
        try {
            image::Files().read(folder / name);
        } catch (const std::exception& error) {
            CHECK_THAT(error.what(),
                       Catch::StartsWith("cannot read '" + folder / name + "': ") && !Catch::Contains("OpenImageIO"));
            return error.what();
        }
        return "it was read";
    };
    CHECK_THAT(told("folder.png"), Catch::Contains("it is a folder"));
    CHECK_THAT(told("empty.png"), Catch::Contains("it is empty"));
    CHECK_THAT(told("missing.png"), Catch::Contains("No such file"));
    for (const auto& [name, kind, head] : broken) {
        write_text(folder / name, head);
        CHECK_THAT(told_here(name), Catch::Contains("the " + kind + " file is broken"));
        write_text(folder / name, noise);
        CHECK_THAT(told_here(name), Catch::Contains("it is no picture of a known kind"));
    }
    CHECK_THAT(told("a.png"), Catch::Contains("it is no picture of a known kind"));
    write_text(folder / "a.tga", noise);  // has no signature
    CHECK_THAT(told("a.tga"), Catch::Contains("the Targa file is broken"));
    write_text(folder / "scene.pov", "#version 3.7;\nplane { y, 0 pigment { image_map { tiff \"a.tif\" } } }\n");
    CHECK_THAT(run_in(folder, {"scene.pov"}).err,
               Catch::Contains("scene.pov:2:41: error: cannot read 'a.tif': it is no picture of a known kind"));
}

TEST_CASE("more threads than the machine has leave the console clean", "[program][output]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kPlainScene);
    const support::Ended ended = run_in(folder, {"scene.pov", "+W8", "+H6", "+WT9999", "-GS"});
    CHECK(ended.status == 0);
    CHECK(ended.err == "note: Work_Threads is 1 to 512: 9999 counts as 512\nscene.png  8x6\n");
}

TEST_CASE("a cyclic animation counts the frames that it renders", "[program][output]")
{
    const support::TemporaryFolder folder;
    write_text(folder / "scene.pov", kPlainScene);
    for (const char* console : {"--console=whittle", "--console=povray"}) {
        const support::Ended ended = run_in(folder, {"scene.pov", "+W8", "+H6", "+KFF3", "+KC", console});
        CHECK(ended.status == 0);
        CHECK_THAT(ended.err,
                   Catch::Contains("frame 3 of 3, clock 0.66") || Catch::Contains("Final Frame:        3\n"));
        CHECK_THAT(ended.err, !Catch::Contains("of 4,") && !Catch::Contains("Final Frame:        4"));
    }
}

TEST_CASE("compare explains itself, shows alpha where it differs and draws in the type of the name",
          "[program][output]")
{
    const support::TemporaryFolder folder;
    const support::Ended help = run_in(folder, {"compare", "--help"});
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    CHECK_THAT(help.out, Catch::StartsWith("usage: whittle compare A B ") && Catch::Contains("--tolerance n"));

    write_grey(folder / "a.png", 0);
    write_grey(folder / "b.png", 1);
    const support::Ended compared = run_in(folder, {"compare", "a.png", "b.png"});
    CHECK(compared.status == 1);
    CHECK_THAT(compared.out,
               Catch::Contains("pixel (3, 3): <128, 128, 128> alpha 255 and <128, 128, 128> alpha 0, 255 apart"));

    const std::pair<const char*, std::string> types[] = {{"d.jpg", "\xff\xd8\xff"}, {"d.JPEG", "\xff\xd8\xff"},
                                                         {"d.png", "\x89PNG"},      {"d.ppm", "P6"},
                                                         {"d.bmp", "BM"},           {"d", "\x89PNG"}};
    for (const auto& [name, signature] : types) {
        INFO(name);
        CHECK(run_in(folder, {"compare", "a.png", "b.png", "--out", name}).status == 1);
        CHECK_THAT(support::text_of(folder / name), Catch::StartsWith(signature));
    }
    CHECK(run_in(folder, {"compare", "a.png", "b.png", "--out", "d.tga"}).status == 1);
    CHECK(image::Files().read(folder / "d.tga").width == 4);
    const support::Ended other = run_in(folder, {"compare", "a.png", "b.png", "--out", "d.exr"});
    CHECK(other.status == 2);
    CHECK_THAT(other.err,
               Catch::Contains("--out wants a name that ends in .png, .ppm, .tga, .jpg or .bmp, found 'd.exr'"));
}

TEST_CASE("memory that is refused is told with what is needed and what is allowed", "[program]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "s.pov", kPlainScene);
    const auto limited = [&](const std::string& kilobytes, const char* size = "+W640 +H480") {
        return support::run_program(folder.path(), "/bin/sh",
                                    {"-c", "ulimit -v " + kilobytes + " && exec " WHITTLE_PROGRAM " s.pov " + size});
    };
    const support::Ended refused = limited("60000", "+W3000 +H2000");  // 96 MB of picture
    CHECK(refused.status == 75);
    CHECK_THAT(refused.err,
               Catch::Matches("whittle: error: memory is refused: [0-9.]+ (bytes|kB|MB) more are needed; [0-9.]+ MB "
                              "of the 61.4 MB that this process may have \\(ulimit -v\\) are in use\n"));
    CHECK(limited("400000").status == 0);
    // Whatever is refused first, a thread for one: it is said, and another try may go well.
    for (int kilobytes = 26000; kilobytes < 60000; kilobytes += 2000) {
        const support::Ended ended = limited(std::to_string(kilobytes));
        INFO(kilobytes << ": " << ended.err);
        CHECK((ended.status == 0 || (ended.status == 75 && (ended.err.find("memory is refused") != std::string::npos ||
                                                            ended.err.find("thread") != std::string::npos))));
    }
    // Stacks are no deeper than there is room for, and neither are the nests that they hold.
    support::write_text(folder / "s.pov",
                        std::string(kPlainScene) +
                            "#declare T = texture { pigment { rgb 1 } }\n"
                            "#for (I, 1, 2000) #declare T = texture { gradient x texture_map { [0 T] [1 "
                            "pigment { rgb 0 }] } } #end\nplane { z, 0 texture { T } }\n");
    const support::Ended nested = limited("400000");
    CHECK(nested.status == 1);
    CHECK_THAT(nested.err, Catch::Contains("s.pov:") && Catch::Contains("patterns lie inside of each other more than"));
}
