#pragma once

#include "csg/world/inside_lines.h"
#include "render/plan/probe.h"

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

/// Objects of a scene as bodies: measured, and written as triangles.
namespace solid {

using csg::Chord;
using csg::line_in_box;
using End = csg::LineEnd;

/// What a body cannot be: without an end, or with nothing inside.
class NoBody : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// One object as the set of points inside of it (spec 5a, 2.4): what a mesh without inside_vector, a patch or a light
/// is not, and what a clip cuts off is not either. May be asked from any number of threads.
class Body {
public:
    /// Isosurfaces are asked more exactly than they are drawn, as far as that is cheap.
    Body(const scene::Object& object, const scene::GlobalSettings& global);

    /// A box around the inside. Sides are infinite where nothing says where it ends; empty: there is no inside.
    const csg::Aabb& bounds() const { return lines_.bounds(); }

    /// csg::InsideLines::chords() of the line through `point` along the unit vector `direction`.
    void chords(const glm::dvec3& point, const glm::dvec3& direction, double from, double to,
                std::vector<Chord>& out) const
    {
        lines_.chords({point, direction}, from, to, out);
    }
    /// For the kernel's own build, which is asked for many lines at a time (trace::KernelTable).
    const csg::InsideLines& lines() const { return lines_; }

    /// Out of the body, unit length; 0 where the solid does not know it: at ends that are not drawn.
    glm::dvec3 normal(const glm::dvec3& point, const End& end) const;

    bool inside(const glm::dvec3& point, const glm::dvec3& along) const;

    double slack() const { return lines_.slack(); }

    /// Facets of its height fields are so wide: what is finer is not smooth. 0: there are none.
    double grain() const { return grain_; }

private:
    plan::ObjectProbe probe_;
    csg::InsideLines lines_;
    double grain_ = 0.0;
};

}  // namespace solid
