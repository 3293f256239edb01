#pragma once

#include "csg/freeform/revolution/axis_rays.h"

/// Compiled once per instruction set.
namespace csg {

/// What rays in lanes through a lathe are worked out with.
struct LatheLanes {
    using Double = AxisRays::Double;
    using Bool = AxisRays::Bool;

    /// SlopeRange.
    struct Range {
        Double least, most;
        Bool negative;
    };

    static Double smaller(const Double& a, const Double& b) { return AxisRays::smaller(a, b); }
    static Double larger(const Double& a, const Double& b) { return AxisRays::larger(a, b); }
    static Bool differ(const Bool& a, const Bool& b) { return (a & (!b)) | ((!a) & b); }
    static Bool negative(const Double& v) { return v < Double(0.0); }
    static Double pick(const Bool& which, const Double& yes, const Double& no) { return xsimd::select(which, yes, no); }

    static Range slope_range(const Double& a0, const Double& a1, const Double& b0, const Double& b1)
    {
        const Bool a_down0 = negative(a0), a_down1 = negative(a1), b_down0 = negative(b0), b_down1 = negative(b1);
        const Double zero(0.0), a_size0 = xsimd::abs(a0), a_size1 = xsimd::abs(a1), b_size0 = xsimd::abs(b0),
                                b_size1 = xsimd::abs(b1);
        const Double a_least = pick(differ(a_down0, a_down1), zero, smaller(a_size0, a_size1)),
                     b_least = pick(differ(b_down0, b_down1), zero, smaller(b_size0, b_size1));
        return {a_least * b_least, larger(a_size0, a_size1) * larger(b_size0, b_size1),
                differ(negative(a0 + a1), negative(b0 + b1))};
    }
    static Bool apart(const Range& a, const Range& b)
    {
        return differ(a.negative, b.negative) | (a.least > b.most) | (b.least > a.most);
    }
};

}  // namespace csg
