#include "render/image/levels/level_table.h"
#include "render/image/levels/quantise.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

using namespace image;

namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

Image one_pixel(float red, float green, float blue, float transmit = 0.0f)
{
    return {1, 1, {red, green, blue, transmit}};
}

std::vector<std::uint16_t> encoded(const Image& picture, const TransferCurve& file, int bits = 8, bool alpha = false,
                                   bool grey = false)
{
    return quantise(picture, {{TransferCurve::linear(), file}, bits, alpha, grey}).samples;
}

using Levels = std::vector<std::uint16_t>;

}  // namespace

TEST_CASE("eight bits of four levels under three file curves", "[image][quantise]")
{
    const Image levels{
        4, 1, {.125f, .125f, .125f, 0, .375f, .375f, .375f, 0, .625f, .625f, .625f, 0, .875f, .875f, .875f, 0}};
    CHECK(encoded(levels, TransferCurve::srgb()) == Levels{99, 99, 99, 165, 165, 165, 207, 207, 207, 240, 240, 240});
    CHECK(encoded(levels, TransferCurve::linear()) == Levels{32, 32, 32, 96, 96, 96, 159, 159, 159, 223, 223, 223});
    CHECK(encoded(levels, TransferCurve::power(2.2f)) ==
          Levels{99, 99, 99, 163, 163, 163, 206, 206, 206, 240, 240, 240});
}

TEST_CASE("what is no number or out of range is clamped", "[image][quantise]")
{
    CHECK(encoded(one_pixel(kNotANumber, kInfinite, -kInfinite), TransferCurve::srgb()) == Levels{0, 255, 0});
    CHECK(encoded(one_pixel(-0.1f, 1.2f, 1.0f), TransferCurve::power(2.2f), 16) == Levels{0, 65535, 65535});
    // background{rgb<I,-I,.5>} with I infinite
    CHECK(encoded(one_pixel(kInfinite, -kInfinite, 0.5f), TransferCurve::srgb()) == Levels{255, 0, 188});
}

TEST_CASE("a table of levels rounds as the curves do", "[image][quantise]")
{
    const TransferCurve linear = TransferCurve::linear(), srgb = TransferCurve::srgb(),
                        power = TransferCurve::power(2.2f), steep = TransferCurve::power(0.4f);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> spread(-30.0f, 3.0f);
    for (const auto& [working, file] : {std::pair{linear, srgb},
                                        {linear, power},
                                        {linear, linear},
                                        {power, power},
                                        {srgb, linear},
                                        {power, srgb},
                                        {steep, srgb},
                                        {linear, steep}})
        for (const int bits : {5, 7, 8}) {
            const Transcoder curve(working, file);
            const LevelTable table(curve, bits);
            int differ = 0, levels = 0;
            const auto compare = [&](float x) { differ += table(x) != quantised(curve.to_file(x), bits); };
            for (const float x : {0.0f, -0.0f, -1.0f, 1.0f, 1.5f, 1e30f, 1e-40f, kInfinite, -kInfinite, kNotANumber})
                compare(x);
            for (int i = 0; i < 20000; ++i) compare(std::exp2(spread(random)));
            // On both sides of where a level begins.
            for (int level = 1; level < 1 << bits; ++level) {
                float low = 0.0f, high = 4.0f;
                while (std::nextafter(low, high) < high) {
                    const float middle = low + 0.5f * (high - low);
                    (table(middle) >= level ? high : low) = middle;
                }
                levels += table(high) == level;
                const std::uint32_t at = std::bit_cast<std::uint32_t>(high);
                for (std::uint32_t k = at > 40 ? at - 40 : 0; k < at + 40; ++k) compare(std::bit_cast<float>(k));
            }
            INFO("working " << static_cast<int>(working.kind) << ' ' << working.gamma << " file "
                            << static_cast<int>(file.kind) << ' ' << file.gamma << " bits " << bits);
            CHECK(differ == 0);
            CHECK(levels == (1 << bits) - 1);
        }
}

TEST_CASE("the depth is 5 to 16 bits", "[image][quantise]")
{
    CHECK(encoded(one_pixel(1, 0.5f, 0), TransferCurve::linear(), 3) == Levels{31, 16, 0});
    CHECK(encoded(one_pixel(1, 0.5f, 0), TransferCurve::linear(), 12) == Levels{4095, 2048, 0});
    CHECK(encoded(one_pixel(1, 0.5f, 0), TransferCurve::linear(), 99) == Levels{65535, 32768, 0});
}

TEST_CASE("straight alpha of POV-Ray's cases, 16 bits, linear file", "[image][quantise][alpha]")
{
    const auto check = [](const Image& picture, double r, double g, double b, double a) {
        const Levels got = encoded(picture, TransferCurve::linear(), 16, true);
        const double expected[] = {r, g, b, a};
        for (std::size_t c = 0; c < 4; ++c) CHECK(got[c] / 65535.0 == Approx(expected[c]).margin(6e-5));
    };
    check(one_pixel(.25f, .125f, .05f, .5f), .5, .25, .1, .5);
    check(one_pixel(.5f, .5f, .5f, .9f), 1, 1, 1, .5);
    check(one_pixel(.5f, 0, 0, .9f), 1, 0, 0, .1485);
    check(one_pixel(0, 0, 0, 1), 0, 0, 0, 0);
    check(one_pixel(.2f, .4f, .6f, 0), .2, .4, .6, 1);
    check(one_pixel(.1f, .2f, .3f, .5f), .2, .4, .6, .5);
}

TEST_CASE("alpha is never gamma encoded", "[image][quantise][alpha]")
{
    CHECK(encoded(one_pixel(.25f, .25f, .25f, .5f), TransferCurve::srgb(), 8, true) == Levels{188, 188, 188, 128});
}

TEST_CASE("greyscale is the luminance of the working colour", "[image][quantise]")
{
    CHECK(encoded(one_pixel(1, 0, 0), TransferCurve::linear(), 16, false, true) == Levels{19464});
    CHECK(encoded(one_pixel(0, 1, 0), TransferCurve::linear(), 16, false, true) == Levels{38600});
    CHECK(encoded(one_pixel(0, 0, 1), TransferCurve::linear(), 8, false, true) == Levels{29});
}
