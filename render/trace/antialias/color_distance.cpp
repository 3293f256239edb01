#include "render/trace/antialias/color_distance.h"

#include "csg/roots/lane_power.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trace {
namespace {

/// Exponents this close to 1 count as 1, and then negative values are kept (spec 2, 8.1).
constexpr double kIdentityExponent = 0.01;

constexpr double kSrgbKnee = 0.04045, kSrgbSlope = 12.92, kSrgbShift = 0.055, kSrgbScale = 1.055, kSrgbExponent = 2.4;

// What powers in lanes know, with room.
constexpr double kLeastExponent = 0.05, kMostExponent = 10.0, kLeastValue = 1e-30, kMostValue = 1e20;

}  // namespace

ColorDistance::ColorDistance(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma)
    : threshold_(static_cast<double>(static_cast<float>(settings.threshold))),
      srgb_(gamma.kind == scene::AssumedGamma::Kind::Srgb)
{
    const double display = settings.gamma > 0 ? settings.gamma : 1.0;
    const double working = gamma.kind == scene::AssumedGamma::Kind::Power ? gamma.exponent : 1.0;
    exponent_ = working / display;
    identity_ = !srgb_ && std::abs(exponent_ - 1.0) <= kIdentityExponent;
    in_lanes_ = !identity_ && exponent_ >= kLeastExponent && exponent_ <= kMostExponent;
}

float ColorDistance::encode(float value) const
{
    if (identity_) return value;
    double v = static_cast<double>(value);
    if (srgb_) v = v <= kSrgbKnee ? v / kSrgbSlope : std::pow((v + kSrgbShift) / kSrgbScale, kSrgbExponent);
    return static_cast<float>(std::pow(std::max(v, 0.0), exponent_));
}

void ColorDistance::encode_together(const scene::Color* colors, std::size_t count, EncodedColor* out) const
{
    using csg::lanes::Double;
    constexpr auto kLanes = static_cast<std::size_t>(csg::lanes::kDoubles);
    const Double zero(0.0);
    alignas(64) std::array<double, 3 * kAtOnce> values{};
    for (std::size_t k = 0; k < count; ++k) {
        values[3 * k] = static_cast<double>(colors[k].red);
        values[3 * k + 1] = static_cast<double>(colors[k].green);
        values[3 * k + 2] = static_cast<double>(colors[k].blue);
    }
    bool known = true;
    for (std::size_t i = 0; i < 3 * count; i += kLanes) {
        Double v = Double::load_aligned(values.data() + i);
        if (srgb_) {
            const auto low = v <= Double(kSrgbKnee);
            const Double c = xsimd::select(low, Double(1.0), (v + Double(kSrgbShift)) / Double(kSrgbScale));
            known = known && csg::lanes::mask(!(c <= Double(kMostValue))) == 0;
            v = xsimd::select(low, v / Double(kSrgbSlope), csg::lanes::power(c, Double(kSrgbExponent)));
        }
        const auto none = v <= zero;
        const Double c = xsimd::select(none, Double(1.0), v);
        known = known && csg::lanes::mask(!((c >= Double(kLeastValue)) & (c <= Double(kMostValue)))) == 0;
        xsimd::select(none, zero, csg::lanes::power(c, Double(exponent_))).store_aligned(values.data() + i);
    }
    if (!known) {
        for (std::size_t k = 0; k < count; ++k) out[k] = encoded(colors[k]);
        return;
    }
    for (std::size_t k = 0; k < count; ++k)
        out[k] = {colors[k], static_cast<float>(values[3 * k]), static_cast<float>(values[3 * k + 1]),
                  static_cast<float>(values[3 * k + 2])};
}

void ColorDistance::encode(std::span<const scene::Color> colors, std::vector<EncodedColor>& out) const
{
    const std::size_t first = out.size();
    out.resize(first + colors.size());
    EncodedColor* to = out.data() + first;
    for (std::size_t i = 0; i < colors.size(); i += kAtOnce) {
        const std::size_t count = std::min(kAtOnce, colors.size() - i);
        if (in_lanes_) encode_together(colors.data() + i, count, to + i);
        else
            std::transform(colors.data() + i, colors.data() + i + count, to + i,
                           [&](const auto& c) { return encoded(c); });
    }
}

}  // namespace trace
