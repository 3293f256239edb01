#pragma once

#include "render/scene/base/dump_writer.h"

#include <array>
#include <vector>

namespace scene {

/// Where a polynomial of x, y and z is not positive (reference manual: Poly, Cubic, Quartic, Polynomial). What is drawn
/// is scene::Polynomial.
struct PolynomialSurface {
    static constexpr std::string_view kKeywords[] = {"poly", "cubic", "quartic", "polynomial"};
    static constexpr bool kTakesSturm = true;

    struct Term {
        std::array<int, 3> powers{};
        double coefficient = 0.0;
    };

    int order = 2;                     ///< 2 to 35
    std::vector<double> coefficients;  ///< all, in POV-Ray's order (spec 5a, 5.9)
    std::vector<Term> terms;           ///< of `polynomial`, as written: of those with the same powers the last counts

    /// Number of coefficients of a polynomial of that order.
    static int count_of(int order) { return (order + 1) * (order + 2) * (order + 3) / 6; }
    void dump(DumpWriter& out) const
    {
        out.words("order", order);
        if (terms.empty()) out.list("coefficients", coefficients);
        for (const Term& t : terms) out.words("xyz", t.powers[0], t.powers[1], t.powers[2], t.coefficient);
    }
};

}  // namespace scene
