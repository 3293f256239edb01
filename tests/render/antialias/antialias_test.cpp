#include "render/kernel/antialias/antialias.h"

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
