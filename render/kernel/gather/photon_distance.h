#pragma once

#include "numbers/lanes.h"
#include "render/kernel/gather/near_leaves.h"
#include "render/kernel/gather/photon_places.h"

#include <cmath>

namespace trace {

/// Squared distances of photons from a point (spec 6, 3.7).
/// \tparam kFlat  distances off the plane of the surface count more: the sphere of photons is flattened
template <bool kFlat>
class PhotonDistance {
public:
    using Float = numbers::lanes::FloatPart;

    PhotonDistance(const PhotonPlaces& places, const glm::dvec3& from, const glm::dvec3& surface)
        : point(from), split(from), places_(places), normal_(surface)
    {}

    double squared(std::size_t photon) const
    {
        const double dx = static_cast<double>(places_.x[photon]) - point.x,
                     dy = static_cast<double>(places_.y[photon]) - point.y,
                     dz = static_cast<double>(places_.z[photon]) - point.z, d2 = dx * dx + dy * dy + dz * dz;
        if constexpr (!kFlat) return d2;
        return d2 * (1.0 + kFlattening * std::abs(normal_.x * dx + normal_.y * dy + normal_.z * dz));
    }

    /// In single precision, which is enough to tell which are nearest.
    Float squared(const Float& x, const Float& y, const Float& z) const
    {
        const Float dx = x - Float(split.high.x) - Float(split.low.x),
                    dy = y - Float(split.high.y) - Float(split.low.y),
                    dz = z - Float(split.high.z) - Float(split.low.z), d2 = dx * dx + dy * dy + dz * dz;
        if constexpr (!kFlat) return d2;
        const glm::vec3 n(normal_);
        return d2 * (Float(1.0f) + Float(static_cast<float>(kFlattening)) *
                                       xsimd::abs(Float(n.x) * dx + Float(n.y) * dy + Float(n.z) * dz));
    }

    const glm::dvec3 point;
    const SplitPoint split;

private:
    static constexpr double kFlattening = 16.0;

    const PhotonPlaces& places_;
    const glm::dvec3 normal_;
};

}  // namespace trace
