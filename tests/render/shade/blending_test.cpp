#include "render/texture/evaluate.h"

#include <catch2/catch.hpp>

#include <vector>

namespace {

using image::TransferCurve;
using scene::Blending;
using Mode = Blending::Mode;

/// Half way from the first colour to the second in POV-Ray 3.8, as light (spec 7b, 9).
struct Mixture {
    TransferCurve working;
    Blending blending;
    scene::Color first, second;
    glm::vec3 light;
};

const scene::Color kOrange{1.0f, 0.2f, 0, 0, 0}, kBlue{0, 0.5f, 1.0f, 0, 0};
const scene::Color kBelowZero{1.0f, -0.2f, 0, 0, 0}, kAboveOne{0, 0.5f, 1.5f, 0, 0};

const std::vector<Mixture> kMixtures = {
    {TransferCurve::linear(), {Mode::Working, 2.5f}, kOrange, kBlue, {0.5f, 0.35f, 0.5f}},
    {TransferCurve::linear(), {Mode::Linear, 2.5f}, kOrange, kBlue, {0.5f, 0.35f, 0.5f}},
    {TransferCurve::linear(), {Mode::Power, 2.5f}, kOrange, kBlue, {0.17678f, 0.3297f, 0.17678f}},
    {TransferCurve::linear(), {Mode::Power, 3.0f}, kOrange, kBlue, {0.125f, 0.32744f, 0.125f}},
    {TransferCurve::linear(), {Mode::Power, 0.5f}, kOrange, kBlue, {0.7071f, 0.38079f, 0.7071f}},
    {TransferCurve::linear(), {Mode::Power, 2.5f}, kBelowZero, kAboveOne, {0.17678f, 0.0884f, 0.26517f}},
    {TransferCurve::linear(), {Mode::Brightness, 2.5f}, kOrange, kBlue, {0.49999f, 0.35f, 0.49999f}},
    {TransferCurve::linear(), {Mode::Brightness, 2.5f}, kBelowZero, kAboveOne, {0.46874f, 0.14063f, 0.70312f}},
    {TransferCurve::linear(), {Mode::Brightness, 2.5f}, {}, kBlue, {0.0f, 0.0884f, 0.17678f}},
    {TransferCurve::linear(), {Mode::Brightness, 2.5f}, {-1, 0, 0, 0, 0}, {1, 0, 0, 0, 0}, {0.0f, 0.0f, 0.0f}},
    {TransferCurve::srgb(), {Mode::Linear, 2.5f}, kOrange, kBlue, {0.49999f, 0.12357f, 0.49999f}},
    {TransferCurve::srgb(), {Mode::Power, 2.5f}, kOrange, kBlue, {0.17678f, 0.09981f, 0.17678f}},
    {TransferCurve::srgb(), {Mode::Brightness, 2.5f}, kOrange, kBlue, {0.28608f, 0.07337f, 0.28608f}},
    {TransferCurve::bt709(), {Mode::Linear, 2.5f}, kOrange, kBlue, {0.49999f, 0.1575f, 0.49999f}},
    {TransferCurve::bt709(), {Mode::Working, 2.5f}, kOrange, kBlue, {0.25959f, 0.13681f, 0.25959f}},
};

}  // namespace

TEST_CASE("neighbours of a map blend as POV-Ray 3.8 blends them", "[texture][pigment]")
{
    constexpr double kLevel = 1.0 / 65535.0;  // those of the pictures that tell the numbers; and a few roundings
    for (const Mixture& m : kMixtures) {
        INFO("mode " << static_cast<int>(m.blending.mode) << ", gamma " << m.blending.gamma);
        const scene::Color c = texture::mix(m.working, m.blending, m.first, m.second, 0.5);
        for (int k = 0; k < 3; ++k) {
            INFO("component " << k);
            CHECK(m.working.decode(c.rgb()[k]) == Approx(m.light[k]).margin(1.5 * kLevel));
        }
    }
}

TEST_CASE("filter and transmit blend as light does, as if they were levels", "[texture][pigment]")
{
    const scene::Color first{1, 0.2f, 0, 0, 0.1f}, second{0, 0.5f, 1, 0.2f, 0.9f};
    struct {
        TransferCurve working;
        double share, filter, transmit;
    } const measured[] = {
        {TransferCurve::linear(), 0.25, 0.05, 0.3},
        {TransferCurve::srgb(), 0.25, 0.088114, 0.489410},
        {TransferCurve::srgb(), 0.5, 0.136034, 0.664222},
        {TransferCurve::power(2.2f), 0.75, 0.175485, 0.790633},
    };
    for (const auto& m : measured)
        for (const Mode mode : {Mode::Linear, Mode::Power, Mode::Brightness}) {
            const scene::Color c = texture::mix(m.working, {mode, 1.5f}, first, second, m.share);
            CHECK(c.filter == Approx(m.filter).margin(1e-6));
            CHECK(c.transmit == Approx(m.transmit).margin(1e-6));
        }
    const scene::Color c = texture::mix(TransferCurve::srgb(), {}, first, second, 0.25);
    CHECK(c.filter == Approx(0.05));
    CHECK(c.transmit == Approx(0.3));
}
