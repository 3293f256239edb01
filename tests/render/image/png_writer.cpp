#include "render/image/files.h"
#include "render/image/codecs/io_loader.h"
#include "render/image/codecs/write/png_writer.h"

#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>
#include <sstream>

using namespace image;

namespace {

Raster ramp(int channels, int bits)
{
    Raster raster{29, 17, channels, bits, {}};
    for (unsigned i = 0; i < static_cast<unsigned>(29 * 17 * channels); ++i)
        raster.samples.push_back(
            static_cast<std::uint16_t>(i * 40503u % (static_cast<unsigned>(raster.maximum()) + 1u)));
    return raster;
}

/// The entries of a PNG file in order, small ones with their bytes: "gAMA 0000b18f".
std::vector<std::string> entries(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(bytes.at(at))); };
    std::vector<std::string> found;
    for (std::size_t at = 8; at < bytes.size();) {
        const std::size_t size = byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
        std::ostringstream text;
        text << bytes.substr(at + 4, 4);
        if (text.str() != "IDAT") text << ' ';
        for (std::size_t i = 0; i < size && text.str().substr(0, 4) != "IDAT"; ++i)
            text << "0123456789abcdef"[byte(at + 8 + i) >> 4] << "0123456789abcdef"[byte(at + 8 + i) & 15];
        found.push_back(text.str());
        at += size + 12;
    }
    return found;
}

void check_same_meaning(const Picture& direct, const ReadResult& library)
{
    CHECK(direct.width == library.width);
    CHECK(direct.height == library.height);
    CHECK(direct.channels == library.channels);
    CHECK(direct.bits == library.bits);
    CHECK(direct.srgb == library.srgb);
    CHECK(direct.file_gamma == Approx(library.gamma).epsilon(1e-4));
    float off = 0.0f;
    for (std::size_t i = 0; i < direct.samples.size(); ++i)
        off = std::max(off, std::abs(direct.samples[i] - library.samples[i]));
    CHECK(off < 1e-6f);
}

}  // namespace

TEST_CASE("OpenImageIO reads a PNG as the same picture", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    IoLoader library;
    for (const int bits : {8, 16}) {
        for (const int channels : {1, 2, 3, 4}) {
            for (const TransferCurve& curve :
                 {TransferCurve::srgb(), TransferCurve::power(1.8f), TransferCurve::linear()}) {
                INFO(channels << " channels of " << bits << " bits, gamma " << curve.approximate_gamma());
                const Raster raster = ramp(channels, bits);
                const std::string path = folder / "direct.png";
                files.write(path, raster, FileType::Png, curve);
                ReadResult other{};
                REQUIRE(library.get().read(path.c_str(), other) == nullptr);
                check_same_meaning(files.read(path), other);
                library.get().release(other);
            }
        }
    }
}

TEST_CASE("a PNG has the entries that POV-Ray 3.7.0.10 writes, but for its offset, time and comment", "[image][files]")
{
    const support::TemporaryFolder folder;
    const Files files;
    const std::string path = folder / "picture.png", software = "tEXt 536f6674776172650057686974746c65";
    const auto written = [&](int channels, int bits, const TransferCurve& curve) {
        files.write(path, ramp(channels, bits), FileType::Png, curve);
        return entries(path);
    };
    using Entries = std::vector<std::string>;
    CHECK(written(3, 8, TransferCurve::srgb()) == Entries{"IHDR 0000001d000000110802000000", "gAMA 0000b18f", "sRGB 00",
                                                          "sBIT 080808", software, "IDAT", "IEND "});
    CHECK(written(3, 5, TransferCurve::srgb()) == Entries{"IHDR 0000001d000000110802000000", "gAMA 0000b18f", "sRGB 00",
                                                          "sBIT 050505", software, "IDAT", "IEND "});
    CHECK(written(4, 12, TransferCurve::power(1.8f)) ==
          Entries{"IHDR 0000001d000000111006000000", "gAMA 0000d904", "sBIT 0c0c0c0c", software, "IDAT", "IEND "});
    CHECK(written(1, 16, TransferCurve::linear()) ==
          Entries{"IHDR 0000001d000000111000000000", "gAMA 000186a0", "sBIT 10", software, "IDAT", "IEND "});
}

TEST_CASE("a full disk is an error", "[image][files]")
{
    if (!std::ifstream("/dev/full")) return;
    const auto written = [] {
        PngWriter writer("/dev/full", {29, 17, 3, 8, TransferCurve::srgb(), "test"});
        const Raster raster = ramp(3, 8);
        for (int row = 0; row < raster.height; ++row) writer.put(raster.at(0, row));
        writer.finish();
    };
    CHECK_THROWS_AS(written(), FileError);
}
