#include "render/kernel/antialias/color_distance.h"

#include "numbers/float_power.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trace {

using numbers::lanes::FloatPart;
using numbers::lanes::kFloatPart;
namespace {

using Curve = scene::GammaCurve::Kind;

/// Exponents this close to 1 count as 1, and then negative values are kept (spec 2, 8.1).
constexpr double kIdentityExponent = 0.01;

constexpr double kSrgbKnee = 0.04045, kSrgbSlope = 12.92, kSrgbShift = 0.055, kSrgbScale = 1.055, kSrgbExponent = 2.4;

// What float_power() knows. Of an exponent above 1 after sRGB's both errors would be more than differ() has room for.
constexpr double kMostExponent = 3.0, kMostAfterSrgb = 1.0;
constexpr float kLeastValue = 1e-30f, kMostValue = 256.0f;

FloatPart float_of(double value) { return FloatPart(static_cast<float>(value)); }

}  // namespace

ColorDistance::ColorDistance(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma)
    : threshold_(static_cast<double>(static_cast<float>(settings.threshold))),
      srgb_(gamma && gamma->kind == Curve::Srgb)
{
    const double display = settings.gamma > 0 ? settings.gamma : 1.0;
    const bool power = gamma && gamma->kind == Curve::Power;
    if (gamma && !power && !srgb_) television_ = gamma;
    exponent_ = (power ? gamma->exponent : 1.0) / display;
    identity_ = !srgb_ && !television_ && std::abs(exponent_ - 1.0) <= kIdentityExponent;
    in_lanes_ = !identity_ && !television_ && exponent_ > 0.0 && exponent_ <= (srgb_ ? kMostAfterSrgb : kMostExponent);
}

float ColorDistance::encode(float value) const
{
    if (identity_) return value;
    auto v = static_cast<double>(television_ ? television_->curve().decode(value) : value);
    if (srgb_) v = v <= kSrgbKnee ? v / kSrgbSlope : numbers::pow((v + kSrgbShift) / kSrgbScale, kSrgbExponent);
    return static_cast<float>(numbers::pow(std::max(v, 0.0), exponent_));
}

/// Components where they are, a whole number of registers.
void ColorDistance::encode_row(std::span<float> values) const
{
    const FloatPart zero(0.0f), one(1.0f), exponent(float_of(exponent_));
    const auto within = [](const FloatPart& v) { return (v >= FloatPart(kLeastValue)) & (v <= FloatPart(kMostValue)); };
    for (std::size_t i = 0; i < values.size(); i += kFloatPart) {
        float* const at = values.data() + i;
        FloatPart v = FloatPart::load_unaligned(at);
        std::uint32_t unknown = 0;
        if (srgb_) {
            const auto low = v <= float_of(kSrgbKnee);
            const FloatPart c = xsimd::select(low, one, (v + float_of(kSrgbShift)) / float_of(kSrgbScale));
            unknown = numbers::lanes::mask(!within(c));
            v = xsimd::select(low, v / float_of(kSrgbSlope), numbers::float_power(c, float_of(kSrgbExponent)));
        }
        const auto none = v <= zero;
        const FloatPart c = xsimd::select(none, one, v);
        unknown |= numbers::lanes::mask(!within(c));
        if (unknown == 0) xsimd::select(none, zero, numbers::float_power(c, exponent)).store_unaligned(at);
        else std::transform(at, at + kFloatPart, at, [this](float value) { return encode(value); });
    }
}

void ColorDistance::encode(EncodedColors& of, std::size_t first) const
{
    const std::size_t count = of.colors.size() - first,
                      end = first + (count + kFloatPart - 1) / kFloatPart * kFloatPart;
    const std::array<std::vector<float>*, 4> rows = {&of.red, &of.green, &of.blue, &of.transmit};
    for (std::vector<float>* row : rows) row->resize(end);
    // Apart from the powers: what is written number by number can't be read as a register at once.
    float *red = of.red.data() + first, *green = of.green.data() + first, *blue = of.blue.data() + first,
          *transmit = of.transmit.data() + first;
    const scene::Color* colors = of.colors.data() + first;
    for (std::size_t i = 0; i < count; ++i) {
        const scene::Color& c = colors[i];
        red[i] = c.red, green[i] = c.green, blue[i] = c.blue, transmit[i] = c.transmit;
    }
    for (std::vector<float>* row : rows)
        std::fill(row->begin() + static_cast<std::ptrdiff_t>(first + count), row->end(), 0.0f);
    for (float* row : {red, green, blue}) {
        const std::span<float> values(row, end - first);
        if (in_lanes_) encode_row(values);
        else std::transform(row, row + count, row, [this](float value) { return encode(value); });
    }
}

void ColorDistance::mark_unsure(const EncodedColors& of, std::size_t from, std::size_t count,
                                std::span<const std::size_t> offsets, std::uint8_t flag, std::uint8_t* out) const
{
    constexpr float kRoundings = 1e-5f;  // of the largest components: differ()'s room, and this sum's own
    const std::array<const float*, 4> parts = {of.red.data(), of.green.data(), of.blue.data(), of.transmit.data()};
    const FloatPart threshold(static_cast<float>(threshold_));
    const auto sure_at = [&](std::size_t i) {
        FloatPart apart(0.0f), size(0.0f);
        for (const float* part : parts) {
            const auto at = [&](std::size_t offset) { return FloatPart::load_unaligned(part + from + i + offset); };
            FloatPart low = at(offsets[0]), high = low;
            for (const std::size_t offset : offsets) {
                const FloatPart v = at(offset);
                low = xsimd::min(low, v), high = xsimd::max(high, v);
                size += v - v;  // no number: nothing is sure
            }
            apart += high - low;
            size += xsimd::max(xsimd::abs(low), xsimd::abs(high));
        }
        return numbers::lanes::mask(apart + FloatPart(kRoundings) * size < threshold);
    };
    constexpr std::uint32_t kAll = (1u << kFloatPart) - 1;
    std::size_t i = 0;
    for (; i + kFloatPart <= count; i += kFloatPart) {
        const std::uint32_t sure = sure_at(i);
        if (sure == kAll) continue;
        for (std::size_t k = 0; k < kFloatPart; ++k)
            if ((sure >> k & 1u) == 0) out[i + k] = static_cast<std::uint8_t>(out[i + k] | flag);
    }
    for (; i < count; ++i) out[i] = static_cast<std::uint8_t>(out[i] | flag);
}

}  // namespace trace
