#pragma once

#include "csg/packet/lanes/lane_interval.h"

#include <array>
#include <cstring>

namespace csg {

/// Rays of a tile in the space of a solid, with the reciprocals of their directions. They are kept for the next solid
/// that stands in the same space: boxes of one object mostly do, and their reciprocals are half of their test.
template <class Origins>
class TurnedRays {
public:
    /// What is found from now on is in this space.
    template <class Rays>
    void turn(const Transform& frame, const Rays& rays)
    {
        if (frame_ != nullptr && same(*frame_, frame)) return;
        frame_ = &frame;
        known_ = 0;
        if constexpr (Origins::kShared) origin_ = lanes::into(frame, rays.origin);
    }

    /// The rays are others from now on.
    void forget() { frame_ = nullptr; }

    /// The rays from i on.
    template <class Rays>
    void find(int i, const Rays& rays)
    {
        if ((known_ >> i & 1) != 0) return;
        known_ |= std::uint64_t{1} << i;
        const lanes::Directions d = lanes::turned(*frame_, rays.directions(i));
        store(direction_, i, d.x, d.y, d.z);
        store(inverse_, i, 1.0 / d.x, 1.0 / d.y, 1.0 / d.z);
        if constexpr (!Origins::kShared) {
            const lanes::Points o = lanes::into(*frame_, rays.origins(i));
            store(origin_, i, o.x, o.y, o.z);
        }
    }

    lanes::Directions directions(int i) const { return load<lanes::Directions>(direction_, i); }
    lanes::Directions inverses(int i) const { return load<lanes::Directions>(inverse_, i); }
    auto origins(int i) const
    {
        if constexpr (Origins::kShared) return origin_;
        else return load<lanes::Points>(origin_, i);
    }

private:
    struct alignas(64) Vectors {
        std::array<double, 64> x, y, z;
    };

    /// To the last bit, signs of zeros too.
    static bool same(const Transform& a, const Transform& b)
    {
        return &a == &b || (std::memcmp(&a.inverse_linear, &b.inverse_linear, sizeof(a.inverse_linear)) == 0 &&
                            std::memcmp(&a.offset, &b.offset, sizeof(a.offset)) == 0);
    }
    static void store(Vectors& to, int i, const lanes::Double& x, const lanes::Double& y, const lanes::Double& z)
    {
        x.store_aligned(to.x.data() + i);
        y.store_aligned(to.y.data() + i);
        z.store_aligned(to.z.data() + i);
    }
    template <class Three>
    static Three load(const Vectors& from, int i)
    {
        using lanes::Double;
        return {Double::load_aligned(from.x.data() + i), Double::load_aligned(from.y.data() + i),
                Double::load_aligned(from.z.data() + i)};
    }

    const Transform* frame_ = nullptr;
    std::uint64_t known_ = 0;  ///< a bit a ray
    Vectors direction_, inverse_;
    std::conditional_t<Origins::kShared, glm::dvec3, Vectors> origin_;
};

}  // namespace csg
