#include "render/image/codecs/read/direct_readers.h"
#include "render/image/codecs/shared/little_endian.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace image;

namespace {

/// A file of the usual header: `colors` entries (200 - i, i, 7) of a palette, then `pixels` as they are.
ByteList bmp(int width, int height, unsigned bits, unsigned packing, unsigned colors, const ByteList& pixels)
{
    std::string text = "BM";
    image::add_four(text, 0);
    image::add_four(text, 0);
    image::add_four(text, 54 + 4 * colors);
    image::add_four(text, 40);
    image::add_four(text, static_cast<std::uint32_t>(width));
    image::add_four(text, static_cast<std::uint32_t>(height));
    image::add_two(text, 1);
    image::add_two(text, bits);
    image::add_four(text, packing);
    text.resize(46);
    image::add_four(text, colors);
    image::add_four(text, 0);
    for (unsigned i = 0; i < colors; ++i) {
        const unsigned level = i % 200;
        text += {7, static_cast<char>(level), static_cast<char>(200 - level), 0};
    }
    ByteList out(text.begin(), text.end());
    out.insert(out.end(), pixels.begin(), pixels.end());
    return out;
}

int level_of(const Picture& picture, int x, int y, std::size_t channel)
{
    return static_cast<int>(std::lround(255.0f * picture.at(x, y)[channel]));
}

std::vector<int> row(const Picture& picture, int y)
{
    const auto first = picture.indices.begin() + std::ptrdiff_t{y} * picture.width;
    return {first, first + picture.width};
}

}  // namespace

TEST_CASE("BMP pixels of 1, 4 and 8 bits are places in the palette, rows from below", "[image][files]")
{
    std::mt19937 random(7);
    for (const unsigned bits : {1u, 4u, 8u})
        for (const int width : {1, 3, 8, 13}) {
            INFO(bits << " bits, " << width << " wide");
            const std::size_t length = (static_cast<std::size_t>(width) * bits + 31) / 32 * 4;
            ByteList pixels(3 * length);
            for (std::uint8_t& byte : pixels) byte = static_cast<std::uint8_t>(random());
            for (const bool from_above : {false, true}) {
                const auto picture = decode_bmp(bmp(width, from_above ? -3 : 3, bits, 0, 1u << bits, pixels));
                REQUIRE(picture);
                REQUIRE(picture->channels == 3);
                REQUIRE(picture->palette.size() == std::size_t{4} << bits);
                for (int y = 0; y < 3; ++y)
                    for (int x = 0; x < width; ++x) {
                        const std::size_t start = static_cast<std::size_t>(from_above ? y : 2 - y) * length;
                        unsigned place = 0;  // bit by bit
                        for (unsigned b = 0; b < bits; ++b) {
                            const std::size_t bit = static_cast<std::size_t>(x) * bits + b;
                            place = 2 * place + (pixels[start + bit / 8] >> (7 - bit % 8) & 1u);
                        }
                        REQUIRE(row(*picture, y)[static_cast<std::size_t>(x)] == static_cast<int>(place));
                        REQUIRE(level_of(*picture, x, y, 0) == static_cast<int>(200 - place % 200));
                        REQUIRE(level_of(*picture, x, y, 1) == static_cast<int>(place % 200));
                    }
            }
        }
}

TEST_CASE("a place that the palette of a BMP lacks is black", "[image][files]")
{
    const auto picture = decode_bmp(bmp(4, 1, 8, 0, 3, {0, 2, 3, 255}));
    REQUIRE(picture);
    CHECK(level_of(*picture, 1, 0, 0) == 198);
    for (const int x : {2, 3})
        for (const std::size_t c : {0u, 1u, 2u}) CHECK(level_of(*picture, x, 0, c) == 0);
}

TEST_CASE("runs of a BMP: repeated places, places as they are, rows that end early, steps", "[image][files]")
{
    // From below: three of 5, then 1 2 3 with a byte to fill up; one of 4, the row ends; a step; one of 6, the end.
    const ByteList runs{3, 5, 0, 3, 1, 2, 3, 0, 0, 0, 1, 4, 0, 0, 0, 2, 2, 1, 1, 6, 0, 1};
    const auto picture = decode_bmp(bmp(6, 4, 8, 1, 10, runs));
    REQUIRE(picture);
    CHECK(row(*picture, 3) == std::vector<int>{5, 5, 5, 1, 2, 3});
    CHECK(row(*picture, 2) == std::vector<int>{4, 9, 9, 9, 9, 9});
    CHECK(row(*picture, 1) == std::vector<int>{9, 9, 9, 9, 9, 9});
    CHECK(row(*picture, 0) == std::vector<int>{9, 9, 6, 9, 9, 9});
    // Of 4 bits two places by turns; five as they are take three bytes and one more.
    const auto half = decode_bmp(bmp(8, 1, 4, 2, 16, {3, 0x5a, 0, 5, 0x12, 0x34, 0x50, 0, 0, 1}));
    REQUIRE(half);
    CHECK(row(*half, 0) == std::vector<int>{5, 10, 5, 1, 2, 3, 4, 5});
    // What goes beyond a row is dropped.
    const auto over = decode_bmp(bmp(2, 1, 8, 1, 10, {5, 3, 4, 1, 0, 0}));
    REQUIRE(over);
    CHECK(row(*over, 0) == std::vector<int>{3, 3});
}

TEST_CASE("BMP colours are blue, green, red and alpha", "[image][files]")
{
    const auto plain = decode_bmp(bmp(1, 1, 24, 0, 0, {1, 2, 3, 0}));
    REQUIRE(plain);
    CHECK(plain->channels == 3);
    CHECK(level_of(*plain, 0, 0, 0) == 3);
    CHECK(level_of(*plain, 0, 0, 2) == 1);
    const auto clear = decode_bmp(bmp(1, 1, 32, 0, 0, {1, 2, 3, 4}));
    REQUIRE(clear);
    CHECK(clear->channels == 4);
    CHECK(level_of(*clear, 0, 0, 3) == 4);
    CHECK_FALSE(decode_bmp(bmp(1, 1, 16, 0, 0, {1, 2, 3, 4})));  // for OpenImageIO
    CHECK_FALSE(decode_bmp(bmp(1, 1, 32, 3, 0, {1, 2, 3, 4})));
}

TEST_CASE("a BMP of the first header has sizes of two bytes and a palette of three", "[image][files]")
{
    // 3x1 of 4 bits: 16 colours (i, 2i, 3i), then 1 2 3.
    ByteList bytes{'B', 'M', 0, 0, 0, 0, 0, 0, 0, 0, 14 + 12 + 48, 0, 0, 0, 12, 0, 0, 0, 3, 0, 1, 0, 1, 0, 4, 0};
    for (std::uint8_t i = 0; i < 16; ++i)
        for (const int times : {3, 2, 1}) bytes.push_back(static_cast<std::uint8_t>(times * i));
    bytes.insert(bytes.end(), {0x12, 0x30, 0, 0});
    const auto picture = decode_bmp(bytes);
    REQUIRE(picture);
    CHECK(row(*picture, 0) == std::vector<int>{1, 2, 3});
    CHECK(level_of(*picture, 2, 0, 0) == 3);
    CHECK(level_of(*picture, 2, 0, 2) == 9);
}

TEST_CASE("a broken BMP is told from a whole one", "[image][files]")
{
    const ByteList whole = bmp(6, 4, 8, 1, 10, {3, 5, 3, 2, 0, 0, 6, 1, 0, 0, 6, 2, 0, 0, 6, 4, 0, 1});
    for (std::size_t length = 2; length < whole.size(); ++length)
        CHECK_THROWS_AS(decode_bmp({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}), FileError);
    CHECK_THROWS_AS(decode_bmp(bmp(6, 4, 24, 0, 0, ByteList(4 * 20 - 3))), FileError);
    CHECK_THROWS_AS(decode_bmp(bmp(0, 4, 24, 0, 0, {})), FileError);
    CHECK_THROWS_AS(decode_bmp(bmp(100'000, 100'000, 8, 1, 2, {0, 1})), FileError);  // 10 GB of nothing
    CHECK_THROWS_AS(decode_bmp(bmp(4, INT32_MIN, 24, 0, 0, {})), FileError);
}
