#pragma once

#include "csg/base/numbers.h"
#include "numbers/lanes.h"

#include <cmath>
#include <cstdint>

namespace csg {

/// 1 / d, clamped so that 0 * infinity never arises; 1e30 times any distance in a scene is past its end.
inline double slab_reciprocal(double d) { return std::abs(d) < 1e-30 ? std::copysign(1e30, d) : 1.0 / d; }

/// A ray and the two sides of boxes across one axis, in single precision: boxes are only a sieve, and a ray that meets
/// one is never said to miss it.
struct SlabAxis {
    std::int32_t near_row, far_row;  ///< of BvhNode::bounds
    float near_origin, far_origin, near_inverse, far_inverse;

    /// \param inverse of the direction, finite
    SlabAxis(int axis, double start, double inverse, bool backward)
        : near_row(backward ? axis + 3 : axis), far_row(backward ? axis : axis + 3)
    {
        // Twice the error of the conversion to either side: cheaper than the neighbouring floats.
        const auto origin = static_cast<float>(start);
        const float error = std::abs(origin) * 2.4e-7f + 1e-37f, down = origin - error, up = origin + error;
        near_origin = backward ? down : up;
        far_origin = backward ? up : down;
        // Three roundings of 6e-8 each: conversion, difference and product.
        near_inverse = static_cast<float>(inverse * (1.0 - 2.4e-7));
        far_inverse = static_cast<float>(inverse * (1.0 + 3.6e-7));
    }
    SlabAxis() = default;

    /// Cuts `first` to `last` down to what lies between the sides of the boxes from `at` on.
    void cut(const float (&bounds)[6][8], int at, lanes::FloatPart& first, lanes::FloatPart& last) const
    {
        using lanes::FloatPart;
        const FloatPart near = FloatPart::load_aligned(bounds[near_row] + at),
                        far = FloatPart::load_aligned(bounds[far_row] + at);
        first = xsimd::max(first, (near - FloatPart(near_origin)) * FloatPart(near_inverse));
        last = xsimd::min(last, (far - FloatPart(far_origin)) * FloatPart(far_inverse));
    }
};

}  // namespace csg
