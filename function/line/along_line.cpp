#include "function/line/along_line.h"

#include "function/internal/internal_ranges.h"
#include "function/line/line_polynomial.h"
#include "function/machine.h"
#include "function/points/evaluate.h"

#include <limits>

namespace function {

template <>
struct Rules<LinePolynomial> {
    static LinePolynomial constant(double v) { return v; }

    template <Op op>
    static LinePolynomial binary(const LinePolynomial& a, const LinePolynomial& b)
    {
        if constexpr (op == Op::Add) return a + b;
        else if constexpr (op == Op::Subtract) return a - b;
        else if constexpr (op == Op::Multiply) return a * b;
        else if constexpr (op == Op::Power) return power(a, b);
        else if constexpr (op == Op::Divide) {
            if (!b.constant() || b.error > 0.0 || !std::isnormal(b.c[0]) || !std::isnormal(1.0 / b.c[0]))
                return LinePolynomial::none();
            LinePolynomial inverse(1.0 / b.c[0]);
            inverse.error = detail::kUnit * inverse.size;
            return a * inverse;
        } else return LinePolynomial::none();
    }

    template <Op op>
    static LinePolynomial unary(const LinePolynomial& a)
    {
        if constexpr (op == Op::Negate) return LinePolynomial(0.0) - a;
        else return LinePolynomial::none();
    }

    static void select(Machine<LinePolynomial>& m, const Branching&, std::uint32_t dst)
    {
        m.reg(dst) = LinePolynomial::none();
    }
    static void loop(Machine<LinePolynomial>& m, const Loop&, std::uint32_t dst)
    {
        m.reg(dst) = LinePolynomial::none();
    }

    static LinePolynomial internal(std::uint32_t n, std::uint32_t, const LinePolynomial* a, const Host&, const double*)
    {
        if (!is_polynomial(n)) return LinePolynomial::none();
        double sign = 1.0;
        const LinePolynomial body = polynomial_body(n, a, sign);
        LinePolynomial out = LinePolynomial(sign) * a[3] * body;
        out.cut = true;
        return out;
    }

    static void outer(const SceneReference& what, const LinePolynomial* a, const Host&, LinePolynomial* out)
    {
        std::fill_n(out, 5, LinePolynomial::none());
        if (const auto* t = std::get_if<csg::Transform>(&what))
            for (int row = 0; row < 3; ++row)
                out[row] = a[0] * t->linear[0][row] + a[1] * t->linear[1][row] + a[2] * t->linear[2][row] +
                           t->offset[row];
    }
};

bool evaluate_along(const Function& function, const csg::FieldStretch& stretch, csg::FieldPolynomial& out)
{
    constexpr double kLimit = 10.0;  // where the library's polynomials are cut off
    if (function.parameters > 3) return false;
    LinePolynomial arguments[3];
    for (std::uint32_t i = 0; i < function.parameters; ++i) {
        const auto k = static_cast<int>(i);
        arguments[i] = {stretch.from[k], stretch.way[k], stretch.room[k]};
    }
    const LinePolynomial found = run_function<LinePolynomial>(function, arguments, no_host());
    if (found.degree == LinePolynomial::kNone || !(found.size < std::numeric_limits<double>::max())) return false;
    static_assert(csg::FieldPolynomial::kMost == LinePolynomial::kMost);
    std::copy_n(found.c, found.degree + 1, out.c.begin());
    out.degree = found.degree;
    out.size = found.size;
    out.error = found.error;
    out.limit = found.cut ? kLimit : std::numeric_limits<double>::infinity();
    return true;
}

}  // namespace function
