#pragma once

#include "csg/freeform/isosurface.h"

namespace csg {

/// Two points of a ray with the field's sign between them.
struct Crossed {
    double before, behind;      ///< parameters of the ray
    double f_before, f_behind;  ///< sign * (field - threshold): the first is not below 0, the second is
};

/// One ray through the field of an isosurface.
class IsosurfaceSearch {
public:
    /// Nothing beyond `to` matters.
    IsosurfaceSearch(const IsosurfaceTerms& terms, const Ray& ray, double to)
        : terms_(terms), ray_(ray), to_(to), speed_(std::sqrt(glm::dot(ray.direction, ray.direction))), gradient_(terms.max_gradient)
    {
    }

    double value(double t) const { return terms_.field->value(ray_.at(t)) - terms_.threshold; }

    /// Where sign * (field - threshold), not below 0 at `from`, first falls below 0 before `end`.
    bool first(double from, double end, double sign, Crossed& out);
    /// The crossing between the two points.
    double narrow(Crossed found, double sign) const;

private:
    struct Sample {
        double t, f;
    };
    bool by_ranges(double from, double end, double sign, Crossed& out);
    bool bisect(const Sample& left, const Sample& right, double sign, Crossed& out);
    void sample(const Eight& t, double sign, Eight& f) const;

    const IsosurfaceTerms& terms_;
    const Ray& ray_;
    double to_, speed_, gradient_;
    double leaf_ = 0.0;         ///< no interval is parted that is shorter
};

}  // namespace csg
