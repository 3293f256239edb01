#pragma once

#include <algorithm>
#include <cmath>

namespace trace::path {

/// Share of unpolarised light that a smooth boundary mirrors (Fresnel). \param cosine of the incidence
/// \param ratio index on this side over that behind
inline double fresnel(double cosine, double ratio)
{
    const double sine2 = ratio * ratio * (1.0 - cosine * cosine);
    if (sine2 >= 1.0) return 1.0;
    const double behind = std::sqrt(1.0 - sine2);
    const double s = (ratio * cosine - behind) / (ratio * cosine + behind),
                 p = (cosine - ratio * behind) / (cosine + ratio * behind);
    return std::clamp(0.5 * (s * s + p * p), 0.0, 1.0);
}

}  // namespace trace::path
