#include "function/internal/internal.h"
#include "function/lone_internal.h"
#include "function/machine.h"
#include "function/points/evaluate.h"
#include "function/points/outer.h"

namespace function {

template <>
struct Rules<double> {
    static double constant(double v) { return v; }
    template <Op op>
    static double binary(double a, double b)
    {
        return function::binary<op>(a, b);
    }
    template <Op op>
    static double unary(double a)
    {
        return function::unary<op>(a);
    }

    static void select(Machine<double>& m, const Branching& b, std::uint32_t dst)
    {
        const double c = m.reg(b.condition);
        const std::size_t k = c < 0.0 ? 0 : b.count == 2 || c == 0.0 ? 1 : 2;
        m.run(b.begin[k], b.end[k]);
        m.reg(dst) = m.reg(b.result[k]);
    }

    static void loop(Machine<double>& m, const Loop& l, std::uint32_t dst)
    {
        const double to = m.reg(l.to);
        double all = l.product ? 1.0 : 0.0;
        for (double i = m.reg(l.from); i <= to; i += 1.0) {
            m.reg(l.counter) = i;
            m.run(l.begin, l.end);
            all = l.product ? all * m.reg(l.result) : all + m.reg(l.result);
            if (i + 1.0 == i) break;  // the counter has grown beyond what 1 changes
        }
        m.reg(dst) = all;
    }

    static double internal(std::uint32_t n, std::uint32_t, const double* a, const Host& host, const double* weights)
    {
        return function::internal(n, a, host, weights);
    }

    static void outer(const SceneReference& what, const double* a, const Host& host, double* out)
    {
        const Values v = outer_value(what, a, host);
        for (std::size_t k = 0; k < v.size(); ++k) out[k] = v[k];
    }
};

double evaluate(const Function& function, const double* arguments, const Host& host)
{
    if (const LoneInternal call(function); call) {
        double a[LoneInternal::kMostArguments];
        const std::uint32_t count = call.count();
        for (std::uint32_t i = 0; i < count; ++i)
            a[i] = call.argument<double>(i, [&](std::uint32_t which) { return arguments[which]; });
        return internal(call.number(), a, host, call.weights());
    }
    return run_function<double>(function, arguments, host);
}

Values evaluate_all(const Function& f, const double* arguments, const Host& host)
{
    Frame<double> frame(f);
    double* r = frame.registers();
    for (std::uint32_t i = 0; i < f.parameters; ++i) r[f.first_parameter() + i] = arguments[i];
    Machine<double>(f, r, host).run(0, static_cast<std::uint32_t>(f.code.size()));
    Values out{};
    for (std::uint32_t k = 0; k < f.components; ++k) out[k] = r[f.result + k];
    return out;
}

namespace {

struct NoHost final : Host {
    double noise(const glm::dvec3&, int) const override { return 0.0; }
    double pattern(std::uint32_t, const glm::dvec3&) const override { return 0.0; }
    std::array<double, 5> pigment(std::uint32_t, const glm::dvec3&) const override { return {}; }
};

}  // namespace

const Host& no_host()
{
    static const NoHost host;
    return host;
}

}  // namespace function
