#include "function/field/field.h"

#include "function/points/evaluate.h"
#include "function/internal/internal.h"
#include "function/intervals/interval.h"
#include "function/line/along_line.h"
#include "function/lone_internal.h"

#include <array>

namespace function {
namespace {

constexpr std::size_t kCoordinates = 3;

/// The host outlives every field: there is nothing to free.
std::shared_ptr<const Host> lone_host() { return {std::shared_ptr<const Host>(), &no_host()}; }

Evaluators current{evaluate, evaluate_all, evaluate_lanes, evaluate_intervals, evaluate_along};

void copy(const csg::Eight& from, double* to) { std::copy_n(from.v, kLanes, to); }

/// The box of a function that is f_rounded_box(x, y, z, ...) with constant sizes; nothing for any other.
std::optional<csg::RoundedBox> rounded_box_of(const Function& f)
{
    constexpr std::uint32_t kArguments = 7;
    const LoneInternal call(f);
    if (!call || call.number() != kRoundedBox || call.count() != kArguments) return {};
    std::array<double, kArguments> a{};
    for (std::uint32_t i = 0; i < kArguments; ++i) {
        const std::optional<double> number = call.constant(i);
        if (number.has_value() != (i >= kCoordinates)) return {};
        if (number) a[i] = *number;
        else if (call.argument<std::uint32_t>(i, [](std::uint32_t which) { return which; }) != i) return {};
    }
    return csg::RoundedBox{{a[4] - a[3], a[5] - a[3], a[6] - a[3]}, a[3]};
}

/// Whether the function is a polynomial of a low enough degree along every line. One line that is parallel to no
/// coordinate plane tells: no other has a higher degree.
bool is_polynomial_of_space(const Function& f)
{
    csg::FieldPolynomial found;
    return evaluate_along(f, {glm::dvec3(0.3, -0.2, 0.1), glm::dvec3(1.0, 0.9, 0.8), glm::dvec3(0.0)}, found);
}

}  // namespace

void use(const Evaluators& evaluators) { current = evaluators; }
const Evaluators& in_use() { return current; }

FunctionField::FunctionField(FunctionPtr function, std::shared_ptr<const Host> host, bool negated)
    : function_(std::move(function)), host_(host ? std::move(host) : lone_host()), ranged_(narrows(*function_)),
      polynomial_(ranged_ && is_polynomial_of_space(*function_)), negated_(negated)
{
    if (!negated) rounded_box_ = rounded_box_of(*function_);
}

double FunctionField::value(const glm::dvec3& p) const
{
    const double arguments[kCoordinates] = {p.x, p.y, p.z};
    const double value = current.one(*function_, arguments, *host_);
    return negated_ ? -value : value;
}

void FunctionField::values(const csg::EightPoints& p, csg::Eight& out) const
{
    const double* const arguments[kCoordinates] = {p.x.v, p.y.v, p.z.v};
    double* const values = out.v;
    current.lanes(*function_, arguments, kLanes, *host_, 1, &values);
    if (negated_)
        for (double& v : out.v) v = -v;
}

void FunctionField::ranges(const csg::EightBoxes& boxes, csg::EightRanges& out) const
{
    double low[kCoordinates][kLanes], high[kCoordinates][kLanes];
    const csg::EightRanges* sides[kCoordinates] = {&boxes.x, &boxes.y, &boxes.z};
    for (std::size_t i = 0; i < kCoordinates; ++i) {
        copy(sides[i]->low, low[i]);
        copy(sides[i]->high, high[i]);
    }
    current.intervals(*function_, low, high, *host_, out.low.v, out.high.v);
    for (std::size_t i = 0; negated_ && i < kLanes; ++i) {
        const double lowest = -out.high.v[i];
        out.high.v[i] = -out.low.v[i];
        out.low.v[i] = lowest;
    }
}

bool FunctionField::along(const csg::FieldStretch& stretch, csg::FieldPolynomial& out) const
{
    if (!polynomial_ || !current.along(*function_, stretch, out)) return false;
    for (double& c : out.c) c = negated_ ? -c : c;
    return true;
}

}  // namespace function
