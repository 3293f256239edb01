#include "render/kernel/antialias/antialias.h"

#include "numbers/float_power.h"
#include "render/kernel/antialias/jitter.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>

namespace {

using trace::Block;
using trace::SamplePosition;

/// A picture given as a formula, and how often each position was asked for.
struct Formula {
    std::function<float(double, double)> grey;
    std::map<std::pair<double, double>, int> asked;

    static void trace_grid(void* context, const trace::SampleGrid& grid, scene::Color* out, std::size_t stride)
    {
        for (int row = 0; row < grid.rows; ++row, out += stride)
            for (int column = 0; column < grid.columns; ++column) {
                const SamplePosition p = grid.first + SamplePosition(column, row);
                trace_few(context, &p, 1, out + column);
            }
    }

    static void trace_few(void* context, const SamplePosition* positions, int count, scene::Color* out)
    {
        auto& self = *static_cast<Formula*>(context);
        for (int i = 0; i < count; ++i) {
            ++self.asked[{positions[i].x, positions[i].y}];
            const float v = self.grey(positions[i].x, positions[i].y);
            out[i] = {v, v, v, 0, 0};
        }
    }
};

plan::Antialiasing settings(int method, int depth, double jitter)
{
    plan::Antialiasing s;
    s.method = method;
    s.depth = depth;
    s.jitter = jitter;
    s.threshold = 0.3;
    return s;
}

std::vector<float> run(Formula& formula, const plan::Antialiasing& s, const Block& block, bool in_order = false)
{
    std::vector<scene::Color> out(static_cast<std::size_t>(block.width * block.height));
    trace::AntialiasScratch scratch;
    trace::antialias(s, {}, block, {&Formula::trace_grid, &Formula::trace_few, &formula, in_order}, scratch,
                     out.data());
    std::vector<float> grey;
    for (const scene::Color& c : out) grey.push_back(c.red);
    return grey;
}

/// White to the right of x = edge.
Formula edge_at(double edge)
{
    return {[edge](double x, double) { return x > edge ? 1.0f : 0.0f; }, {}};
}

/// Values that differ by about the threshold from cell to cell, cells of a third of a pixel.
Formula grains(std::uint32_t seed)
{
    return {[seed](double x, double y) {
                std::minstd_rand random(seed + 7919u * static_cast<std::uint32_t>(std::floor(3 * x) + 100) +
                                        104729u * static_cast<std::uint32_t>(std::floor(3 * y) + 100));
                random.discard(3);
                return std::uniform_real_distribution<float>(0.2f, 0.5f)(random);
            },
            {}};
}

/// Method 1 as it is told: a pixel after the other, each compared with what has been made of those before it.
std::vector<float> pixel_by_pixel(const Formula& formula, const plan::Antialiasing& s, const Block& block)
{
    const trace::ColorDistance distance(s, {});
    std::map<std::pair<int, int>, float> now;
    std::map<std::pair<int, int>, bool> refined;
    const auto color = [](float v) { return scene::Color{v, v, v, 0, 0}; };
    const auto refine = [&](int column, int row) {
        if (column < block.left || row < block.top || std::exchange(refined[{column, row}], true)) return;
        float sum = now[{column, row}];
        for (int i = 0; i < s.depth * s.depth; ++i)
            sum +=
                formula.grey(column - 0.5 + (i % s.depth + 0.5) / s.depth, row - 0.5 + (i / s.depth + 0.5) / s.depth);
        now[{column, row}] = static_cast<float>(static_cast<double>(sum) / (s.depth * s.depth + 1));
    };
    for (int row = block.top - 1; row < block.top + block.height; ++row)
        for (int column = block.left - 1; column < block.left + block.width; ++column)
            now[{column, row}] = formula.grey(column, row);
    std::vector<float> out;
    for (int row = block.top; row < block.top + block.height; ++row)
        for (int column = block.left; column < block.left + block.width; ++column) {
            const auto differs = [&](int c, int r) {
                return distance.differ(color(now[{c, r}]), color(now[{column, row}]));
            };
            const bool left = differs(column - 1, row), up = differs(column, row - 1);
            if (left) refine(column - 1, row);
            if (up) refine(column, row - 1);
            if (left || up) refine(column, row);
        }
    for (int row = block.top; row < block.top + block.height; ++row)
        for (int column = block.left; column < block.left + block.width; ++column) out.push_back(now[{column, row}]);
    return out;
}

}  // namespace

TEST_CASE("without antialiasing every pixel is its centre sample, once", "[render][antialias]")
{
    Formula picture{[](double x, double y) { return static_cast<float>(x + 10 * y); }, {}};
    const auto grey = run(picture, settings(0, 3, 1), {2, 3, 4, 2});
    CHECK(grey == std::vector<float>{32, 33, 34, 35, 42, 43, 44, 45});
    CHECK(picture.asked.size() == 8);
}

TEST_CASE("method 1 refines both sides of an edge and keeps the centre's weight", "[render][antialias]")
{
    // The edge lies right of column 1's centre: columns 1 and 2 differ. Of column 1's nine samples the three at
    // x = 1 + 1/3 are white, the centre is black: 3 of 10. Column 2 is white throughout.
    Formula picture = edge_at(1.2);
    const auto grey = run(picture, settings(1, 3, 0), {0, 0, 4, 1});
    CHECK(grey[0] == 0.0f);
    CHECK(grey[1] == Approx(0.3));
    CHECK(grey[2] == 1.0f);
    CHECK(grey[3] == 1.0f);
}

TEST_CASE("method 1 never refines the border of a block", "[render][antialias]")
{
    // The edge lies between the left border and the block's first column: the border pixel keeps its centre sample.
    Formula picture = edge_at(-0.5);
    run(picture, settings(1, 3, 0), {0, 0, 3, 2});
    for (const auto& [position, count] : picture.asked) {
        CHECK(position.first >= -1.0);
        if (position.first < -0.5) CHECK(position.first == -1.0);
    }
}

TEST_CASE("a pixel is refined at most once", "[render][antialias]")
{
    Formula picture{[](double x, double y) {
                        return (static_cast<int>(std::floor(x + 0.5)) + static_cast<int>(std::floor(y + 0.5))) % 2 == 0
                                   ? 1.0f
                                   : 0.0f;
                    },
                    {}};
    run(picture, settings(1, 2, 0), {0, 0, 6, 6});
    for (const auto& [position, count] : picture.asked) REQUIRE(count == 1);
    // 7 x 7 centres with the border, and 4 samples in each of the 36 pixels.
    CHECK(picture.asked.size() == 49 + 36 * 4);
}

TEST_CASE("method 1 finds what a scan finds that waits for each pixel", "[render][antialias]")
{
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        const Block block{static_cast<int>(seed % 5), 3, 1 + static_cast<int>(seed % 23),
                          1 + static_cast<int>(seed % 17)};
        Formula together = grains(seed), in_order = grains(seed);
        const auto expected = pixel_by_pixel(together, settings(1, 3, 0), block);
        REQUIRE(run(together, settings(1, 3, 0), block) == expected);
        REQUIRE(run(in_order, settings(1, 3, 0), block, true) == expected);
        // In order nothing is asked for in vain, and together never less.
        for (const auto& [position, count] : in_order.asked) REQUIRE(together.asked.count(position) == 1);
    }
}

TEST_CASE("method 2 asks for every sample once, between pixels as well", "[render][antialias]")
{
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        INFO("seed " << seed);
        const Block block{2, 1, 1 + static_cast<int>(seed % 23), 1 + static_cast<int>(seed % 17)};
        Formula together = grains(seed), one_by_one = grains(seed);
        REQUIRE(run(together, settings(2, 3, 1), block) == run(one_by_one, settings(2, 3, 1), block, true));
        for (const auto& [position, count] : together.asked) REQUIRE(count == 1);
    }
}

TEST_CASE("a block takes what blocks beside it know, and nothing changes", "[render][antialias]")
{
    constexpr int kSide = 5, kAcross = 4, kDown = 3;
    for (const int method : {1, 2})
        for (std::uint32_t seed = 0; seed < 40; ++seed) {
            INFO("method " << method << " seed " << seed);
            Formula one_by_one = grains(seed), together = grains(seed);
            trace::AntialiasScratch scratch;
            for (int row = 0; row < kDown; ++row)
                for (int column = 0; column < kAcross; ++column) {
                    // The last blocks of rows and columns are cut off, and some blocks are another thread's.
                    if ((seed >> (row + column) & 7) == 7) continue;
                    const Block block{kSide * column, kSide * row, column + 1 < kAcross ? kSide : 2,
                                      row + 1 < kDown ? kSide : 3};
                    std::vector<scene::Color> out(static_cast<std::size_t>(block.width * block.height));
                    trace::antialias(settings(method, 3, 1), {}, block,
                                     {&Formula::trace_grid, &Formula::trace_few, &together}, scratch, out.data());
                    std::vector<float> grey;
                    for (const scene::Color& c : out) grey.push_back(c.red);
                    REQUIRE(grey == run(one_by_one, settings(method, 3, 1), block));
                }
            if (seed != 0) continue;
            // Where one thread has all blocks, no centre and no corner is traced twice.
            const double shift = method == 1 ? 0.0 : 0.5;
            for (const auto& [position, count] : together.asked)
                if (position.first - shift == std::round(position.first - shift) &&
                    position.second - shift == std::round(position.second - shift))
                    CHECK(count == 1);
        }
}

TEST_CASE("method 2 takes corners, and splits where they differ", "[render][antialias]")
{
    Formula flat{[](double, double) { return 0.25f; }, {}};
    for (const float v : run(flat, settings(2, 3, 1), {0, 0, 3, 2})) CHECK(v == 0.25f);
    CHECK(flat.asked.size() == 4 * 3);

    // Depth 1 never splits: an edge through the pixel gives the mean of the corners.
    Formula picture = edge_at(0.2);
    CHECK(run(picture, settings(2, 1, 0), {0, 0, 1, 1})[0] == 0.5f);
    // One split at depth 2: the left half sees no white; the right half is white at its right corners only.
    Formula again = edge_at(0.2);
    CHECK(run(again, settings(2, 2, 0), {0, 0, 1, 1})[0] == 0.25f);
}

TEST_CASE("jitter depends on the position alone and stays in its range", "[render][antialias]")
{
    for (int i = -50; i < 50; ++i) {
        const double x = 0.37 * i, y = 1.7 - 0.11 * i;
        const glm::dvec2 j = trace::jitter(x, y);
        REQUIRE(j == trace::jitter(x, y));
        REQUIRE(std::abs(j.x) <= 0.5);
        REQUIRE(std::abs(j.y) <= 0.5);
    }
    CHECK(trace::jitter(0.25, 0.5) != trace::jitter(0.5, 0.25));
}

TEST_CASE("colours differ by the sum over channels after the display curve", "[render][antialias]")
{
    const trace::ColorDistance distance(settings(1, 3, 0), {});
    const scene::Color black{}, dark{0.001f, 0.001f, 0.001f, 0, 0}, dim{0.0005f, 0, 0, 0, 0};
    CHECK_FALSE(distance.differ(black, black));
    CHECK_FALSE(distance.differ(black, dim));                       // 0.0005^(1/2.5) = 0.048
    CHECK_FALSE(distance.differ(black, dark));                      // 3 * 0.063 = 0.19
    CHECK(distance.differ(black, {0.004f, 0.004f, 0.004f, 0, 0}));  // 3 * 0.110 = 0.33
    CHECK(distance.differ(black, {0, 0, 0, 0, 1}));
}

TEST_CASE("colours encoded together differ as each by itself", "[render][antialias]")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const auto plain = [](double gamma, double threshold) {
        plan::Antialiasing out = settings(2, 3, 0);
        out.gamma = gamma;
        out.threshold = threshold;
        return out;
    };
    using Kind = scene::GammaCurve::Kind;
    for (const scene::GammaCurve gamma :
         {scene::GammaCurve{Kind::Srgb}, {Kind::Power, 1.8}, {Kind::Power, 300.0}, {Kind::Bt709}})
        for (int round = 0; round < 200; ++round) {
            std::vector<scene::Color> colors;
            for (int i = 0; i < 13; ++i) colors.push_back({unit(random), unit(random), unit(random), 0, unit(random)});
            colors[1] = {0, 0, 0, 0, 0};
            colors[2] = {-0.5f, 1e-35f, 40.0f, 0, 0};
            colors[3] = {1e30f, 0.5f, 0.5f, 0, 0};
            colors[4] = {std::nanf(""), 0.5f, 0.5f, 0, 0};
            // The second threshold is how far two of the colours are apart, to the last bit.
            const trace::ColorDistance first(plain(2.5, 0.3), gamma);
            const trace::EncodedColor a = first.encoded(colors[7]), b = first.encoded(colors[8]);
            const float apart = std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue) +
                                std::abs(a.color.transmit - b.color.transmit);
            for (const double threshold : {0.3, static_cast<double>(apart)}) {
                const trace::ColorDistance distance(plain(2.5, threshold), gamma);
                trace::EncodedColors together{colors, {}, {}, {}, {}};
                distance.encode(together, 0);
                REQUIRE(together.size() == colors.size());
                for (std::size_t i = 0; i < colors.size(); ++i)
                    for (std::size_t k = 0; k < colors.size(); ++k)
                        REQUIRE(distance.differ(together[i], together[k]) == distance.differ(colors[i], colors[k]));
            }
        }
}

TEST_CASE("powers in lanes of single precision keep what they promise", "[render][antialias]")
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        alignas(64) std::array<float, trace::kFloatPart> values;
        const double exponent = 0.05 + 2.95 * unit(random);
        for (float& v : values) v = static_cast<float>(std::exp(std::log(256.0) - unit(random) * std::log(256e30)));
        const auto found = trace::float_power(trace::FloatPart::load_aligned(values.data()),
                                              trace::FloatPart(static_cast<float>(exponent)));
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double wanted =
                std::pow(static_cast<double>(values[k]), static_cast<double>(static_cast<float>(exponent)));
            if (wanted > 1e-3) worst = std::max(worst, std::abs(static_cast<double>(found.get(k)) / wanted - 1.0));
        }
    }
    INFO("off by " << worst);
    CHECK(worst < 1.5e-6);
}

TEST_CASE("colours encoded together are close enough for differ()", "[render][antialias]")
{
    std::mt19937 random(13);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    using Kind = scene::GammaCurve::Kind;
    for (const scene::GammaCurve gamma : {scene::GammaCurve{Kind::Srgb}, {Kind::Power, 1.0}, {Kind::Power, 2.2}})
        for (const double display : {0.4, 1.0, 2.2, 2.5}) {
            plan::Antialiasing antialiasing = settings(1, 3, 0);
            antialiasing.gamma = display;
            const trace::ColorDistance distance(antialiasing, gamma);
            std::vector<scene::Color> colors;
            for (int i = 0; i < 4000; ++i) {
                const float scale = std::exp2(8.0f - 20.0f * unit(random));
                colors.push_back({scale * unit(random), scale * unit(random), scale * unit(random), 0, 0});
            }
            trace::EncodedColors together{colors, {}, {}, {}, {}};
            distance.encode(together, 0);
            double worst = 0.0;
            for (std::size_t i = 0; i < colors.size(); ++i) {
                const double wanted = static_cast<double>(distance.encoded(colors[i]).red);
                if (wanted > 1e-5)
                    worst = std::max(worst, std::abs(static_cast<double>(together[i].red) / wanted - 1.0));
            }
            INFO("display gamma " << display << ", off by " << worst);
            CHECK(worst < 3e-6);  // differ() has room for 4e-6 of each; its sums' roundings take the rest
        }
}

TEST_CASE("colours that are not marked surely do not differ", "[render][antialias]")
{
    std::mt19937 random(12);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    constexpr std::size_t kWidth = 37, kStride = kWidth + 1;
    const std::array<std::size_t, 4> corners{0, kStride, 1, kStride + 1};
    int marked = 0, wrongly = 0;
    for (int round = 0; round < 300; ++round) {
        const trace::ColorDistance distance(settings(2, 3, 0), {});
        std::vector<scene::Color> colors(2 * kStride);
        const float apart = std::exp2(-8.0f * unit(random)), base = unit(random);
        for (auto& c : colors)
            c = {base + apart * unit(random), base + apart * unit(random), base, 0, apart * unit(random)};
        if (round % 7 == 0) colors[5].green = std::nanf("");
        if (round % 11 == 0) colors[kStride + 9].red = 1e30f;
        trace::EncodedColors encoded{colors, {}, {}, {}, {}};
        distance.encode(encoded, 0);
        std::vector<std::uint8_t> flags(kWidth, 0);
        distance.mark_unsure(encoded, 0, kWidth, corners, 4, flags.data());
        for (std::size_t i = 0; i < kWidth; ++i) {
            bool differ = false;
            for (const std::size_t a : corners)
                for (const std::size_t b : corners) differ |= distance.differ(colors[i + a], colors[i + b]);
            REQUIRE((flags[i] == 0 || flags[i] == 4));
            if (differ) REQUIRE(flags[i] == 4);
            marked += flags[i] != 0 ? 1 : 0;
            wrongly += flags[i] != 0 && !differ ? 1 : 0;
        }
    }
    CHECK(marked > 1000);
    CHECK(wrongly <
          marked / 2);  // the ranges of components may add up where no pair does; the last of a row count as unsure
}

TEST_CASE("method 3 asks an even picture once a pixel", "[antialias]")
{
    Formula even{[](double, double) { return 0.25f; }, {}};
    plan::Antialiasing s = settings(3, 4, 1.0);
    s.threshold = 0.0;
    CHECK(run(even, s, {0, 0, 16, 16}) == std::vector<float>(256, 0.25f));
    CHECK(even.asked.size() == 256);
    for (const auto& [place, times] : even.asked) {
        CHECK(std::abs(place.first - std::round(place.first)) <= 0.5);
        CHECK(times == 1);
    }
}

TEST_CASE("method 3 goes on where the picture is not even, to its depth", "[antialias]")
{
    // Black and white by chance: the samples of POV-Ray 3.8 in 80x60 such pixels, +SS1 (spec 7, 3.2).
    const auto asked = [](double threshold, double confidence, int depth) {
        Formula noise{[](double x, double y) {
                          const double v = std::sin(x * 12989.8 + y * 78233.0) * 43758.5;
                          return v - std::floor(v) < 0.5 ? 0.0f : 1.0f;
                      },
                      {}};
        plan::Antialiasing s = settings(3, depth, 1.0);
        s.threshold = threshold;
        s.confidence = confidence;
        run(noise, s, {0, 0, 80, 60});
        return static_cast<double>(noise.asked.size());
    };
    CHECK(asked(0.3, 0.9, 3) == Approx(70200).epsilon(0.05));
    CHECK(asked(0.3, 0.9, 1) == Approx(19195).epsilon(0.01));
    CHECK(asked(0.3, 0.5, 3) == Approx(14129).epsilon(0.05));
    CHECK(asked(0.3, 0.99, 3) == Approx(169260).epsilon(0.05));
    CHECK(asked(0.1, 0.9, 3) == 307200);
}

TEST_CASE("method 3 finds the share of an edge, and another seed other samples", "[antialias]")
{
    plan::Antialiasing s = settings(3, 5, 1.0);
    s.threshold = 0.02;
    Formula edge = edge_at(3.2);
    const std::vector<float> pixels = run(edge, s, {0, 0, 8, 4});
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t column = i % 8;
        if (column != 3) CHECK(pixels[i] == (column < 3 ? 0.0f : 1.0f));
        else CHECK(pixels[i] == Approx(0.3f).margin(0.06));
    }
    s.seed = 7;
    Formula again = edge_at(3.2);
    run(again, s, {0, 0, 8, 4});
    CHECK(again.asked != edge.asked);
}
