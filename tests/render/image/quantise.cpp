#include "render/image/levels/level_table.h"
#include "render/image/levels/quantise.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>

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

TEST_CASE("the depth is 1 to 16 bits", "[image][quantise]")
{
    CHECK(encoded(one_pixel(1, 0.5f, 0), TransferCurve::linear(), 3) == Levels{7, 4, 0});
    CHECK(encoded(one_pixel(1, 0.5f, 0), TransferCurve::linear(), 0) == Levels{1, 1, 0});
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

namespace {

/// A ramp from black to white, rounded to four levels.
std::string rows_of(Dither kind, const TransferCurve& curve, int rows)
{
    constexpr int kRamp = 48;
    Image ramp{kRamp, rows, {}};
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < kRamp; ++x) {
            const float v = (static_cast<float>(x) + 0.5f) / kRamp;
            ramp.pixels.insert(ramp.pixels.end(), {v, v, v, 0.0f});
        }
    Encoding encoding{{TransferCurve::linear(), curve}, 2};
    encoding.dither = kind;
    const Raster made = quantise(ramp, encoding);
    std::string out;
    for (std::size_t i = 0; i < made.samples.size(); i += 3) {
        out += static_cast<char>('0' + made.samples[i]);
        if ((i / 3 + 1) % kRamp == 0) out += ' ';
    }
    return out;
}

}  // namespace

TEST_CASE("dithering as POV-Ray 3.8 does it", "[image][dither]")
{
    // Printed from pictures of that program: 48 levels between black and white, Bits_Per_Color=2, File_Gamma=1.
    const TransferCurve plain = TransferCurve::linear();
    CHECK(rows_of(Dither::Atkinson, plain, 3) == "000000101111111111111121222222222222223233333333 "
                                                 "000000100110111111111121122122222222223223323333 "
                                                 "000010011011111111112112212222222222322332333333 ");
    CHECK(rows_of(Dither::Burkes, plain, 3) == "000000101101111111111121221222222222223233233333 "
                                               "000010010110111111112112122122222222322323323333 "
                                               "000100101011111111111221212222222222233232333333 ");
    CHECK(rows_of(Dither::JarvisJudiceNinke, plain, 3) == "000000101111111111111121222222222222223233333333 "
                                                          "000001001001111111111211211222222222232232233333 "
                                                          "000010011011011111112112212212222222322332332333 ");
    CHECK(rows_of(Dither::Stucki, plain, 3) == "000000101111111111111121222222222222223233333333 "
                                               "000010010010111111112112112122222222322322323333 "
                                               "000001010111011111111212122212222222232323332333 ");
    CHECK(rows_of(Dither::SierraThreeRows, plain, 3) == "000000101111111111111121222222222222223233333333 "
                                                        "000001001001111111111211211222222222232232233333 "
                                                        "000010101101111111112121221222222222323233233333 ");
    CHECK(rows_of(Dither::SierraTwoRows, plain, 3) == "000000101101111111111121221222222222223233233333 "
                                                      "000010010110111111112112122122222222322323323333 "
                                                      "000010110110111111112121221222222222233232333333 ");
    CHECK(rows_of(Dither::SierraLite, plain, 3) == "000001010110111111111212122122222222232323323333 "
                                                   "000100101011111111121121212222222223223232333333 "
                                                   "000010010101011111111211212122222222232232323333 ");
    CHECK(rows_of(Dither::FloydSteinbergLight, plain, 3) == "000001010111111111111212122222222222232323333333 "
                                                            "000100010101011111121112121212222223222323232333 "
                                                            "000001010110111111111212122122222222232323323333 ");
    CHECK(rows_of(Dither::Bayer2, plain, 2) == "000000010101011111111112121212222222222323232333 "
                                               "001010101011111111212121212222222232323232333333 ");
    CHECK(rows_of(Dither::Bayer3, plain, 3) == "000001001011011111112112112122122222223223233233 "
                                               "000100101101111111111211212212222222322323323333 "
                                               "010010110110111111121121221222222232232332333333 ");
    CHECK(rows_of(Dither::Bayer4, plain, 2) == "000000010101011111111112121212222222222323232333 "
                                               "001010101011111111212121212222222232323232333333 ");
}

TEST_CASE("blue noise gives every share of light, whatever the curve", "[image][dither]")
{
    for (const TransferCurve& curve : {TransferCurve::linear(), TransferCurve::srgb(), TransferCurve::bt709()})
        for (const float light : {0.01f, 0.2f, 0.5f, 0.83f}) {
            Image even{64, 64, {}};
            for (int i = 0; i < 64 * 64; ++i) even.pixels.insert(even.pixels.end(), {light, light, light, 0.0f});
            Encoding encoding{{TransferCurve::linear(), curve}, 1};
            encoding.dither = Dither::BlueNoise;
            double sum = 0.0;
            for (const std::uint16_t level : quantise(even, encoding).samples) sum += level;
            CHECK(sum / (3 * 64 * 64) == Approx(light).margin(0.0004));
        }
}

TEST_CASE("the curves of television", "[image][transfer]")
{
    CHECK(TransferCurve::bt709().encode(0.2f) == Approx(0.4337f).margin(1e-4));
    CHECK(TransferCurve::bt2020().encode(0.2f) == Approx(0.4334f).margin(2e-4));
    for (const TransferCurve& curve : {TransferCurve::bt709(), TransferCurve::bt2020()})
        for (const float x : {0.0f, 0.01f, 0.018f, 0.019f, 0.3f, 1.0f})
            CHECK(curve.decode(curve.encode(x)) == Approx(x).margin(2e-4));
}
