#pragma once

#include "csg/world/world.h"
#include "render/plan/probe.h"

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

/// Objects of a scene as bodies: measured, and written as triangles.
namespace solid {

/// A place where a line passes through the boundary of a body.
struct End {
    double t = 0.0;
    csg::PartId part = csg::kNoPart;
    std::uint32_t face = 0;
    std::uint32_t instance = csg::Hit::kNoInstance;
    bool inverted = false;
};

/// A part of a line inside a body.
struct Chord {
    End in, out;
    double length() const { return out.t - in.t; }
};

/// Where a line is in a box that is wider by `room` on each side, from and to; nowhere if the first is above the
/// second.
std::pair<double, double> line_in_box(const csg::Aabb& box, const csg::Ray& line, double room = 0.0);

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
    const csg::Aabb& bounds() const { return bounds_; }

    /// The parts inside of the line through `point` along the unit vector `direction` that meet [from, to], correct
    /// within that range only. Sorted and disjoint. Chords and gaps shorter than slack() are left out: faces in one
    /// place leave such films. Wherever the point is, the line is followed from before the body: the same place is told
    /// for the same line. Of a body without end it is followed from `from`, which is finite then.
    void chords(const glm::dvec3& point, const glm::dvec3& direction, double from, double to,
                std::vector<Chord>& out) const;

    /// Out of the body, unit length; 0 where the solid does not know it: at ends that are not drawn.
    glm::dvec3 normal(const glm::dvec3& point, const End& end) const;

    bool inside(const glm::dvec3& point, const glm::dvec3& along) const;

    double slack() const { return slack_; }

    /// Whether a part of it is not worth being remeshed: isosurfaces are searched along each line, which is slow, and a
    /// height field is small facets.
    bool is_unsmooth() const { return unsmooth_; }

private:
    plan::ObjectProbe probe_;
    csg::Aabb bounds_;
    std::vector<csg::Aabb> boxes_;  ///< around the inside of each item
    glm::dvec3 middle_{0.0};
    double radius_ = 0.0;  ///< of a sphere about middle_ that holds the box, where that is finite
    double slack_ = 0.0;
    bool unsmooth_ = false;
};

}  // namespace solid
