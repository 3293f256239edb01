#pragma once

#include "bench/numerics/quad_polynomial.h"
#include "csg/solids/solid.h"

namespace numerics {

/// A solid along one ray: the parameters where every part is not positive.
using Parts = std::vector<QuadPolynomial>;

struct Point {
    QuadPolynomial x, y, z;
};

/// The ray in world space, counted from `shift` on, and in a frame: from the doubles as they are stored. Near the
/// object the polynomials keep their digits; from a far camera a quartic would lose all 113 bits.
Point along(const csg::Ray& ray, double shift);
Point local(const csg::Transform& frame, const Point& p);
/// Where a ray comes nearest to a frame's origin, in the frame's own lengths: a solid flattened 1e8 times is met near
/// there, and a polynomial counted from farther off would lose its digits to the large direction.
double foot(const csg::Transform& frame, const csg::Ray& ray);

Parts parts_of(const csg::Sphere&, const Point&);
Parts parts_of(const csg::Ellipsoid&, const Point&);
Parts parts_of(const csg::Box&, const Point&);
Parts parts_of(const csg::OrientedBox&, const Point&);
Parts parts_of(const csg::Plane&, const Point&);
Parts parts_of(const csg::Cylinder&, const Point&);
Parts parts_of(const csg::Cone&, const Point&);
Parts parts_of(const csg::Torus&, const Point&);
Parts parts_of(const csg::Quadric&, const Point&);
Parts parts_of(const csg::Polynomial&, const Point&);

/// Every judgement takes the slow and plain way: recursion over turns, repeated multiplication, definitions alone.
/// Set once, before anything is asked; the two ways are compared by it (docs/numerics.md).
inline bool plain_judge = false;

/// Parameters in [low, high] where the ray goes in or out, ascending.
std::vector<Quad> crossings(const Parts& parts, Quad low, Quad high);
bool inside(const Parts& parts, Quad t);
/// A triangle lies in world space, so it is judged as stored: by the signs of the ray's volumes with its edges.
std::vector<Quad> crossings(const csg::Triangle& triangle, const csg::Ray& ray, Quad low, Quad high);

}  // namespace numerics
