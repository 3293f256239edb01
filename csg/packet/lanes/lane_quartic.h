#pragma once

#include "csg/packet/lanes/lane_interval.h"
#include "csg/packet/lanes/tile_rays.h"
#include "csg/solids/polynomial.h"

/// A quartic against a tile of rays, in vector lanes.
namespace csg {

/// The pieces of the rays inside a quartic, at most three a ray, as Polynomial::each_span() has them.
class QuarticEnds {
public:
    static constexpr int kPieces = 3;
    /// Of one that has no fourth powers all rays would be left to be asked one by one.
    static bool serve(const Polynomial& solid)
    {
        return solid.shape->degree() == 4 && solid.shape->has_highest_powers();
    }

    /// Of rays in the mask.
    template <class Rays>
    QuarticEnds(const Polynomial& solid, const Rays& rays, RayMask mask)
    {
        each_vector(mask, [&](int i) {
            const lanes::Directions d = lanes::turned(solid.frame, rays.directions(i));
            const auto o = lanes::into(solid.frame, rays.origins(i));
            solve(*solid.shape, {{Double(o.x), Double(o.y), Double(o.z)}, {d.x, d.y, d.z}}, i, mask);
        });
    }

    /// Rays with a first piece, with a second and a third one, and those to be asked one by one.
    RayMask met[kPieces] = {}, unclear = 0;

    lanes::Intervals piece(int which, int i) const
    {
        lanes::Intervals out;
        out.entry = Double::load_aligned(entry_[which].data() + i);
        out.exit = Double::load_aligned(exit_[which].data() + i);
        out.met = out.entry <= out.exit;
        return out;
    }

private:
    using Double = lanes::Double;
    using Bool = lanes::Bool;

    void solve(const PolynomialShape& shape, const detail::Course<Double>& given, int i, RayMask mask)
    {
        constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;
        const detail::PolynomialCourse<Double> course(shape, given);
        const auto possible = static_cast<std::uint32_t>(lanes::mask(course.possible) & (mask >> i) & kVector);
        if (possible == 0) return;
        const auto c = shape.quartic_along(course.ray);
        const auto found = detail::quartic_factors(c.data());
        const std::uint32_t sure = possible & lanes::mask(shape.has_degree(c[4])) & lanes::mask(found.safe);
        unclear |= RayMask{possible & ~sure} << i;
        Double t[4] = {lanes::beyond(), lanes::beyond(), lanes::beyond(), lanes::beyond()};
        for (int k = 0; k < 4; ++k) {
            const Bool there = k < 2 ? found.two : found.four;
            if ((lanes::mask(there) & sure) != 0)
                t[k] = xsimd::select(there, course.t(found.roots[k]), lanes::beyond());
        }
        // Where its highest power is negative, the ends of the rays are inside.
        const Bool asked = lanes::lanes_of(sure), opens = c[4] <= Double(0.0), two = asked & found.two,
                   four = asked & found.four;
        put(0, i, (asked & opens) | (two & !opens), xsimd::select(opens, lanes::before(), t[0]),
            xsimd::select(opens, t[0], t[1]));
        put(1, i, (two & opens) | (four & !opens), xsimd::select(opens, t[1], t[2]), xsimd::select(opens, t[2], t[3]));
        put(2, i, four & opens, t[3], lanes::beyond());
    }

    void put(std::size_t which, int i, Bool there, Double entry, Double exit)
    {
        met[which] |= RayMask{lanes::mask(there)} << i;
        xsimd::select(there, entry, lanes::beyond()).store_aligned(entry_[which].data() + i);
        xsimd::select(there, exit, lanes::before()).store_aligned(exit_[which].data() + i);
    }

    alignas(64) RayLanes entry_[kPieces], exit_[kPieces];
};

}  // namespace csg
