#include "numbers/float_power.h"
#include "render/kernel/antialias/color_distance.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>

// How different two colours look (spec 2, 8.1): alone, many together, and what is surely alike.
namespace {

plan::Antialiasing of_threshold(double threshold)
{
    plan::Antialiasing s;
    s.method = 2;
    s.depth = 3;
    s.threshold = threshold;
    return s;
}

}  // namespace

TEST_CASE("colours differ by the sum over channels after the display curve", "[render][antialias]")
{
    const trace::ColorDistance distance(of_threshold(0.3), {});
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
        plan::Antialiasing out = of_threshold(0.3);
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
        alignas(64) std::array<float, numbers::lanes::kFloatPart> values;
        const double exponent = 0.05 + 2.95 * unit(random);
        for (float& v : values) v = static_cast<float>(std::exp(std::log(256.0) - unit(random) * std::log(256e30)));
        const auto found = numbers::float_power(numbers::lanes::FloatPart::load_aligned(values.data()),
                                                numbers::lanes::FloatPart(static_cast<float>(exponent)));
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
            plan::Antialiasing antialiasing = of_threshold(0.3);
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
        const trace::ColorDistance distance(of_threshold(0.3), {});
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
