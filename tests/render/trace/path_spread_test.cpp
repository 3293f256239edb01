// What the spread of paths says of their error where few of them bring most of the light: docs/error_and_time.md.
#include "render/picture/sampling/path_spread.h"
#include "render/picture/sampling/sharing.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace {

constexpr int kAcross = 48;
const trace::ShownLevel kStraight = [](double light) { return 255.0 * std::clamp(light, 0.0, 1.0); };
const trace::ShownLevel kBent = [](double light) { return 255.0 * std::pow(std::clamp(light, 0.0, 1.0), 1.0 / 2.2); };

/// Light of `mean` in every pixel: one path in 1 / chance brings all of it.
struct Rare {
    double chance, mean;
    void add(trace::SampledPicture& picture, int x, int y, std::mt19937& random) const
    {
        const auto light = static_cast<float>(static_cast<double>(random()) * 0x1p-32 < chance ? mean / chance : 0.0);
        picture.at(x, y).add({light, light, light, 0, 0});
    }
};

double off_by(const trace::SampledPicture& picture, double mean, const trace::ShownLevel& shown)
{
    double sum = 0.0;
    for (int y = 0; y < kAcross; ++y)
        for (int x = 0; x < kAcross; ++x) sum += std::pow(shown(picture.at(x, y).mean(0)) - shown(mean), 2);
    return std::sqrt(sum / (kAcross * kAcross));
}

}  // namespace

TEST_CASE("an error that is asked for is kept where few paths bring the light", "[sampling][path]")
{
    std::vector<std::size_t> window(kAcross * kAcross);
    std::iota(window.begin(), window.end(), std::size_t{0});
    for (const double chance : {0.3, 0.1})
        for (const trace::ShownLevel& shown : {kStraight, kBent})
            for (const double asked : {24.0, 12.0, 6.0}) {
                const Rare light{chance, 0.2};
                std::mt19937 random(7);
                trace::SampledPicture picture(kAcross, kAcross);
                std::vector<std::uint32_t> wanted(kAcross * kAcross, 8);
                double told = 0.0;
                while (true) {
                    for (int y = 0; y < kAcross; ++y)
                        for (int x = 0; x < kAcross; ++x)
                            for (auto n = wanted[static_cast<std::size_t>(y * kAcross + x)]; n > 0; --n)
                                light.add(picture, x, y, random);
                    const trace::PathSpread spread(picture, shown, {});
                    told = spread.expected_error();
                    if (told <= 0.95 * asked) break;
                    const trace::Sharing sharing{picture, window, spread.variances(), 4.0, 65536.0};
                    REQUIRE(sharing.share_out(0.95 * asked / told, 1e9, wanted));
                }
                const double is = off_by(picture, light.mean, shown);
                INFO("chance " << chance << ", asked for " << asked << ": off by " << is << ", told " << told);
                CHECK(is <= asked);
                CHECK(is > asked / 3.0);
            }
}

TEST_CASE("one path as bright as a thousand whites makes no picture unsure", "[sampling][path]")
{
    trace::SampledPicture picture(kAcross, kAcross);
    const Rare light{0.5, 0.3};
    std::mt19937 random(1);
    for (int y = 0; y < kAcross; ++y)
        for (int x = 0; x < kAcross; ++x)
            for (int n = 0; n < 64; ++n) light.add(picture, x, y, random);
    const double before = trace::PathSpread(picture, kStraight, {}).expected_error();
    picture.at(20, 20).add({64000, 64000, 64000, 0, 0});
    const double after = trace::PathSpread(picture, kStraight, {}).expected_error();
    INFO(before << " before, " << after << " after; it is off by " << off_by(picture, light.mean, kStraight));
    CHECK(after > 0.95 * before);
    CHECK(after < 2.0 * off_by(picture, light.mean, kStraight));
}

TEST_CASE("the spread of paths that agree is none, and of one pixel its own", "[sampling][path]")
{
    trace::SampledPicture flat(3, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            for (int n = 0; n < 8; ++n) flat.at(x, y).add({.5f, .25f, .125f, 0, 0});
    CHECK(trace::PathSpread(flat, kStraight, {}).expected_error() == 0.0);
    trace::SampledPicture one(1, 1);
    CHECK(trace::PathSpread(one, kStraight, {}).expected_error() == 0.0);  // no sample at all
    for (int n = 0; n < 64; ++n) one.at(0, 0).add({n % 2 == 0 ? .4f : .6f, .5f, .5f, 0, 0});
    CHECK(trace::PathSpread(one, kStraight, {}).variances()[0] == Approx(255 * 255 * .01).epsilon(0.05));
}

TEST_CASE("moments are those of their formula", "[sampling]")
{
    trace::SampledPicture::Pixel pixel;
    for (const float v : {1.0f, 3.0f, 8.0f, 4.0f, 4.0f}) pixel.add({v, 0, 0, 0, 0});
    CHECK(pixel.moments().second == Approx(9.0 + 1.0 + 16.0));
    CHECK(pixel.moments().fourth == Approx(81.0 + 1.0 + 256.0));
}
