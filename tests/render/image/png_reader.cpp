#include "render/image/codecs/read/direct_readers.h"
#include "render/image/codecs/io_loader.h"

#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

using namespace image;

namespace {

struct Kind {
    int color_type, depth, channels;
    bool clear;  ///< with a tRNS entry
};

constexpr int kWidth = 37, kHeight = 5;

/// Written by libpng with nothing but what `kind` says; samples packed as the file has them, most significant bits
/// first.
void write_file(const std::string& path, const Kind& kind)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    std::FILE* file = std::fopen(path.c_str(), "wb");
    REQUIRE(file != nullptr);
    png_init_io(png, file);
    png_set_IHDR(png, info, kWidth, kHeight, kind.depth, kind.color_type, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> palette;
        std::vector<png_byte> alpha;
        for (int i = 0; i < 1 << kind.depth; ++i) {
            palette.push_back(
                {static_cast<png_byte>(i * 7), static_cast<png_byte>(255 - i), static_cast<png_byte>(i * 31)});
            if (i < 3) alpha.push_back(static_cast<png_byte>(i * 100));
        }
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
        if (kind.clear) png_set_tRNS(png, info, alpha.data(), static_cast<int>(alpha.size()), nullptr);
    } else if (kind.clear) {
        const auto level = static_cast<png_uint_16>(kind.depth == 16 ? 0x0101 : 1);
        const png_color_16 clear{0, level, level, level, level};
        png_set_tRNS(png, info, nullptr, 0, &clear);
    }
    png_write_info(png, info);
    std::vector<png_byte> row(static_cast<std::size_t>((kWidth * kind.channels * kind.depth + 7) / 8));
    for (std::uint32_t y = 0, seed = 1; y < kHeight; ++y) {
        for (png_byte& byte : row) byte = static_cast<png_byte>((seed = seed * 1664525u + 1013904223u) >> 24);
        if (y == 1) std::fill(row.begin(), row.end(), png_byte{1});  // the clear colour
        png_write_row(png, row.data());
    }
    png_write_end(png, info);
    std::fclose(file);
    png_destroy_write_struct(&png, &info);
}

/// Sample i of all pixels, from the palette or not.
float shown(const Picture& picture, std::size_t i)
{
    const auto channels = static_cast<std::size_t>(picture.channels);
    const auto pixel = static_cast<int>(i / channels);
    return picture.at(pixel % picture.width, pixel / picture.width)[i % channels];
}

}  // namespace

TEST_CASE("every kind of PNG is read as OpenImageIO reads it", "[image][files]")
{
    const support::TemporaryFolder folder;
    const std::string path = folder / "kind.png";
    IoLoader library;
    std::vector<Kind> kinds;
    for (const bool clear : {false, true}) {
        for (const int depth : {1, 2, 4, 8, 16}) kinds.push_back({PNG_COLOR_TYPE_GRAY, depth, 1, clear});
        for (const int depth : {1, 2, 4, 8}) kinds.push_back({PNG_COLOR_TYPE_PALETTE, depth, 1, clear});
        for (const int depth : {8, 16}) kinds.push_back({PNG_COLOR_TYPE_RGB, depth, 3, clear});
    }
    for (const int depth : {8, 16})
        kinds.push_back({PNG_COLOR_TYPE_GRAY_ALPHA, depth, 2, false}),
            kinds.push_back({PNG_COLOR_TYPE_RGB_ALPHA, depth, 4, false});
    for (const Kind& kind : kinds) {
        INFO("colour type " << kind.color_type << ", " << kind.depth << " bits" << (kind.clear ? ", tRNS" : ""));
        write_file(path, kind);
        const auto picture = decode_directly(path, bytes_of_file(path));
        REQUIRE(picture);
        CHECK(picture->indices.empty() == (kind.color_type != PNG_COLOR_TYPE_PALETTE));
        ReadResult other{};
        REQUIRE(library.get().read(path.c_str(), other) == nullptr);
        CHECK(picture->bits == other.bits);
        const bool drawn = kind.clear && kind.color_type == PNG_COLOR_TYPE_RGB;  // one clear colour: not for POV-Ray
        REQUIRE(picture->channels == other.channels - (drawn ? 1 : 0));
        const auto channels = static_cast<std::size_t>(other.channels);
        std::vector<float> samples;
        for (std::size_t i = 0; i < picture->count() * channels; ++i)
            if (!drawn || i % channels != 3) samples.push_back(other.samples[i]);
        library.get().release(other);
        float most = 0.0f;  // OpenImageIO multiplies by 1 / 255, which is not the same to the last bit
        for (std::size_t i = 0; i < samples.size(); ++i)
            most = std::max(most, std::abs(shown(*picture, i) - samples[i]));
        CHECK(most <= 6.0e-8f);
    }
}

TEST_CASE("a broken PNG is told from a whole one", "[image][files]")
{
    const support::TemporaryFolder folder;
    const std::string path = folder / "broken.png";
    write_file(path, {PNG_COLOR_TYPE_RGB, 8, 3, false});
    std::ifstream in(path, std::ios::binary);
    const ByteList whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    CHECK(decode_png(whole).width == kWidth);
    for (std::size_t length = 0; length + 12 < whole.size(); length += 5)
        CHECK_THROWS_AS(decode_png({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}), FileError);
    ByteList remark = {whole.begin(),
                       whole.begin() + 33};  // signature and header, then a chunk that is said to have 2 GB
    for (const std::uint8_t byte : ByteList{0x7f, 0xff, 0xff, 0xf0, 't', 'E', 'X', 't', 'a'}) remark.push_back(byte);
    CHECK_THROWS_WITH(decode_png(remark), "the PNG file is broken (it ends too early)");
    ByteList huge = whole;
    huge[18] = huge[22] = 0x0f;  // 4000 pixels each way
    CHECK_THROWS_WITH(decode_png(huge), "the PNG file is broken (its sizes do not fit its length)");
    for (std::size_t at = 0; at < whole.size(); ++at) {
        ByteList changed = whole;
        changed[at] ^= 0x40;
        try {
            const Picture picture = decode_png(changed);
            CHECK(picture.samples.size() < 100'000'000);
        } catch (const FileError& error) {
            CHECK(std::string(error.what()).find("PNG") != std::string::npos);
        }
    }
}
