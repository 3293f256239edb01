#pragma once

#include "csg/freeform/field/rounded_box.h"

#include <glm/glm.hpp>

#include <array>

namespace csg {

/// Eight points or boxes, coordinate by coordinate.
struct Eight {
    alignas(64) double v[8];
};
struct EightPoints {
    Eight x, y, z;
};
/// Every number from low to high; low <= high, ends may be infinite.
struct EightRanges {
    Eight low, high;
};
struct EightBoxes {
    EightRanges x, y, z;
};

/// The points from + s * way, s from 0 to 1, each coordinate off by up to `room`.
struct FieldStretch {
    glm::dvec3 from, way, room;
};
/// What a field is along a stretch: the sum of c[i] s^i, cut off at +-limit.
struct FieldPolynomial {
    static constexpr int kMost = 7;
    std::array<double, kMost + 1> c;
    int degree;
    double size;   ///< of the absolute values of all terms
    double error;  ///< at most what values are off by, as far as it comes from the coefficients
    double limit;
};

/// A number for every point of space: what isosurfaces and parametric surfaces are made of. Immutable, asked by many
/// threads at once; no call allocates.
class Field {
public:
    virtual ~Field() = default;
    virtual double value(const glm::dvec3& p) const = 0;
    /// Equal to value() bit for bit.
    virtual void values(const EightPoints& p, Eight& out) const = 0;
    /// Ranges that hold every value in the boxes.
    virtual void ranges(const EightBoxes& boxes, EightRanges& out) const = 0;
    /// Whether ranges() narrow down as boxes do. False: its value at points is all that is known.
    virtual bool ranged() const = 0;
    /// The field along a stretch if it is a polynomial there, whose values are those of value() but for twice the
    /// error.
    virtual bool along(const FieldStretch&, FieldPolynomial&) const { return false; }
    /// Whether along() may know it.
    virtual bool polynomial() const { return false; }
    /// What gives the same bits as value(), where it is that: asked without a call, and known to be convex.
    virtual const RoundedBox* rounded_box() const { return nullptr; }
};

}  // namespace csg
