#pragma once

#include <cstdint>
#include <string_view>

namespace scene {

/// How the points of a prism's or a lathe's outline are joined (spec 5b, 6.1).
enum class Curve : std::uint8_t { Linear, Quadratic, Cubic, Bezier };

inline std::string_view name_of(Curve curve)
{
    static constexpr std::string_view kNames[] = {"linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline"};
    return kNames[static_cast<std::size_t>(curve)];
}

}  // namespace scene
