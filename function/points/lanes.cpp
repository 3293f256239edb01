#include "function/points/batch.h"
#include "function/internal/internal.h"
#include "function/internal/internal_shapes.h"
#include "function/machine.h"
#include "function/points/outer.h"
#include "numbers/functions/lane_functions.h"

#include <algorithm>
#include <cmath>

namespace function {

/// Eight numbers. Every lane has the bits of the scalar result.
struct alignas(64) Eight {
    double v[kLanes];
};

namespace {

template <class F>
Eight batchwise(const Eight& a, const Eight& b, F&& f)
{
    Eight out;
    for (std::size_t i = 0; i < kLanes; i += kWidth)
        f(Batch::load_aligned(a.v + i), Batch::load_aligned(b.v + i)).store_aligned(out.v + i);
    return out;
}
template <class F>
Eight lanewise(F&& f)
{
    Eight out;
    for (std::size_t i = 0; i < kLanes; ++i) out.v[i] = f(i);
    return out;
}
template <class Bool>
Batch truth(const Bool& b)
{
    return xsimd::select(b, Batch(1.0), Batch(0.0));
}

Eight modulo(const Eight& a, const Eight& b)
{
#ifdef __FMA__
    Eight out;
    unsigned good = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {  // the compiler makes vectors of it
        bool known;
        out.v[i] = numbers::fused_remainder(a.v[i], b.v[i], known);
        good += known ? 1u : 0u;
    }
    if (good == kLanes) return out;
#endif
    return lanewise([&](std::size_t i) { return numbers::fmod(a.v[i], b.v[i]); });
}

}  // namespace

template <>
struct Rules<Eight> {
    static Eight constant(double c)
    {
        Eight out;
        for (std::size_t i = 0; i < kLanes; i += kWidth) Batch(c).store_aligned(out.v + i);
        return out;
    }

    template <Op op>
    static Eight binary(const Eight& a, const Eight& b)
    {
        if constexpr (op == Op::Add) return batchwise(a, b, [](Batch x, Batch y) { return x + y; });
        else if constexpr (op == Op::Subtract) return batchwise(a, b, [](Batch x, Batch y) { return x - y; });
        else if constexpr (op == Op::Multiply) return batchwise(a, b, [](Batch x, Batch y) { return x * y; });
        else if constexpr (op == Op::Divide) return batchwise(a, b, [](Batch x, Batch y) { return x / y; });
        else if constexpr (op == Op::Less) return batchwise(a, b, [](Batch x, Batch y) { return truth(x < y); });
        else if constexpr (op == Op::LessEqual) return batchwise(a, b, [](Batch x, Batch y) { return truth(x <= y); });
        else if constexpr (op == Op::Greater)
            return batchwise(a, b, [](Batch x, Batch y) { return Batch(1.0) - truth(x <= y); });
        else if constexpr (op == Op::GreaterEqual)
            return batchwise(a, b, [](Batch x, Batch y) { return Batch(1.0) - truth(x < y); });
        else if constexpr (op == Op::Min)
            return batchwise(a, b, [](Batch x, Batch y) { return xsimd::select(x <= y, x, y); });
        else if constexpr (op == Op::Max)
            return batchwise(a, b, [](Batch x, Batch y) { return xsimd::select(x < y, y, x); });
        else if constexpr (op == Op::Modulo) return modulo(a, b);
        else if constexpr (op == Op::Atan2)
            return batchwise(a, b, [](Batch x, Batch y) { return numbers::atan2(x, y); });
        else if constexpr (op == Op::Power) return batchwise(a, b, [](Batch x, Batch y) { return numbers::pow(x, y); });
        else return lanewise([&](std::size_t i) { return function::binary<op>(a.v[i], b.v[i]); });
    }

    template <Op op>
    static Eight unary(const Eight& a)
    {
        if constexpr (op == Op::Sqrt) return batchwise(a, a, [](Batch x, Batch) { return xsimd::sqrt(x); });
        if constexpr (op == Op::Abs) return batchwise(a, a, [](Batch x, Batch) { return xsimd::abs(x); });
#define ASK(name, function)                                                                                            \
    if constexpr (op == Op::name) return batchwise(a, a, [](Batch x, Batch) { return numbers::function(x); });
        OPERATORS_OF_NUMBERS(ASK)
#undef ASK
        return lanewise([&](std::size_t i) { return function::unary<op>(a.v[i]); });
    }

    /// Runs the branches that some lane takes.
    static void select(Machine<Eight>& m, const Branching& b, std::uint32_t dst)
    {
        const Eight c = m.reg(b.condition);
        std::size_t choice[kLanes];
        for (std::size_t i = 0; i < kLanes; ++i) choice[i] = c.v[i] < 0.0 ? 0 : b.count == 2 || c.v[i] == 0.0 ? 1 : 2;
        Eight all{};
        for (std::size_t k = 0; k < b.count; ++k) {
            bool some = false;
            for (const std::size_t taken : choice) some = some || taken == k;
            if (!some) continue;
            m.run(b.begin[k], b.end[k]);
            const Eight& value = m.reg(b.result[k]);
            for (std::size_t i = 0; i < kLanes; ++i) all.v[i] = choice[i] == k ? value.v[i] : all.v[i];
        }
        m.reg(dst) = all;
    }

    /// Runs until the last lane is through.
    static void loop(Machine<Eight>& m, const Loop& l, std::uint32_t dst)
    {
        const Eight to = m.reg(l.to);
        Eight counter = m.reg(l.from), all = constant(l.product ? 1.0 : 0.0);
        for (;;) {
            bool active[kLanes], some = false;
            for (std::size_t i = 0; i < kLanes; ++i) some = (active[i] = counter.v[i] <= to.v[i]) || some;
            if (!some) break;
            m.reg(l.counter) = counter;
            m.run(l.begin, l.end);
            const Eight& value = m.reg(l.result);
            for (std::size_t i = 0; i < kLanes; ++i) {
                if (!active[i]) continue;
                all.v[i] = l.product ? all.v[i] * value.v[i] : all.v[i] + value.v[i];
                const double next = counter.v[i] + 1.0;
                counter.v[i] = next == counter.v[i] ? kEnded : next;
            }
        }
        m.reg(dst) = all;
    }

    static Eight internal(std::uint32_t n, std::uint32_t count, const Eight* a, const Host& host, const double* weights)
    {
        if (n == kNoise || (n == kNoiseOfGenerator && same(a[3]))) {
            Eight out;
            host.noises(a[0].v, a[1].v, a[2].v, n == kNoise ? 0 : generator(a[3].v[0]), out.v);
            return out;
        }
        // Weights are known where the parameters before the offset are constants.
        if (n == kRoundedBox) return rounded_box(a);
        if (n == kRidgedMultifractal && weights != nullptr && same(a[8])) return ridged(a, host, weights);
        if (n == kHeteroMultifractal && same(a[3]) && same(a[4]) && same(a[5]) && same(a[7]) && same(a[8]))
            return hetero(a, host);
        return lanewise([&](std::size_t lane) {
            double one[kMostParameters];
            for (std::uint32_t i = 0; i < count; ++i) one[i] = a[i].v[lane];
            return function::internal(n, one, host, weights);
        });
    }

    static void outer(const SceneReference& what, const Eight* a, const Host& host, Eight* out)
    {
        if (const auto* use = std::get_if<SceneUse>(&what)) {
            const std::array<double*, 5> to{out[0].v, out[1].v, out[2].v, out[3].v, out[4].v};
            if (use->kind == SceneUse::Kind::Pigment)
                return host.pigments(use->slot, a[0].v, a[1].v, a[2].v, kLanes, to);
            host.patterns(use->slot, a[0].v, a[1].v, a[2].v, kLanes, out[0].v);
            for (std::size_t k = 1; k < to.size(); ++k) out[k] = constant(0.0);
            return;
        }
        const std::size_t count = std::holds_alternative<std::shared_ptr<const Spline>>(what) ? 1 : 3;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            double one[3] = {};
            for (std::size_t i = 0; i < count; ++i) one[i] = a[i].v[lane];
            const Values v = outer_value(what, one, host);
            for (std::size_t k = 0; k < v.size(); ++k) out[k].v[lane] = v[k];
        }
    }

private:
    static bool same(const Eight& a)
    {
        return std::all_of(a.v + 1, a.v + kLanes, [&](double v) { return v == a.v[0]; });
    }

    /// rounded_box() of eight points: the same operations.
    static Eight rounded_box(const Eight* a)
    {
        Eight out;
        for (std::size_t i = 0; i < kLanes; i += kWidth) {
            const auto get = [&](std::size_t k) { return Batch::load_aligned(a[k].v + i); };
            const auto beyond = [&](std::size_t k) {
                const Batch v = xsimd::abs(get(k)) - (get(4 + k) - get(3));
                return xsimd::select(Batch(0.0) < v, v, Batch(0.0));
            };
            const Batch x = beyond(0), y = beyond(1), z = beyond(2);
            (xsimd::sqrt(x * x + y * y + z * z) - get(3) - Batch(1e-6)).store_aligned(out.v + i);
        }
        return out;
    }

    /// ridged_mf() of eight points: the same operations.
    static Eight ridged(const Eight* a, const Host& host, const double* weights)
    {
        const int kind = generator(a[8].v[0]);
        const double octaves = std::min(a[5].v[0], kMostOctaves), lacunarity = a[4].v[0];
        Eight p[3] = {a[0], a[1], a[2]}, noise, signal, sum;
        const auto ask = [&] { host.noises(p[0].v, p[1].v, p[2].v, kind, noise.v); };
        const auto crest = [&](std::size_t i) {
            const double v = a[6].v[i] - std::abs(2.0 * noise.v[i] - 1.0);
            return v * v;
        };
        ask();
        for (std::size_t i = 0; i < kLanes; ++i) signal.v[i] = sum.v[i] = crest(i);
        for (double octave = 1.0; octave < octaves; octave += 1.0) {
            for (Eight& c : p)
                for (double& v : c.v) v *= lacunarity;
            ask();
            const double weight = *weights++;
            for (std::size_t i = 0; i < kLanes; ++i) {
                signal.v[i] = std::clamp(signal.v[i] * a[7].v[i], 0.0, 1.0) * crest(i);
                sum.v[i] += signal.v[i] * weight;
            }
        }
        return sum;
    }

    /// hetero_mf() of eight points: the same operations.
    static Eight hetero(const Eight* a, const Host& host)
    {
        const int kind = generator(a[8].v[0]);
        const double lacunarity = a[4].v[0], decay = numbers::pow(lacunarity, -a[3].v[0]),
                     octaves = std::min(a[5].v[0], kMostOctaves), power = std::max(0.0, std::trunc(a[7].v[0]));
        Eight p[3] = {a[0], a[1], a[2]}, noise, sum;
        const auto ask = [&] { host.noises(p[0].v, p[1].v, p[2].v, kind, noise.v); };
        const auto move = [&] {
            for (Eight& c : p)
                for (double& v : c.v) v *= lacunarity;
        };
        const auto value = [&](std::size_t i) { return 2.0 * noise.v[i] - 1.0 + a[6].v[i]; };
        ask();
        for (std::size_t i = 0; i < kLanes; ++i) sum.v[i] = value(i);
        double weight = decay;
        move();
        for (double octave = 1.0; octave < octaves; octave += 1.0) {
            ask();
            for (std::size_t i = 0; i < kLanes; ++i) sum.v[i] += value(i) * weight * hetero_gain(sum.v[i], power);
            move();
            weight *= decay;
        }
        const double rest = octaves - std::floor(octaves);
        if (rest == 0.0) return sum;
        ask();
        for (std::size_t i = 0; i < kLanes; ++i) sum.v[i] += rest * (value(i) * weight) * sum.v[i];
        return sum;
    }

    static constexpr double kEnded = std::numeric_limits<double>::quiet_NaN();  // no counter: nothing is <= it
    static constexpr std::size_t kMostParameters = 16;
};

namespace {

/// The pattern or pigment of the function's own first parameters that it is and nothing else, as drawn pictures mostly
/// are; null for any other.
const SceneUse* lone_use(const Function& f)
{
    if (f.code.size() != 1 || f.code[0].op != Op::SceneReference) return nullptr;
    const Instruction& in = f.code[0];
    for (std::uint32_t i = 0; i < in.b; ++i)
        if (f.arguments[in.a + i] != f.first_parameter() + i) return nullptr;
    return f.result >= in.dst ? std::get_if<SceneUse>(&f.outer[in.c]) : nullptr;
}

}  // namespace

void evaluate_lanes(const Function& function, const double* const* arguments, std::size_t count, const Host& host,
                    std::uint32_t components, double* const* out)
{
    if (const SceneUse* use = lone_use(function)) {
        alignas(64) double all[std::tuple_size_v<Values>][kMostTogether];
        if (use->kind == SceneUse::Kind::Pigment)
            host.pigments(use->slot, arguments[0], arguments[1], arguments[2], count,
                          {all[0], all[1], all[2], all[3], all[4]});
        else host.patterns(use->slot, arguments[0], arguments[1], arguments[2], count, all[0]);
        const std::uint32_t first = function.result - function.code[0].dst;
        for (std::uint32_t k = 0; k < components; ++k) std::copy_n(all[first + k], count, out[k]);
        return;
    }
    Frame<Eight> frame(function);
    Eight* r = frame.registers();
    for (std::size_t at = 0; at < count; at += kLanes) {
        for (std::uint32_t i = 0; i < function.parameters; ++i)
            std::copy_n(arguments[i] + at, kLanes, r[function.first_parameter() + i].v);
        Machine<Eight>(function, r, host).run(0, static_cast<std::uint32_t>(function.code.size()));
        for (std::uint32_t k = 0; k < components; ++k) std::copy_n(r[function.result + k].v, kLanes, out[k] + at);
    }
}

}  // namespace function
