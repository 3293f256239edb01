#pragma once

#include "render/plan/compiled_scene.h"
#include "render/scene/base/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trace {

/// A colour as differences see it: encoded for the display (spec 2, 8.1), to a few units in the last place.
struct EncodedColor {
    scene::Color color;
    float red, green, blue;
};

/// Many colours, and component by component as differences see them, which is compared in lanes.
struct EncodedColors {
    std::vector<scene::Color> colors;
    std::vector<float> red, green, blue, transmit;  ///< as long as a whole number of registers from what came last

    EncodedColor operator[](std::size_t i) const { return {colors[i], red[i], green[i], blue[i]}; }
    std::size_t size() const { return colors.size(); }
};

/// How different two colours look: spec 2, 8.1.
class ColorDistance {
public:
    ColorDistance(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma);
    EncodedColor encoded(const scene::Color& c) const { return {c, encode(c.red), encode(c.green), encode(c.blue)}; }
    /// Of the colours from `first` on. Powers in lanes: the last digits are not encoded()'s, what differ() says of them
    /// is.
    void encode(EncodedColors& of, std::size_t first) const;
    /// Adds `flag` to out[i], i < count, where two of the colours `from` + i + offset may differ; the others surely
    /// don't.
    void mark_unsure(const EncodedColors& of, std::size_t from, std::size_t count, std::span<const std::size_t> offsets,
                     std::uint8_t flag, std::uint8_t* out) const;
    bool differ(const EncodedColor& a, const EncodedColor& b) const
    {
        if (a.color == b.color) return threshold_ <= 0;
        const double d = static_cast<double>(distance(a, b));
        // Next to the threshold the last digits count.
        constexpr double kRoom = 4e-6;  // of what is added up: more than the roundings of a dozen numbers
        if (!identity_ && std::abs(d - threshold_) <= kRoom * size(a, b))
            return static_cast<double>(distance(encoded(a.color), encoded(b.color))) >= threshold_;
        return d >= threshold_;
    }
    /// No two of these differ: not even the ranges of their components add up to the threshold. False: they may.
    bool surely_alike(const std::array<EncodedColor, 4>& colors) const
    {
        constexpr double kRoundings = 1e-5;  // of the largest components: differ()'s room, and this sum's own
        double apart = 0.0, size = 0.0;
        const auto add = [&](auto&& component) {
            float low = component(colors[0]), high = low;
            for (std::size_t i = 1; i < colors.size(); ++i) {
                const float v = component(colors[i]);
                low = v < low ? v : low;
                high = v > high ? v : high;
                size += static_cast<double>(v - v);  // no number: nothing is sure
            }
            apart += static_cast<double>(high) - static_cast<double>(low);
            size += static_cast<double>(std::max(std::abs(low), std::abs(high)));
        };
        add([](const EncodedColor& c) { return c.red; });
        add([](const EncodedColor& c) { return c.green; });
        add([](const EncodedColor& c) { return c.blue; });
        add([](const EncodedColor& c) { return c.color.transmit; });
        return apart + kRoundings * size < threshold_;
    }
    bool differ(const scene::Color& a, const scene::Color& b) const { return differ(encoded(a), encoded(b)); }

private:
    static float distance(const EncodedColor& a, const EncodedColor& b)
    {
        return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue) +
               std::abs(a.color.transmit - b.color.transmit);
    }
    static double size(const EncodedColor& a, const EncodedColor& b)
    {
        return static_cast<double>(std::abs(a.red) + std::abs(b.red) + std::abs(a.green) + std::abs(b.green) +
                                   std::abs(a.blue) + std::abs(b.blue) + std::abs(a.color.transmit) +
                                   std::abs(b.color.transmit));
    }
    float encode(float value) const;
    void encode_row(std::span<float> values) const;

    double exponent_;
    double threshold_;
    scene::AssumedGamma television_;  ///< what levels are decoded by first, if that is bt709 or bt2020
    bool srgb_;
    bool identity_;
    bool in_lanes_;  ///< powers in lanes know the exponent
};

}  // namespace trace
