#include "function/internal/internal.h"
#include "function/internal/internal_ranges.h"
#include "function/intervals/ends.h"
#include "function/intervals/interval_arithmetic.h"
#include "function/intervals/interval_rules.h"
#include "function/intervals/shape_ends.h"
#include "function/lone_internal.h"
#include "numbers/functions/lane_functions.h"
#include "numbers/lane_arithmetic.h"

#include <numbers>

/// Eight intervals at once: what arithmetic needs runs in vector registers, the rest lane by lane.
namespace function {

struct EightIntervals {
    alignas(64) double low[kLanes], high[kLanes];
    EightIntervals() = default;
    EightIntervals(double v)  // implicit: constants of formulas
    {
        std::fill_n(low, kLanes, v);
        std::fill_n(high, kLanes, v);
    }
    Interval lane(std::size_t i) const { return {low[i], high[i]}; }
    void set(std::size_t i, const Interval& v) { low[i] = v.low, high[i] = v.high; }
};

namespace {

Ends ends(const EightIntervals& a, std::size_t i)
{
    return {Batch::load_aligned(a.low + i), Batch::load_aligned(a.high + i)};
}

template <class F>
EightIntervals batchwise(const EightIntervals& a, const EightIntervals& b, F&& f)
{
    EightIntervals out;
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const Ends one = f(ends(a, i), ends(b, i));
        one.low.store_aligned(out.low + i);
        one.high.store_aligned(out.high + i);
    }
    return out;
}

template <class F>
EightIntervals each_lane(F&& f)
{
    EightIntervals out;
    for (std::size_t i = 0; i < kLanes; ++i) out.set(i, f(i));
    return out;
}

}  // namespace

EightIntervals arc_tangent(const EightIntervals& y, const EightIntervals& x)
{
    return batchwise(y, x, [](const Ends& a, const Ends& b) { return arc_tangent(a, b); });
}

EightIntervals squared(const EightIntervals& a)
{
    return batchwise(a, a, [](const Ends& x, const Ends&) { return squared(x); });
}
EightIntervals absolute(const EightIntervals& a)
{
    return batchwise(a, a, [](const Ends& x, const Ends&) { return absolute(x); });
}
EightIntervals sqrt(const EightIntervals& a)
{
    return batchwise(a, a, [](const Ends& x, const Ends&) { return sqrt(x); });
}
EightIntervals larger(const EightIntervals& a, const EightIntervals& b)
{
    return batchwise(a, b, [](const Ends& x, const Ends& y) { return larger(x, y); });
}
EightIntervals operator+(const EightIntervals& a, const EightIntervals& b)
{
    return batchwise(a, b, [](const Ends& x, const Ends& y) { return x + y; });
}
EightIntervals operator-(const EightIntervals& a, const EightIntervals& b)
{
    return batchwise(a, b, [](const Ends& x, const Ends& y) { return x - y; });
}
EightIntervals operator*(const EightIntervals& a, const EightIntervals& b)
{
    return &a == &b ? squared(a) : batchwise(a, b, multiply);  // a number times itself is no product of two
}

/// A constant exponent's in registers, others lane by lane.
EightIntervals power(const EightIntervals& a, const EightIntervals& b)
{
    const double exponent = b.low[0];
    bool constant = std::abs(exponent) < 1e6;
    for (std::size_t i = 0; i < kLanes; ++i) constant = constant && b.low[i] == exponent && b.high[i] == exponent;
    if (!constant) return each_lane([&](std::size_t i) { return interval_binary(Op::Power, a.lane(i), b.lane(i)); });
    if (exponent == std::floor(exponent))
        return batchwise(a, a, [&](const Ends& x, const Ends&) { return whole_power(x, exponent); });
    return batchwise(a, a, [&](const Ends& x, const Ends&) { return power(x, exponent); });
}

/// A constant divisor's in registers, others lane by lane.
EightIntervals modulo(const EightIntervals& a, const EightIntervals& b)
{
    const double divisor = b.low[0];
    bool constant = std::isnormal(divisor);
    for (std::size_t i = 0; i < kLanes; ++i) constant = constant && b.low[i] == divisor && b.high[i] == divisor;
    if (!constant) return each_lane([&](std::size_t i) { return interval_binary(Op::Modulo, a.lane(i), b.lane(i)); });
    return batchwise(a, a, [&](const Ends& x, const Ends&) { return modulo(x, divisor); });
}

/// f grows with its argument on [from, to]; outside it has no value.
template <class F>
EightIntervals growing(const EightIntervals& a, F&& f, double from = -kInf, double to = kInf)
{
    return batchwise(a, a, [&](const Ends& x, const Ends&) {
        const Batch least(from), most(to);
        const Ends w = widened(f(numbers::lanes::larger(x.low, least)), f(numbers::lanes::smaller(x.high, most)));
        return or_all((x.high < least) | (x.low > most), -kInf, kInf, w);
    });
}

template <>
struct Rules<EightIntervals> {
    static EightIntervals constant(double c) { return c; }

    template <Op op>
    static EightIntervals binary(const EightIntervals& a, const EightIntervals& b)
    {
        if constexpr (op == Op::Add) return a + b;
        else if constexpr (op == Op::Subtract) return a - b;
        else if constexpr (op == Op::Multiply) return a * b;
        else if constexpr (op == Op::Divide) return batchwise(a, b, divide);
        else if constexpr (op == Op::Min)
            return batchwise(a, b, [](const Ends& x, const Ends& y) {
                return Ends{xsimd::min(x.low, y.low), xsimd::min(x.high, y.high)};
            });
        else if constexpr (op == Op::Max) return larger(a, b);
        else if constexpr (op == Op::Atan2) return arc_tangent(a, b);
        else if constexpr (op == Op::Power) return power(a, b);
        else if constexpr (op == Op::Modulo) return modulo(a, b);
        else return each_lane([&](std::size_t i) { return interval_binary(op, a.lane(i), b.lane(i)); });
    }

#define OF_BATCH(name) [](const Batch& v) { return numbers::name(v); }
    template <Op op>
    static EightIntervals unary(const EightIntervals& a)
    {
        if constexpr (op == Op::Negate)
            return batchwise(a, a, [](const Ends& x, const Ends&) { return Ends{-x.high, -x.low}; });
        else if constexpr (op == Op::Abs) return absolute(a);
        else if constexpr (op == Op::Sqrt) return sqrt(a);
        else if constexpr (op == Op::Exp)
            return batchwise(a, a, [](const Ends& x, const Ends&) { return exponential(x); });
        else if constexpr (op == Op::Sin || op == Op::Cos)
            return batchwise(
                a, a, [](const Ends& x, const Ends&) { return sine(x, op == Op::Sin ? 0.0 : std::numbers::pi / 2); });
        else if constexpr (op == Op::Cosh)
            return batchwise(a, a, [](const Ends& x, const Ends&) {
                const Ends s = absolute(x);
                return widened(numbers::cosh(s.low), numbers::cosh(s.high));
            });
        else if constexpr (op == Op::Ln) return growing(a, OF_BATCH(log), 0.0);
        else if constexpr (op == Op::Log) return growing(a, OF_BATCH(log10), 0.0);
        else if constexpr (op == Op::Acosh) return growing(a, OF_BATCH(acosh), 1.0);
        else if constexpr (op == Op::Asin) return growing(a, OF_BATCH(asin), -1.0, 1.0);
        else if constexpr (op == Op::Atanh) return growing(a, OF_BATCH(atanh), -1.0, 1.0);
        else if constexpr (op == Op::Asinh) return growing(a, OF_BATCH(asinh));
        else if constexpr (op == Op::Atan) return growing(a, OF_BATCH(atan));
        else if constexpr (op == Op::Sinh) return growing(a, OF_BATCH(sinh));
        else if constexpr (op == Op::Tanh) return growing(a, OF_BATCH(tanh));
        else return each_lane([&](std::size_t i) { return interval_unary(op, a.lane(i)); });
    }
#undef OF_BATCH

    /// Every branch that can be taken, lane by lane.
    static void select(Machine<EightIntervals>& m, const Branching& b, std::uint32_t dst)
    {
        const EightIntervals c = m.reg(b.condition);
        EightIntervals all = constant(0.0);
        bool some[kLanes] = {};
        for (std::size_t k = 0; k < b.count; ++k) {
            bool can[kLanes], any = false;
            for (std::size_t i = 0; i < kLanes; ++i) any = (can[i] = branch_possible(c.lane(i), b.count, k)) || any;
            if (!any) continue;
            m.run(b.begin[k], b.end[k]);
            const EightIntervals& value = m.reg(b.result[k]);
            for (std::size_t i = 0; i < kLanes; ++i) {
                if (!can[i]) continue;
                all.set(i, some[i] ? all.lane(i).hull(value.lane(i)) : value.lane(i));
                some[i] = true;
            }
        }
        for (std::size_t i = 0; i < kLanes; ++i)
            if (!some[i]) all.set(i, Interval::everything());
        m.reg(dst) = all;
    }

    /// As for one interval, while all lanes begin at one number.
    static void loop(Machine<EightIntervals>& m, const Loop& l, std::uint32_t dst)
    {
        const EightIntervals from = m.reg(l.from), to = m.reg(l.to);
        double last = -kInf;
        bool known = true;
        for (std::size_t i = 0; i < kLanes; ++i) {
            known = known && from.lane(i).point() && from.low[i] == from.low[0];
            last = std::max(last, to.high[i]);
        }
        if (!known || !(last - from.low[0] < kMostRounds)) {
            m.reg(dst) = each_lane([](std::size_t) { return Interval::everything(); });
            return;
        }
        EightIntervals all = constant(l.product ? 1.0 : 0.0);
        for (double k = from.low[0]; k <= last; k += 1.0) {
            m.reg(l.counter) = constant(k);
            m.run(l.begin, l.end);
            const EightIntervals& value = m.reg(l.result);
            for (std::size_t i = 0; i < kLanes; ++i) {
                if (!(k <= to.high[i])) continue;
                const Interval next = l.product ? all.lane(i) * value.lane(i) : all.lane(i) + value.lane(i);
                all.set(i, k <= to.low[i] ? next : all.lane(i).hull(next));
            }
        }
        m.reg(dst) = all;
    }

    static EightIntervals internal(std::uint32_t n, std::uint32_t count, const EightIntervals* a, const Host&,
                                   const double*)
    {
        EightIntervals out;
        if (in_registers(n, count, out, [&](std::uint32_t k, std::size_t i) { return ends(a[k], i); })) return out;
        if (n == 47) return arc_tangent(distance<EightIntervals>(a[0], 0.0, a[2]), a[1]);
        if (n == 69) return arc_tangent(a[0], a[2]);
        return each_lane([&](std::size_t lane) {
            Interval one[kMostParameters];
            for (std::uint32_t i = 0; i < count; ++i) one[i] = a[i].lane(lane);
            return internal_interval(n, one);
        });
    }

    static void outer(const SceneReference& what, const EightIntervals* a, const Host&, EightIntervals* out)
    {
        if (const auto* moved = std::get_if<csg::Transform>(&what)) {
            for (std::size_t i = 0; i < kLanes; i += kWidth) {
                const Ends from[] = {ends(a[0], i), ends(a[1], i), ends(a[2], i)};
                Ends to[3];
                moved_ranges(*moved, from, to);
                for (std::size_t k = 0; k < 3; ++k) {
                    to[k].low.store_aligned(out[k].low + i);
                    to[k].high.store_aligned(out[k].high + i);
                }
            }
            for (std::size_t k = 3; k < 5; ++k) out[k] = each_lane([](std::size_t) { return Interval::everything(); });
            return;
        }
        const std::size_t count = std::holds_alternative<std::shared_ptr<const Spline>>(what) ? 1 : 3;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            Interval one[3], found[5];
            for (std::size_t i = 0; i < count; ++i) one[i] = a[i].lane(lane);
            outer_interval(what, one, found);
            for (std::size_t k = 0; k < 5; ++k) out[k].set(lane, found[k]);
        }
    }

    /// A formula from its first step to its last for what a register holds, parameter k of it at lanes from i on being
    /// get(k, i): no step waits for memory. Out: anything with places `low` and `high`.
    template <class Out, class Get>
    static bool in_registers(std::uint32_t n, std::uint32_t count, Out& out, Get&& get)
    {
        Ends one[kMostParameters], found;
        for (std::size_t i = 0; i < kLanes; i += kWidth) {
            for (std::uint32_t k = 0; k < count; ++k) one[k] = get(k, i);
            if (n == kRoundedBox) found = rounded_box_ends(one);
            else if (!arithmetic_range(n, one, found) && !shape_range(n, one, found)) return false;
            found.low.store_unaligned(&out.low[i]);
            found.high.store_unaligned(&out.high[i]);
        }
        return true;
    }

private:
    static constexpr std::size_t kMostParameters = LoneInternal::kMostArguments;
};

void evaluate_intervals(const Function& function, const double (*low)[kLanes], const double (*high)[kLanes],
                        const Host& host, double* out_low, double* out_high)
{
    if (const LoneInternal call(function); call) {
        struct {
            double *low, *high;
        } out{out_low, out_high};
        const auto get = [&](std::uint32_t k, std::size_t i) {
            const auto parameter = [&](std::uint32_t p) {
                return Ends(Batch::load_unaligned(low[p] + i), Batch::load_unaligned(high[p] + i));
            };
            return call.argument<Ends>(k, parameter);
        };
        if (Rules<EightIntervals>::in_registers(call.number(), call.count(), out, get)) return;
    }
    constexpr std::size_t kMostArguments = 64;
    EightIntervals loaded[kMostArguments];
    for (std::uint32_t i = 0; i < function.parameters; ++i) {
        std::copy_n(low[i], kLanes, loaded[i].low);
        std::copy_n(high[i], kLanes, loaded[i].high);
    }
    const EightIntervals value = run_function<EightIntervals>(function, loaded, host);
    std::copy_n(value.low, kLanes, out_low);
    std::copy_n(value.high, kLanes, out_high);
}

}  // namespace function
