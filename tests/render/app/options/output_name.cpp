#include "render/app/output/output_name.h"

#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

using namespace app;

namespace {

std::string path_of(const std::string& scene, const std::string& given, image::FileType type = image::FileType::Png)
{
    Settings settings;
    settings.input_file = scene;
    settings.output_file = given;
    settings.file_type = type;
    const FrameList list = frames_of(settings);
    return output_path(settings, list, list.frames[0]);
}

}  // namespace

TEST_CASE("the picture stands beside the scene unless +O says otherwise", "[app][output]")
{
    CHECK(path_of("d.pov", "") == "d.png");
    CHECK(path_of("sub/d.pov", "") == "sub/d.png");
    CHECK(path_of("sub/d.old.pov", "", image::FileType::Jpeg) == "sub/d.old.jpg");
    CHECK(path_of("sub/d.pov", "out/") == "out/d.png");
    CHECK(path_of("sub/d.pov", "out/.png") == "out/d.png");
}

TEST_CASE("the extension of a given name", "[app][output]")
{
    CHECK(path_of("d.pov", "x.png") == "x.png");
    CHECK(path_of("d.pov", "x") == "x.png");
    CHECK(path_of("d.pov", "x.") == "x.png");
    CHECK(path_of("d.pov", "x.foo") == "x.foo.png");
    CHECK(path_of("d.pov", "x.PNG") == "x.PNG.png");
    CHECK(path_of("d.pov", "x.png", image::FileType::Targa) == "x.png.tga");
}

TEST_CASE("without its slash a folder is a name like any other, as in POV-Ray", "[app][output]")
{
    const support::TemporaryFolder folder;
    CHECK(path_of("sub/d.pov", folder.path()) == folder.path() + ".png");
    CHECK(path_of("sub/d.pov", folder.path() + "/") == folder / "d.png");
}

TEST_CASE("standard output", "[app][output]")
{
    CHECK(path_of("d.pov", "-").empty());
    CHECK(path_of("d.pov", "stdout").empty());
}

TEST_CASE("frames are numbered with the digits of the last", "[app][output]")
{
    const auto names = [](int last, bool cyclic) {
        Settings settings;
        settings.input_file = "x.pov";
        settings.final_frame = last;
        settings.cyclic = cyclic;
        const FrameList list = frames_of(settings);
        return std::pair{output_path(settings, list, list.frames.front()),
                         output_path(settings, list, list.frames.back())};
    };
    CHECK(names(3, false) == std::pair<std::string, std::string>{"x1.png", "x3.png"});
    CHECK(names(9, true) == std::pair<std::string, std::string>{"x01.png", "x09.png"});
    CHECK(names(10, false) == std::pair<std::string, std::string>{"x01.png", "x10.png"});
}
