// Writers of our own, read again by OpenImageIO, which shares no code with them.
#include "render/image/codecs/write/bmp_writer.h"
#include "render/image/codecs/write/hdr_writer.h"
#include "render/image/codecs/io_loader.h"
#include "render/image/codecs/write/jpeg_writer.h"
#include "render/image/codecs/write/targa_writer.h"
#include "render/image/files.h"
#include "render/image/pixels/passing_failure.h"

#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <limits>
#include <random>

using namespace image;

namespace {

/// What OpenImageIO makes of a file.
class Read {
public:
    Read(IoLoader& library, const std::string& path) : library_(library)
    {
        INFO(path);
        REQUIRE(library.get().read(path.c_str(), result) == nullptr);
    }
    Read(const Read&) = delete;
    Read& operator=(const Read&) = delete;
    ~Read() { library_.get().release(result); }
    ReadResult result{};

private:
    IoLoader& library_;
};

/// Runs of all lengths, and pixels that are each another.
Raster runs(int width, int height, int channels, std::uint32_t seed)
{
    std::mt19937 random(seed);
    Raster raster{width, height, channels, 8, {}};
    std::vector<std::uint16_t> pixel(static_cast<std::size_t>(channels));
    std::uint32_t left = 0;
    for (int i = 0; i < width * height; ++i) {
        if (left == 0 || --left == 0) {
            for (std::uint16_t& level : pixel) level = static_cast<std::uint16_t>(random() % 3 * 127);
            left = random() % 2 != 0 ? 1 : 1 + static_cast<std::uint32_t>(random() % 300);
        }
        raster.samples.insert(raster.samples.end(), pixel.begin(), pixel.end());
    }
    return raster;
}

void check_same(const ReadResult& read, const Raster& raster, double most)
{
    REQUIRE(read.width == raster.width);
    REQUIRE(read.height == raster.height);
    REQUIRE(read.channels == raster.channels);
    double off = 0.0;
    for (std::size_t i = 0; i < raster.samples.size(); ++i)
        off = std::max(off, std::abs(255.0 * static_cast<double>(read.samples[i]) - raster.samples[i]));
    CHECK(off <= most);
}

std::size_t length_of(const std::string& path)
{
    return static_cast<std::size_t>(std::ifstream(path, std::ios::binary | std::ios::ate).tellg());
}

}  // namespace

TEST_CASE("Targa and BMP hold each level in its place", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    IoLoader library;
    for (std::uint32_t seed = 0; seed < 12; ++seed)
        for (const int channels : {3, 4})
            for (const FileType type : {FileType::Targa, FileType::TargaRunLength, FileType::Bmp}) {
                INFO("seed " << seed << ", " << channels << " channels");
                const int width = static_cast<int>(1 + seed * seed * 5);
                const Raster raster = runs(width, 7, channels, seed);
                const std::string path = folder / (type == FileType::Bmp ? "a.bmp" : "a.tga");
                files.write(path, raster, type, TransferCurve::power(1.8f));
                const Read read(library, path);
                check_same(read.result, raster, 1e-4);
                if (type != FileType::Bmp) CHECK(read.result.gamma == Approx(1.8));
            }
}

TEST_CASE("runs of a Targa file stay within their rows and are as short as POV-Ray's", "[image][files]")
{
    const support::TemporaryFolder folder;
    Raster raster{20, 10, 3, 8, std::vector<std::uint16_t>(600, 7)};
    Files().write(folder / "a.tga", raster, FileType::TargaRunLength, TransferCurve::srgb());
    constexpr std::size_t kAround = 18 + 495 + 26;  // header, extension area, footer
    CHECK(length_of(folder / "a.tga") == kAround + std::size_t{10} * 4);
    raster.samples[3] = 8;  // 1 pixel, 1 that differs, 18
    Files().write(folder / "a.tga", raster, FileType::TargaRunLength, TransferCurve::srgb());
    CHECK(length_of(folder / "a.tga") == kAround + std::size_t{9} * 4 + 7 + 4);
}

TEST_CASE("JPEG files keep what their quality allows", "[image][files]")
{
    const support::TemporaryFolder folder;
    const std::string path = folder / "a.jpg";
    IoLoader library;
    for (const int channels : {1, 3}) {
        Raster raster{61, 43, channels, 8, {}};
        for (int i = 0; i < 61 * 43; ++i)
            for (int c = 0; c < channels; ++c)
                raster.samples.push_back(static_cast<std::uint16_t>(40 + i % 61 + (c + 1) * (i / 61)));
        std::size_t before = 0;
        for (const int quality : {20, 100}) {
            Files().write(path, raster, FileType::Jpeg, TransferCurve::srgb(), quality);
            check_same(Read(library, path).result, raster, quality == 100 ? 2.0 : 24.0);
            CHECK(length_of(path) > before);
            before = length_of(path);
        }
    }
}

TEST_CASE("Radiance files hold light of any brightness to a part in 128 of the brightest channel", "[image][files]")
{
    const support::TemporaryFolder folder;
    const std::string path = folder / "a.hdr";
    IoLoader library;
    std::mt19937 random(3);
    for (const int width : {1, 7, 8, 131, 700}) {
        INFO("width " << width);
        std::vector<float> levels;
        for (int i = 0; i < 3 * width; ++i) {
            const float bright = std::ldexp(1.0f, static_cast<int>(random() % 160) - 80);
            levels.push_back(i / 3 % 50 > 20 ? 0.25f : bright * static_cast<float>(random() % 1000) / 999.0f);
        }
        const std::vector<float> odd{-1.0f, 0.5f, 0.0f, 0.0f, 0.0f, 0.0f};
        HdrWriter writer(path, {width, 3, 3, 32, {}, "test"});
        std::vector<float> row = levels;
        writer.put(row.data());
        std::copy_n(odd.begin(), std::min<std::size_t>(odd.size(), row.size()), row.begin());
        writer.put(row.data());
        row[0] = std::numeric_limits<float>::infinity();
        writer.put(row.data());
        writer.finish();
        const Read read(library, path);
        const Picture own = Files().read(path);
        REQUIRE(read.result.width == width);
        REQUIRE(read.result.height == 3);
        for (int i = 0; i < width; ++i) {
            const float* pixel = &levels[static_cast<std::size_t>(3 * i)];
            const float brightest = std::max({pixel[0], pixel[1], pixel[2]});
            for (int c = 0; c < 3; ++c) {
                const auto at = static_cast<std::size_t>(3 * i + c);
                REQUIRE(std::abs(read.result.samples[at] - pixel[c]) <= brightest / 128.0f);
                REQUIRE(std::abs(own.samples[at] - pixel[c]) <= brightest / 128.0f);
            }
        }
        const float* second = read.result.samples + 3 * width;
        CHECK(second[0] <= 0.5f / 256.0f);  // less than none is none
        CHECK(second[1] == Approx(0.5).epsilon(0.01));
        CHECK(second[3 * width] > 1e37f);
    }
}

TEST_CASE("a full disk is a failure that may pass, whatever the type", "[image][files]")
{
    if (!std::ifstream("/dev/full")) return;
    const FileShape shape{29, 17, 3, 8, TransferCurve::srgb(), "test"};
    const std::string full = "/dev/full";
    const auto fill = [&](auto&& sink) {
        const std::vector<std::uint16_t> row(29 * 3, 200);
        for (int y = 0; y < shape.height; ++y) sink.put(row.data());
        sink.finish();
    };
    CHECK_THROWS_AS(fill(TargaWriter(full, shape, false)), PassingFailure);
    CHECK_THROWS_AS(fill(TargaWriter(full, shape, true)), PassingFailure);
    CHECK_THROWS_AS(fill(BmpWriter(full, shape)), PassingFailure);
    CHECK_THROWS_AS(fill(*jpeg_sink(full, shape, 90)), PassingFailure);
    const auto light = [&] {
        HdrWriter writer(full, shape);
        const std::vector<float> row(29 * 3, 0.5f);
        for (int y = 0; y < shape.height; ++y) writer.put(row.data());
        writer.finish();
    };
    CHECK_THROWS_AS(light(), PassingFailure);
    CHECK_THROWS_AS(jpeg_sink("/nowhere/a.jpg", shape, 90), FileError);
}
