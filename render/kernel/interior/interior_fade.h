#pragma once

#include "numbers/functions/functions.h"
#include "render/plan/interior.h"

#include <cmath>

namespace trace {

inline constexpr double kNoDistance = 1e-10;  ///< a fade_distance below it counts as not given

/// Fading of light over a distance inside an interior; 1 where it does not fade (spec 3, 9.1).
/// \param shadow of a shadow ray, for which a power of 0 is none
inline glm::vec3 interior_fade(const plan::Interior& interior, double distance, bool shadow)
{
    const auto reach = static_cast<double>(interior.fade_distance), power = static_cast<double>(interior.fade_power);
    if (!(std::abs(reach) > kNoDistance) || (shadow && !(power > 0.0))) return glm::vec3(1.0f);
    constexpr double kExponential = 1000.0;  // from this power on the law is exponential
    if (power >= kExponential) {
        glm::vec3 out;
        for (int k = 0; k < 3; ++k)
            out[k] = static_cast<float>(
                numbers::exp(-(1.0 - static_cast<double>(interior.fade_color[k])) * distance / reach));
        return out;
    }
    // Powers that most scenes ask for, without the library.
    const double ways = distance / reach, loss = power == 1.0   ? ways
                                                 : power == 2.0 ? ways * ways
                                                                : numbers::pow(ways, power);
    const auto share = static_cast<float>(1.0 / (1.0 + loss));
    return interior.fade_color + (1.0f - interior.fade_color) * share;
}

}  // namespace trace
