#include "render/image/files.h"
#include "render/image/pixels/passing_failure.h"

#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace image;

namespace {

/// Values that exercise every sample of the given depth at least in part; deterministic.
Raster ramp(int width, int height, int channels, int bits)
{
    Raster raster{width, height, channels, bits, {}};
    const auto count = static_cast<std::size_t>(width * height * channels);
    for (std::size_t i = 0; i < count; ++i)
        raster.samples.push_back(
            static_cast<std::uint16_t>(i * 40503u % (static_cast<unsigned>(raster.maximum()) + 1u)));
    return raster;
}

std::string text_of(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

void check_round_trip(const Files& files, const std::string& path, const Raster& raster, FileType type)
{
    INFO(path << " with " << raster.channels << " channels of " << raster.bits << " bits");
    files.write(path, raster, type, TransferCurve::srgb());
    const Picture read = files.read(path);
    REQUIRE(read.width == raster.width);
    REQUIRE(read.height == raster.height);
    REQUIRE(read.channels == raster.channels);
    REQUIRE(read.bits == raster.bits);
    for (std::size_t i = 0; i < raster.samples.size(); ++i)
        REQUIRE(std::lround(static_cast<double>(read.samples[i]) * raster.maximum()) == raster.samples[i]);
}

}  // namespace

TEST_CASE("a written picture reads back as the same integers", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    for (const int bits : {8, 16}) {
        for (const int channels : {1, 3, 4})
            check_round_trip(files, folder / "picture.png", ramp(37, 11, channels, bits), FileType::Png);
    }
    for (const FileType type : {FileType::Ppm, FileType::PpmPlain})
        check_round_trip(files, folder / "picture.ppm", ramp(37, 11, 3, 8), type);
    check_round_trip(files, folder / "raw.tga", ramp(37, 11, 4, 8), FileType::Targa);
    check_round_trip(files, folder / "runs.tga", ramp(37, 11, 3, 8), FileType::TargaRunLength);
    check_round_trip(files, folder / "picture.bmp", ramp(37, 11, 3, 8), FileType::Bmp);
}

TEST_CASE("a plain PPM has a pixel a line, a plain PGM a level", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    files.write(folder / "colors.ppm", Raster{1, 2, 3, 16, {1, 2, 65535, 0, 300, 4}}, FileType::PpmPlain,
                TransferCurve::linear());
    const std::string colors = text_of(folder / "colors.ppm");
    CHECK(colors.starts_with("P3\n#"));
    CHECK(colors.ends_with("\n1 2\n65535\n1 2 65535\n0 300 4\n"));
    files.write(folder / "greys.pgm", Raster{2, 1, 1, 8, {7, 255}}, FileType::PpmPlain, TransferCurve::linear());
    const std::string greys = text_of(folder / "greys.pgm");
    CHECK(greys.starts_with("P2\n#"));
    CHECK(greys.ends_with("\n2 1\n255\n7\n255\n"));
}

TEST_CASE("the same picture gives the same bytes", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    files.write(folder / "one.png", ramp(64, 48, 3, 8), FileType::Png, TransferCurve::srgb());
    files.write(folder / "two.png", ramp(64, 48, 3, 8), FileType::Png, TransferCurve::srgb());
    CHECK(text_of(folder / "one.png") == text_of(folder / "two.png"));
}

TEST_CASE("a PNG says which curve it was stored with", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    files.write(folder / "srgb.png", ramp(4, 4, 3, 8), FileType::Png, TransferCurve::srgb());
    CHECK(files.read(folder / "srgb.png").srgb);
    files.write(folder / "power.png", ramp(4, 4, 3, 8), FileType::Png, TransferCurve::power(1.8f));
    const Picture power = files.read(folder / "power.png");
    CHECK_FALSE(power.srgb);
    CHECK(power.file_gamma == Approx(1.8).epsilon(1e-4));
}

TEST_CASE("light above 1 survives in OpenEXR", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    FileSettings settings;
    settings.type = FileType::OpenExr;
    settings.encoding.alpha = true;
    files.write(folder / "bright.exr", Image{1, 1, {5.0f, 0.5f, 0.25f, 0.75f}, 0}, settings);
    const Picture read = files.read(folder / "bright.exr");
    REQUIRE(read.channels == 4);
    CHECK(read.bits == 32);
    CHECK(std::get<Samples::Floats>(read.samples.kept) == std::vector<float>{5.0f, 0.5f, 0.25f, 0.25f});
}

TEST_CASE("a picture that cannot be written leaves the old one and nothing else", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    std::ofstream(folder / "old.png") << "old";
    const Raster empty{0, 0, 3, 8, {}};
    CHECK_THROWS_AS(files.write(folder / "old.png", empty, FileType::Png, TransferCurve::srgb()), FileError);
    CHECK(text_of(folder / "old.png") == "old");
    CHECK(folder.names() == std::vector<std::string>{"old.png"});
    CHECK_THROWS_AS(files.write(folder / "missing/new.png", ramp(4, 4, 3, 8), FileType::Png, TransferCurve::srgb()),
                    FileError);
}

TEST_CASE("a file that is no picture is named in the message", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    std::ofstream(folder / "text.png") << "no picture";
    CHECK_THROWS_WITH(files.read(folder / "text.png"), Catch::Contains("text.png"));
    CHECK_THROWS_WITH(files.read(folder / "none.png"), Catch::Contains("none.png"));
    // A header that promises 800 GB: nothing is made ready for them.
    std::ofstream(folder / "huge.ppm") << "P6 300000 300000 255\nabc";
    CHECK_THROWS_WITH(files.read(folder / "huge.ppm"), Catch::Contains("is broken"));
}

TEST_CASE("a picture that went after it was found may come with another try, a broken one never", "[image]")
{
    const support::TemporaryFolder folder;
    const std::string gone = folder / "gone.png", broken = folder / "broken.png";
    CHECK_THROWS_AS(Files().read(gone), PassingFailure);
    std::ofstream(broken) << "no picture";
    try {
        Files().read(broken);
        FAIL("it has been read");
    } catch (const PassingFailure&) {
        FAIL("another try would bring the same");
    } catch (const FileError& error) {
        CHECK(std::string(error.what()).find("it is no picture") != std::string::npos);
    }
}
