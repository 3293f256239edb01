#pragma once

#include "csg/base/types.h"

/// How far from its start a ray looks before what it meets counts: nearer crossings are the surface that it starts on.
namespace csg {

struct Tolerance {
    double hit = 1e-4;     ///< of camera and secondary rays (spec 3, 3.1)
    double shadow = 1e-3;  ///< of shadow rays, at both ends

    /// Of a start that a ray of this `length` reached: POV-Ray's, unless the digits of the numbers are coarser. No
    /// solid of the laboratory but isosurface and julia, which are told how exact to be, meets its own start beyond
    /// 2e-13 of them (docs/numerics.md), so this begins at 5e8.
    [[gnu::always_inline]] double hit_from(const glm::dvec3& start, double length) const
    {
        return glm::max(hit, coarse(start, length));
    }
    double shadow_from(const glm::dvec3& start, double length) const { return glm::max(shadow, coarse(start, length)); }

    /// For a scene whose finite objects and camera lie within `extent` of each other: smaller in proportion where that
    /// is less than 1, so that a scene looks the same at any scale. POV-Ray's own are absolute, and such a scene loses
    /// shadows there.
    static Tolerance of_scene(double extent)
    {
        const Tolerance usual;
        return extent < 1.0 ? Tolerance{usual.hit * extent, usual.shadow * extent} : usual;
    }

    /// Beyond this a ray meets no more of its own start: rounding moved that off the surface, and the flatter the ray
    /// leaves the longer it is on its way back. `incidence`: cosine of its angle with the normal.
    static double own(const glm::dvec3& start, double length, double incidence)
    {
        constexpr double kFlattest = 1e-6;  // there a curved surface is left anyway: sqrt(2 * kCoarse) of its radius
        return coarse(start, length) / glm::max(glm::abs(incidence), kFlattest);
    }

    /// Crossings of different objects nearer to each other than this lie in one place: there the object is seen that
    /// POV-Ray asks first (TestOrder), whatever the last bits of ours say. Each solid has a formula of its own. What
    /// they say of one face differs by up to 1.5e-14 of that where the ray's cosine with it is above 0.05
    /// (same_place_test.cpp of the plan); nothing that is drawn apart lies so close.
    /// \param reach  the largest coordinate of the ray's origin, by amount
    static constexpr double kSamePlace = 1e-12;
    template <class Number>
    static Number same_place(const Number& t, const Number& reach)
    {
        return Number(kSamePlace) * (t + reach);
    }

    static constexpr double kCoarse = 2e-13;  ///< digits that numbers have, with those that solids lose

private:
    static double coarse(const glm::dvec3& p, double length)
    {
        return kCoarse * glm::max(glm::max(glm::abs(p.x), glm::abs(p.y)), glm::max(glm::abs(p.z), length));
    }
};

}  // namespace csg
