#pragma once

#include "numbers/lane_power.h"
#include "render/texture/sky.h"

namespace trace {

inline constexpr double kSkyDistance = 2e10;  ///< length of a ray that meets nothing, for fog and media

/// Share of light that a fog that is the same everywhere lets pass over a length, no longer than to the sky (spec 2,
/// section 16). T is double or lanes::Double.
template <class T>
inline T fog_transmission(const texture::Fog& fog, const T& length)
{
    using numbers::lanes::choose;
    const T far(kSkyDistance), least(-700.0), clear(static_cast<double>(fog.color.transmit));
    const T y = -choose(length < far, length, far) / T(fog.distance);
    const T passes = numbers::lanes::exponential(choose(y > least, choose(y < -least, y, -least), least));
    return choose(passes > clear, passes, clear);
}

}  // namespace trace
