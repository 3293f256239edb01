#include "function/intervals/interval.h"

#include "function/intervals/interval_arithmetic.h"
#include "function/internal/internal_ranges.h"
#include "function/intervals/interval_rules.h"

namespace function {
namespace {

/// Whether its interval shrinks to a point as its arguments do.
bool internal_narrows(std::uint32_t n)
{
    return is_polynomial(n) || n == 17 || n == 47 || n == 57 || n == 60 || n == 61 || n == 69 || n == 70 || n == 77 ||
           has_shape_range(n);
}

}  // namespace

Interval internal_interval(std::uint32_t n, const Interval* a)
{
    Interval out;
    if (arithmetic_range(n, a, out)) return out;
    switch (n) {
    case 47: return interval_binary(Op::Atan2, distance<Interval>(a[0], 0.0, a[2]), a[1]);
    case 69: return interval_binary(Op::Atan2, a[0], a[2]);
    case 76:
    case 78: return {0.0, 1.0};
    case 77: return 0.0;
    default: return Interval::everything();
    }
}

void outer_interval(const SceneReference& what, const Interval* a, Interval* out)
{
    std::fill(out, out + 5, Interval::everything());
    if (const auto* moved = std::get_if<csg::Transform>(&what)) {
        moved_ranges(*moved, a, out);
    } else if (const auto* use = std::get_if<SceneUse>(&what); use && use->kind == SceneUse::Kind::Pattern) {
        out[0].low = 0.0;  // patterns are folded to above 0
    }
}

bool narrows(const Function& function)
{
    for (const Instruction& in : function.code) {
        if (in.op != Op::Call && in.op != Op::Internal && in.op != Op::SceneReference) continue;
        const SceneReference& what = function.outer[in.c];
        if (const auto* called = std::get_if<FunctionPtr>(&what); called && !narrows(**called)) return false;
        if (const auto* n = std::get_if<std::uint32_t>(&what); n && !internal_narrows(*n)) return false;
        if (in.op == Op::SceneReference && !std::holds_alternative<csg::Transform>(what)) return false;
    }
    return true;
}

template <>
struct Rules<Interval> {
    static Interval constant(double v) { return v; }
    template <Op op>
    static Interval binary(const Interval& a, const Interval& b)
    {
        return interval_binary(op, a, b);
    }
    template <Op op>
    static Interval unary(const Interval& a)
    {
        return interval_unary(op, a);
    }

    /// Every branch that can be taken.
    static void select(Machine<Interval>& m, const Branching& b, std::uint32_t dst)
    {
        const Interval c = m.reg(b.condition);
        bool some = false;
        Interval all;
        for (std::size_t k = 0; k < b.count; ++k) {
            if (!branch_possible(c, b.count, k)) continue;
            m.run(b.begin[k], b.end[k]);
            all = some ? all.hull(m.reg(b.result[k])) : m.reg(b.result[k]);
            some = true;
        }
        m.reg(dst) = some ? all : Interval::everything();
    }

    /// Rounds that are sure, then those that may be.
    static void loop(Machine<Interval>& m, const Loop& l, std::uint32_t dst)
    {
        const Interval from = m.reg(l.from), to = m.reg(l.to);
        Interval all = l.product ? 1.0 : 0.0;
        if (!from.point() || !(to.high - from.low < kMostRounds)) {
            m.reg(dst) = Interval::everything();
            return;
        }
        for (double i = from.low; i <= to.high; i += 1.0) {
            m.reg(l.counter) = i;
            m.run(l.begin, l.end);
            const Interval next = l.product ? all * m.reg(l.result) : all + m.reg(l.result);
            all = i <= to.low ? next : all.hull(next);
        }
        m.reg(dst) = all;
    }

    static Interval internal(std::uint32_t n, std::uint32_t, const Interval* a, const Host&, const double*)
    {
        return internal_interval(n, a);
    }
    static void outer(const SceneReference& what, const Interval* a, const Host&, Interval* out)
    {
        outer_interval(what, a, out);
    }
};

Interval evaluate_interval(const Function& function, const Interval* arguments, const Host& host)
{
    return run_function<Interval>(function, arguments, host);
}

}  // namespace function
