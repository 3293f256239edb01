#include "render/app/compare_command.h"

#include "render/image/files.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace app;

namespace {

/// A 10x10 picture, all grey but for `changed` pixels that are black.
void write(const std::string& path, int changed)
{
    image::Raster raster{10, 10, 3, 8, std::vector<std::uint16_t>(300, 128)};
    for (int i = 0; i < 3 * changed; ++i) raster.samples[static_cast<std::size_t>(i)] = 0;
    image::Files().write(path, raster, image::FileType::Png, image::TransferCurve::srgb());
}

}  // namespace

TEST_CASE("the exit status of compare follows tolerance and share", "[app][compare]")
{
    const support::TemporaryFolder folder;
    const std::string a = folder / "a.png", b = folder / "b.png", c = folder / "c.png";
    write(a, 0);
    write(b, 1);
    write(c, 2);
    CHECK(compare_command({a, a}) == 0);
    CHECK(compare_command({a, b}) == 0);  // 99 of 100 pixels
    CHECK(compare_command({a, c}) == 1);
    CHECK(compare_command({a, c, "--share", "0.98"}) == 0);
    CHECK(compare_command({a, b, "--share=1"}) == 1);
    CHECK(compare_command({a, c, "--share=1", "--tolerance", "128"}) == 0);
}

TEST_CASE("compare draws the difference", "[app][compare]")
{
    const support::TemporaryFolder folder;
    write(folder / "a.png", 0);
    write(folder / "b.png", 2);
    CHECK(compare_command({folder / "a.png", folder / "b.png", "--out", folder / "diff.png"}) == 1);
    const image::Picture drawn = image::Files().read(folder / "diff.png");
    CHECK(drawn.at(0, 0)[0] == 1.0f);
    CHECK(drawn.at(2, 0)[0] == Approx(32.0 / 255.0));
}

TEST_CASE("compare --flip draws where a difference is seen", "[app][compare]")
{
    const support::TemporaryFolder folder;
    write(folder / "a.png", 0);
    write(folder / "b.png", 2);
    CHECK(compare_command({folder / "a.png", folder / "b.png", "--flip", "--out=" + (folder / "flip.png")}) == 1);
    const image::Picture drawn = image::Files().read(folder / "flip.png");
    CHECK(drawn.at(0, 0)[0] > 0.5f);  // black where grey was
    CHECK(drawn.at(9, 9)[0] < 0.1f);  // far from it
    CHECK(compare_command({folder / "a.png", folder / "a.png", "--flip", "--out=" + (folder / "none.png")}) == 0);
    const image::Picture none = image::Files().read(folder / "none.png");
    for (int y = 0; y < none.height; ++y)
        for (int x = 0; x < none.width; ++x) CHECK(none.at(x, y)[0] == 0.0f);
}

TEST_CASE("what cannot be compared gives status 2", "[app][compare]")
{
    const support::TemporaryFolder folder;
    write(folder / "a.png", 0);
    CHECK(compare_command({folder / "a.png"}) == 2);
    CHECK(compare_command({folder / "a.png", folder / "none.png"}) == 2);
    CHECK(compare_command({folder / "a.png", folder / "a.png", "--tolerance", "many"}) == 2);
    CHECK(compare_command({folder / "a.png", folder / "a.png", "--loud"}) == 2);
}
