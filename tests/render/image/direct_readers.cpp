#include "render/image/codecs/read/direct_readers.h"

#include "render/image/files.h"
#include "render/image/codecs/io_loader.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>
#include <gif_lib.h>

#include <cmath>
#include <fstream>
#include <iterator>

using namespace image;

namespace {

/// Of 5x3 pixels;
/// \param order  bits 5 and 4 of its descriptor
ByteList targa(std::uint8_t kind, std::uint8_t bits, std::uint8_t order, const ByteList& rest)
{
    ByteList bytes(18);
    bytes[0] = 2;  // of identification
    bytes[2] = kind;
    bytes[12] = 5;
    bytes[14] = 3;
    bytes[16] = bits;
    bytes[17] = order;
    bytes.insert(bytes.end(), {'i', 'd'});
    bytes.insert(bytes.end(), rest.begin(), rest.end());
    return bytes;
}

ByteList counted(std::size_t size)
{
    ByteList bytes;
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(i));
    return bytes;
}

int level(const Picture& picture, int x, int y, std::size_t channel)
{
    return static_cast<int>(std::lround(255.0f * picture.at(x, y)[channel]));
}

}  // namespace

TEST_CASE("JPEG is read as OpenImageIO reads it", "[image][files]")
{
    const support::TemporaryFolder folder;
    const std::string path = folder / "picture.jpg";
    for (const int channels : {1, 3}) {
        INFO(channels << " channels");
        Raster raster{67, 41, channels, 8, {}};
        for (int i = 0; i < 67 * 41 * channels; ++i)
            raster.samples.push_back(static_cast<std::uint16_t>((i * 7 + i / 67 * 3) % 256));
        Files().write(path, raster, FileType::Jpeg, TransferCurve::srgb());
        const auto picture = decode_directly(path, bytes_of_file(path));
        REQUIRE(picture);
        ReadResult other{};
        IoLoader library;
        REQUIRE(library.get().read(path.c_str(), other) == nullptr);
        REQUIRE(picture->channels == other.channels);
        float most = 0.0f;
        for (std::size_t i = 0; i < picture->samples.size(); ++i)
            most = std::max(most, std::abs(picture->samples[i] - other.samples[i]));
        library.get().release(other);
        CHECK(most <= 6.0e-8f);
    }
}

TEST_CASE("a broken JPEG is told from a whole one", "[image][files]")
{
    const support::TemporaryFolder folder;
    const std::string path = folder / "picture.jpg";
    Raster raster{33, 33, 3, 8, {}};
    raster.samples.assign(33 * 33 * 3, 77);
    Files().write(path, raster, FileType::Jpeg, TransferCurve::srgb());
    const ByteList whole = bytes_of_file(path);
    CHECK(decode_jpeg(whole)->width == 33);
    for (std::size_t at = 2; at < whole.size(); at += at < 40 ? 1 : 7)  // the sizes stand in front
        for (const std::uint8_t change : ByteList{0x01, 0x40, 0xff}) {
            ByteList changed = whole;
            changed[at] ^= change;
            try {
                const auto picture = decode_jpeg(changed);
                CHECK((!picture || picture->samples.size() < 100'000'000));
            } catch (const FileError& error) {
                CHECK(std::string(error.what()).find("JPEG") != std::string::npos);
            }
        }
    CHECK_THROWS_AS(decode_jpeg({0xff, 0xd8, 0xff}), FileError);
    CHECK_THROWS_AS(decode_jpeg({}), FileError);
}

TEST_CASE("Targa pixels stand where the descriptor says", "[image][files]")
{
    const ByteList rest = counted(5 * 3 * 3);
    for (const std::uint8_t order : ByteList{0x00, 0x10, 0x20, 0x30}) {
        INFO("descriptor " << int{order});
        const Picture picture = decode_targa(targa(2, 24, order, rest));
        REQUIRE(picture.channels == 3);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 5; ++x) {
                const int row = order & 0x20 ? y : 2 - y, first = 3 * (5 * row + x);
                CHECK(level(picture, x, y, 2) == first);  // blue first
                CHECK(level(picture, x, y, 0) == first + 2);
            }
    }
    const Picture grey = decode_targa(targa(3, 8, 0x20, counted(15)));
    REQUIRE(grey.channels == 1);
    CHECK(level(grey, 1, 2, 0) == 11);
}

TEST_CASE("Targa colours of two bytes have five bits each and one of alpha", "[image][files]")
{
    ByteList rest = counted(30);
    rest[0] = 0xe0;  // red 29, green 15, blue 0 and alpha: 0xf5e0
    rest[1] = 0xf5;
    const Picture picture = decode_targa(targa(2, 16, 0x20, rest));
    REQUIRE(picture.channels == 4);
    CHECK(level(picture, 0, 0, 0) == 29 * 8);
    CHECK(level(picture, 0, 0, 1) == 15 * 8);
    CHECK(level(picture, 0, 0, 2) == 0);
    CHECK(level(picture, 0, 0, 3) == 255);
    CHECK(level(picture, 1, 0, 3) == 0);
    CHECK(decode_targa(targa(2, 15, 0x20, rest)).channels == 3);
    const Picture clear = decode_targa(targa(2, 32, 0x20, counted(60)));
    REQUIRE(clear.channels == 4);
    CHECK(level(clear, 1, 0, 0) == 6);
    CHECK(level(clear, 1, 0, 3) == 7);
}

TEST_CASE("PPM and PGM levels are shares of the largest", "[image][files]")
{
    const auto bytes = [](std::string_view text) { return ByteList(text.begin(), text.end()); };
    const Picture text = decode_pnm(bytes("P3 # a comment\n2 1\n100\n49 0 16 # another\n 96 100 7"));
    REQUIRE(text.channels == 3);
    CHECK(text.bits == 8);
    CHECK(text.at(0, 0)[0] == 49.0f / 100.0f);
    CHECK(text.at(1, 0)[2] == 7.0f / 100.0f);
    const Picture pairs = decode_pnm(bytes({"P5 2 1 1000 \x01\xf2\x03\xe8", 16}));
    REQUIRE(pairs.channels == 1);
    CHECK(pairs.bits == 16);
    CHECK(pairs.at(0, 0)[0] == 498.0f / 1000.0f);
    CHECK(pairs.at(1, 0)[0] == 1.0f);
    CHECK(decode_pnm(bytes("P6\n1 1\n255\nabc")).at(0, 0)[2] == 99.0f / 255.0f);
    for (const char* broken : {"P6\n2 1\n255\nabc", "P6\n0 1\n255\nabc", "P5 x", "P2 2 1 255 3", "P5 1 1 70000 ab",
                               "P5 99999999999 99999999 255 ab"})
        CHECK_THROWS_AS(decode_pnm(bytes(broken)), FileError);
}

TEST_CASE("a Radiance pixel is the middle of what its mantissa stands for", "[image][files]")
{
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    const auto whole = [&](const std::string& sizes, const ByteList& pixels) {
        ByteList bytes(header.begin(), header.end());
        bytes.insert(bytes.end(), sizes.begin(), sizes.end());
        bytes.insert(bytes.end(), pixels.begin(), pixels.end());
        return bytes;
    };
    const Picture plain = decode_hdr(whole("-Y 1 +X 3\n", {127, 0, 255, 128, 1, 1, 1, 1, 9, 9, 9, 0}));
    CHECK(plain.bits == 32);
    CHECK(plain.at(0, 0)[0] == 127.5f / 256.0f);
    CHECK(plain.at(0, 0)[1] == 0.5f / 256.0f);
    CHECK(plain.at(1, 0)[2] == 255.5f / 256.0f);  // the pixel before, once more
    CHECK(plain.at(2, 0)[0] == 0.0f);
    const ByteList packed = {2, 2, 0, 8, 136, 10, 3, 1, 2, 3, 133, 4, 136, 0, 136, 129};
    const Picture runs = decode_hdr(whole("-Y 1 +X 8\n", packed));
    CHECK(runs.at(7, 0)[0] == 10.5f / 128.0f);
    CHECK(runs.at(2, 0)[1] == 3.5f / 128.0f);
    CHECK(runs.at(3, 0)[1] == 4.5f / 128.0f);
    for (std::size_t length = 0; length < packed.size(); ++length)
        CHECK_THROWS_AS(decode_hdr(whole("-Y 1 +X 8\n", {packed.begin(), packed.begin() + std::ptrdiff_t(length)})),
                        FileError);
    CHECK_THROWS_AS(decode_hdr(whole("+X 1 -Y 1\n", {1, 2, 3, 4})), FileError);
    CHECK_THROWS_AS(decode_hdr(whole("-Y 2000000000 +X 2000000000\n", {1, 2, 3, 4})), FileError);
}

TEST_CASE("a Targa file of no pixels is no picture", "[image][files]")
{
    ByteList none = targa(2, 24, 0, counted(45));
    none[12] = 0;
    CHECK_THROWS_WITH(decode_targa(none), "the Targa file holds no picture");
}

TEST_CASE("Targa runs are unpacked", "[image][files]")
{
    // Nine times one colour, then four as they are, then two times another.
    const ByteList runs = {0x88, 1, 2, 3, 0x03, 10, 11, 12, 20, 21, 22, 30, 31, 32, 40, 41, 42, 0x81, 4, 5, 6};
    const ByteList whole = targa(10, 24, 0x20, runs);
    const Picture picture = decode_targa(whole);
    CHECK(level(picture, 3, 1, 0) == 3);
    CHECK(level(picture, 4, 1, 2) == 10);
    CHECK(level(picture, 2, 2, 1) == 41);
    CHECK(level(picture, 4, 2, 2) == 4);
    for (std::size_t length = 19; length < whole.size(); ++length)
        CHECK_THROWS_AS(decode_targa({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}), FileError);
}

namespace {

/// What giflib hands out, kept.
int append(GifFileType* file, const GifByteType* bytes, int count)
{
    auto* to = static_cast<ByteList*>(file->UserData);
    to->insert(to->end(), bytes, bytes + count);
    return count;
}

constexpr int kInterlaced[] = {0, 8, 4, 2, 6, 1, 3, 5, 7};

/// 5x9 pixels of 16 colours, pixel (x, y) at place (x + 3 y) mod 16; place 7 is clear.
ByteList gif(bool interlaced)
{
    ByteList out;
    int error = 0;
    GifFileType* file = EGifOpen(&out, append, &error);
    REQUIRE(file);
    GifColorType colors[16];
    for (int i = 0; i < 16; ++i)
        colors[i] = {static_cast<GifByteType>(16 * i), static_cast<GifByteType>(255 - i), static_cast<GifByteType>(i)};
    ColorMapObject* palette = GifMakeMapObject(16, colors);
    EGifSetGifVersion(file, true);
    REQUIRE(EGifPutScreenDesc(file, 5, 9, 4, 0, palette) == GIF_OK);
    const GraphicsControlBlock control{DISPOSAL_UNSPECIFIED, false, 0, 7};
    GifByteType block[4];
    EGifGCBToExtension(&control, block);
    REQUIRE(EGifPutExtension(file, GRAPHICS_EXT_FUNC_CODE, 4, block) == GIF_OK);
    REQUIRE(EGifPutImageDesc(file, 0, 0, 5, 9, interlaced, nullptr) == GIF_OK);
    std::vector<int> rows{0, 1, 2, 3, 4, 5, 6, 7, 8};
    if (interlaced) rows.assign(std::begin(kInterlaced), std::end(kInterlaced));
    for (const int y : rows) {
        GifPixelType row[5];
        for (int x = 0; x < 5; ++x) row[x] = static_cast<GifPixelType>((x + 3 * y) % 16);
        REQUIRE(EGifPutLine(file, row, 5) == GIF_OK);
    }
    GifFreeMapObject(palette);
    REQUIRE(EGifCloseFile(file, &error) == GIF_OK);
    return out;
}

}  // namespace

TEST_CASE("the places and colours of a GIF, rows in the order of the file", "[image][files]")
{
    for (const bool interlaced : {false, true}) {
        const Picture picture = decode_gif(gif(interlaced));
        REQUIRE(picture.width == 5);
        REQUIRE(picture.height == 9);
        REQUIRE(picture.channels == 4);
        REQUIRE(picture.palette.size() == 4 * 16);
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 5; ++x) {
                const int row = interlaced ? kInterlaced[y] : y, place = (x + 3 * row) % 16;
                CHECK(picture.indices[static_cast<std::size_t>(5 * y + x)] == place);
                CHECK(level(picture, x, y, 0) == 16 * place);
                CHECK(level(picture, x, y, 3) == (place == 7 ? 0 : 255));
            }
    }
}

TEST_CASE("a broken GIF is told from a whole one", "[image][files]")
{
    const ByteList whole = gif(false);
    for (std::size_t length = 0; length + 4 < whole.size(); ++length)
        CHECK_THROWS_AS(decode_gif({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}), FileError);
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const std::uint8_t change : ByteList{0x01, 0x40, 0xff}) {
            ByteList changed = whole;
            changed[at] ^= change;
            try {
                const Picture picture = decode_gif(changed);
                CHECK(picture.samples.size() < 100'000'000);
            } catch (const FileError& error) {
                CHECK_FALSE(std::string(error.what()).empty());
            }
        }
}
