// Pictures of many samples: docs/error_and_time.md.
#include "render/picture/sampling/sampled_render.h"
#include "render/kernel/tile/sobol.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace {

constexpr int kWidth = 64, kHeight = 48;
const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 }\n";
const trace::ShownLevel kLinear = [](double light) { return 255.0 * std::clamp(light, 0.0, 1.0); };

struct Sampled {
    trace::SampledPicture picture{kWidth, kHeight};
    trace::RenderStatistics statistics;
};

void render_into(Sampled& out, const std::string& text, const trace::SamplingGoal& goal, int threads, trace::Isa isa)
{
    plan::Options options;
    options.width = kWidth;
    options.height = kHeight;
    options.free_sampling = true;
    trace::RenderOptions render;
    render.threads = threads;
    render.isa = isa;
    out.statistics = trace::render_sampled(plan::compile(parser::parse_text(kHead + text, "t.pov", {}).scene, options),
                                           render, goal, kLinear, out.picture);
}

Sampled sampled(const std::string& text, const trace::SamplingGoal& goal, int threads = 0,
                trace::Isa isa = trace::Isa::Auto)
{
    Sampled out;
    render_into(out, text, goal, threads, isa);
    return out;
}

/// The picture of so many seconds by a clock that goes on by one with a thousand samples: what they hold is the same on
/// any machine, whatever else runs there.
constexpr double kSamplesPerSecond = 1000.0;
Sampled sampled_in_time(const std::string& text, double seconds)
{
    Sampled out;
    trace::SamplingGoal goal;
    goal.seconds = seconds;
    goal.clock = [&out] { return static_cast<double>(out.picture.samples()) / kSamplesPerSecond; };
    render_into(out, text, goal, 1, trace::Isa::Auto);
    return out;
}

trace::SamplingGoal samples(std::uint32_t count)
{
    trace::SamplingGoal goal;
    goal.samples = count;
    return goal;
}

trace::SamplingGoal error_of(double levels)
{
    trace::SamplingGoal goal;
    goal.error = levels;
    return goal;
}

/// White above the line y = 0.3 x + 0.1 of the view of 1.6 x 1.2, black below.
const std::string kSlantedEdge =
    "camera { orthographic location -z right 1.6*x up 1.2*y direction z }\n"
    "plane { z, 1 pigment { function { select(y - .3 * x - .1, 0, 1) } color_map { [0 rgb 0] [1 rgb 1] } }\n"
    "  finish { ambient 1 diffuse 0 } }\n";

/// Share of a pixel that lies above that line, by 1000 strips each of which is exact.
double share_above(int x, int y)
{
    double sum = 0.0;
    constexpr int kStrips = 1000;
    for (int i = 0; i < kStrips; ++i) {
        const double u = ((x + (i + 0.5) / kStrips) / kWidth - 0.5) * 1.6;
        const double line = (0.5 - (0.3 * u + 0.1) / 1.2) * kHeight;  // in rows from the top
        sum += std::clamp(line - y, 0.0, 1.0);
    }
    return sum / kStrips;
}

double error_against(const trace::SampledPicture& picture, double (*truth)(int, int))
{
    double sum = 0.0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) sum += std::pow(255.0 * (picture.at(x, y).mean(0) - truth(x, y)), 2);
    return std::sqrt(sum / (kWidth * kHeight));
}

bool same(const trace::SampledPicture& a, const trace::SampledPicture& b)
{
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            if (a.at(x, y).sum != b.at(x, y).sum || a.at(x, y).count != b.at(x, y).count) return false;
    return true;
}

}  // namespace

TEST_CASE("points of a scrambled Sobol sequence lie one in each elementary interval", "[sampling]")
{
    for (std::uint32_t seed : {0u, 1u, 77u, 0xdeadbeefu})
        for (int bits = 0; bits <= 8; ++bits)
            for (int across = 0; across <= bits; ++across) {
                std::set<std::pair<int, int>> cells;
                for (std::uint32_t i = 0; i < (1u << bits); ++i) {
                    const auto p = trace::sobol_point(seed, i);
                    REQUIRE(p[0] >= 0.0);
                    REQUIRE(p[0] < 1.0);
                    REQUIRE(p[1] >= 0.0);
                    REQUIRE(p[1] < 1.0);
                    cells.insert({static_cast<int>(std::ldexp(p[0], across)),
                                  static_cast<int>(std::ldexp(p[1], bits - across))});
                }
                CHECK(cells.size() == (1u << bits));
            }
    CHECK(trace::sobol_point(1, 0) != trace::sobol_point(2, 0));
}

TEST_CASE("the spread of samples is that of their formula", "[sampling]")
{
    trace::SampledPicture::Pixel pixel;
    for (const float v : {1.0f, 3.0f, 8.0f, 4.0f, 4.0f}) pixel.add({v, 0, 0, 0, 0});
    CHECK(pixel.mean(0) == Approx(4.0));
    CHECK(pixel.spread(0) == Approx(9.0 + 1.0 + 16.0));
    CHECK(pixel.spread(1) == 0.0);
    CHECK(pixel.mark == 4);
    CHECK(pixel.begun[0] == 16.0);
}

TEST_CASE("an edge across pixels: more samples come nearer to its exact share, and the expected error is that",
          "[sampling]")
{
    double before = 1e9;
    for (const std::uint32_t count : {4u, 16u, 64u, 256u}) {
        const Sampled found = sampled(kSlantedEdge, samples(count));
        const double error = error_against(found.picture, share_above);
        INFO(count << " samples: " << error << ", expected " << found.statistics.error);
        CHECK(found.statistics.samples == std::uint64_t{count} * kWidth * kHeight);
        CHECK(error < 0.5 * before);  // samples anywhere: half; these: 0.35 and less
        // 300 pixels of the edge tell it: measured 1.1 to 1.6 times what it is.
        CHECK(found.statistics.error > 0.9 * error);
        CHECK(found.statistics.error < 2.5 * error);
        before = error;
    }
    CHECK(before < 0.25);  // measured 0.228
}

TEST_CASE("an error that is asked for is kept, with samples where they are needed", "[sampling]")
{
    for (const double asked : {2.0, 1.0, 0.5, 0.25}) {
        const Sampled found = sampled(kSlantedEdge, error_of(asked));
        CHECK(error_against(found.picture, share_above) < asked);
        CHECK(found.statistics.error <= asked);
        // The plain parts of the picture take the first samples and no more.
        CHECK(found.picture.at(0, 0).count == 8);
        if (asked < 1.0) CHECK(found.picture.samples() < 4 * 8u * kWidth * kHeight);
    }
}

TEST_CASE("half a shadow under a long lamp falls off as its visible part", "[sampling]")
{
    // A lamp of 2 x 0.02 at height 2, an edge at x = 0 at height 1: at x the part of the lamp beyond -x is seen.
    const std::string text = "camera { orthographic location 1.5*y sky z right 3.2*x up 2.4*y look_at 0 }\n"
                             "light_source { 2*y rgb 1 area_light 2*x, .02*z, 9, 9 adaptive 1 }\n"
                             "box { <-9,1,-9>,<0,1.001,9> no_image pigment { rgb 0 } }\n"
                             "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 brilliance 0 } }\n";
    const Sampled found = sampled(text, samples(64));
    double sum = 0.0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const double at = ((x + 0.5) / kWidth - 0.5) * 3.2;
            sum += std::pow(found.picture.at(x, y).mean(0) - std::clamp(0.5 + 0.5 * at, 0.0, 1.0), 2);
        }
    // 256 lamps in strata: 0.3 / 256 and what two of their cells leave to chance.
    CHECK(std::sqrt(sum / (kWidth * kHeight)) < 0.02);
}

TEST_CASE("the same samples for any number of threads and any instruction set", "[sampling]")
{
    const std::string text = "camera { location <0,1,-4> look_at 0 aperture .1 focal_point 0 blur_samples 7 }\n"
                             "light_source { <3,5,-3> rgb 1 area_light x, z, 5, 5 adaptive 1 jitter }\n"
                             "plane { y,-1 pigment { checker rgb 1 rgb .2 } }\n"
                             "sphere { 0, 1 pigment { rgb <.8,.3,.2> } finish { reflection .3 phong .5 } }\n";
    const Sampled one = sampled(text, error_of(4.0), 1), four = sampled(text, error_of(4.0), 4);
    CHECK(same(one.picture, four.picture));
    CHECK(one.statistics.error == four.statistics.error);
    // Digits of the last place differ between instruction sets nowhere in this scene.
    for (const trace::Isa isa : trace::kernels_there())
        CHECK(same(one.picture, sampled(text, error_of(4.0), 1, isa).picture));
}

TEST_CASE("another seed has other samples", "[sampling]")
{
    trace::SamplingGoal one = samples(16), two = one;
    two.seed = 1;
    const Sampled a = sampled(kSlantedEdge, one), b = sampled(kSlantedEdge, two);
    CHECK_FALSE(same(a.picture, b.picture));
    // Both as far from the truth as they expect to be, and from each other by as much as the two errors come to.
    double apart = 0.0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            apart += std::pow(255.0 * (a.picture.at(x, y).mean(0) - b.picture.at(x, y).mean(0)), 2);
    apart = std::sqrt(apart / (kWidth * kHeight));
    const double both = std::hypot(error_against(a.picture, share_above), error_against(b.picture, share_above));
    CHECK(apart == Approx(both).epsilon(0.25));
}

TEST_CASE("a picture that has no spread takes its first samples alone", "[sampling]")
{
    const std::string text = "camera { location -z look_at 0 } background { rgb <.5,.25,.125> }\n";
    const Sampled found = sampled(text, error_of(0.01));
    CHECK(found.picture.samples() == 8u * kWidth * kHeight);
    CHECK(found.statistics.error == 0.0);
    CHECK(found.picture.at(3, 3).mean(1) == Approx(0.25));
    trace::SamplingGoal goal;
    goal.seconds = 30.0;  // which it need not take
    const Sampled timed = sampled(text, goal);
    CHECK(timed.statistics.seconds_trace < 10.0);
}

TEST_CASE("a time that does not hold a sample of each pixel ends all the same, with a coarse picture", "[sampling]")
{
    // Twenty glasses one in the other above many lamps. What is seen is never black.
    const std::string text =
        "camera { location <0,1,-4> look_at 0 }\nglobal_settings { max_trace_level 20 }\n"
        "light_source { <3,5,-3> rgb 1 area_light x, z, 9, 9 area_illumination on }\n"
        "background { rgb .5 }\n"
        "plane { y,-1 pigment { checker rgb 1 rgb .5 } finish { ambient .5 reflection .3 } }\n"
        "#for (I, 1, 20) sphere { 0, 1.5 - I*.05 pigment { rgbt <1,1,1,.9> } finish { reflection .2 } "
        "interior { ior 1 + I*.02 } } #end\n";
    const Sampled whole = sampled(text, samples(1), 1);
    CHECK(std::isnan(whole.statistics.error));  // one sample has no spread
    const double seconds = 0.3 * kWidth * kHeight / kSamplesPerSecond;
    const Sampled found = sampled_in_time(text, seconds);
    INFO(found.statistics.seconds_trace << " of " << seconds);
    CHECK(std::isnan(found.statistics.error));
    CHECK(found.statistics.seconds_trace >= 0.9 * seconds);
    CHECK(found.statistics.seconds_trace <= 1.1 * seconds);
    CHECK(found.statistics.samples < 1u * kWidth * kHeight);
    image::Image picture;
    found.picture.show(picture);
    plan::Options window;
    found.picture.fill(picture, window);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            INFO(x << ", " << y);
            // What is there is what is always there; what is not looks like a place of a coarser grid.
            if (found.picture.at(x, y).count == 1) CHECK(found.picture.at(x, y).sum == whole.picture.at(x, y).sum);
            const int u = x - x % 32, v = y - y % 32;
            CHECK(found.picture.at(u, v).count >= 1);
            CHECK(picture.at(x, y)[1] > 0.0f);
        }
}

TEST_CASE("pixels without a sample look like the finest place of the coarse grids that has one", "[sampling]")
{
    trace::SampledPicture samples(70, 40);
    plan::Options window;
    window.start_column = 3, window.start_row = 2, window.end_column = 66, window.end_row = 37;
    const auto put = [&](int x, int y, float value) { samples.at(x, y).add({value, value, value, 0, 0}); };
    put(3, 2, .25f), put(35, 2, .5f), put(3, 34, .75f), put(35, 34, 1.0f), put(11, 10, 2.0f), put(13, 10, 3.0f);
    image::Image picture;
    samples.show(picture);
    samples.fill(picture, window);
    CHECK(picture.at(3, 2)[0] == .25f);
    CHECK(picture.at(34, 33)[0] == .25f);
    CHECK(picture.at(35, 33)[0] == .5f);
    CHECK(picture.at(66, 37)[2] == 1.0f);
    CHECK(picture.at(18, 17)[1] == 2.0f);
    CHECK(picture.at(19, 17)[1] == .25f);
    CHECK(picture.at(14, 11)[0] == 3.0f);
    CHECK(picture.at(15, 11)[0] == 2.0f);
    CHECK(picture.at(2, 2)[0] == 0.0f);  // outside of the window
    CHECK(picture.at(67, 37)[0] == 0.0f);
}

TEST_CASE("a time that does not hold another sample of each pixel is used all the same", "[sampling]")
{
    const std::string text = "camera { location <0,1,-4> look_at 0 }\n"
                             "light_source { <3,5,-3> rgb 1 }\n"
                             "plane { y,-1 pigment { checker rgb 1 rgb .2 } finish { reflection .3 } }\n"
                             "sphere { 0, 1 pigment { bozo scale .1 } finish { reflection .3 phong .5 } }\n";
    const double seconds = 1.7 * kWidth * kHeight / kSamplesPerSecond;
    const Sampled found = sampled_in_time(text, seconds);
    INFO(found.statistics.seconds_trace << " of " << seconds);
    const double each = static_cast<double>(found.statistics.samples) / (kWidth * kHeight);
    CHECK(each > 1.6);
    CHECK(each < 1.8);
    std::uint32_t most = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            CHECK(found.picture.at(x, y).count >= 1);
            most = std::max(most, found.picture.at(x, y).count);
        }
    CHECK(most >= 2);
}

TEST_CASE("a time by the machine's clock ends, whatever the machine does beside", "[sampling]")
{
    trace::SamplingGoal goal;
    goal.seconds = 0.05;
    const Sampled found = sampled(kSlantedEdge, goal, 1);
    CHECK(found.statistics.seconds_trace < 10.0);  // 0.05 on a machine that does nothing else
    CHECK(found.statistics.samples > 0);
}
