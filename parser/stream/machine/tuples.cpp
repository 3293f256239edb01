#include "function/points/evaluate.h"
#include "function/spline.h"
#include "parser/stream/machine/machine.h"
#include "parser/stream/machine/operations.h"
#include "parser/stream/expressions/number_functions.h"
#include "parser/stream/hooks.h"
#include "render/scene/last_bits.h"

/// Vectors and colours, choices, and what asks objects, functions and splines.
namespace parser::blocks {
namespace {

const Op* load_tuple(const Op* op, Machine& m)
{
    const double* const from = m.slots[op->a].numbers;
    if (!from) return m.missing(op, op->a);
    double* const to = m.registers + op->to;
    for (std::uint32_t i = 0; i < op->b; ++i) to[i] = from[i];
    return op + 1;
}

const Op* load_component(const Op* op, Machine& m)
{
    const double* const from = m.slots[op->a].numbers;
    if (!from) return m.missing(op, op->a);
    m.registers[op->to] = from[op->b];
    return op + 1;
}

const Op* store_tuple(const Op* op, Machine& m)
{
    const bool local = op->jump != 0;
    double* to = local ? m.slots[op->to].own : m.slots[op->to].numbers;
    if (!to) {
        if (!(to = m.place_to_store(op->to, local, true))) return m.leave(op);
    } else if (!local && m.values != 0) {
        m.note(op->to);
    }
    const double* const from = m.registers + op->a;
    if (op->b == 5)
        for (std::uint32_t i = 0; i < 5; ++i) to[i] = static_cast<float>(from[i]);  // Tuple::stored
    else
        for (std::uint32_t i = 0; i < op->b; ++i) to[i] = from[i];
    return op + 1;
}

const Op* splat(const Op* op, Machine& m)
{
    const double value = m.registers[op->to];
    for (std::uint32_t i = 1; i < op->b; ++i) m.registers[op->to + i] = value;
    return op + 1;
}

glm::dvec3 at3(const double* v) { return {v[0], v[1], v[2]}; }

void put3(double* to, const glm::dvec3& v)
{
    for (int i = 0; i < 3; ++i) to[i] = v[i];
}

/// What a name means; null: another kind of thing.
template <class T>
const T* meant(const Machine& m, std::uint32_t name)
{
    const Value* const value = m.symbols.find(name);
    return value ? value->get_if<T>() : nullptr;
}

/// The normal is stored before the statement is done: it is noted, as what comes behind may leave the statement.
const Op* trace(const Op* op, Machine& m)
{
    const bool stores = op->b != kNoIndex;
    if (stores && !m.slots[op->b].numbers && !m.missing(op, op->b)) return nullptr;
    const auto* const asked = meant<std::shared_ptr<const scene::Object>>(m, op->a);
    if (!asked || (stores && !(*asked)->drawn())) return m.leave(op);
    double* const at = m.registers + op->to;
    const auto answer = m.hooks.trace(*asked, at3(at), at3(at + 3));
    if (!answer) return m.leave(op);
    put3(at, answer->hit ? answer->point : glm::dvec3(0.0));
    if (stores) {
        m.note(op->b);
        put3(m.slots[op->b].numbers, answer->hit ? answer->normal : glm::dvec3(0.0));
    }
    return op + 1;
}

const Op* inside(const Op* op, Machine& m)
{
    const auto* const asked = meant<std::shared_ptr<const scene::Object>>(m, op->a);
    double* const at = m.registers + op->to;
    const auto answer = asked ? m.hooks.inside(*asked, at3(at)) : std::nullopt;
    if (!answer) return m.leave(op);
    at[0] = *answer ? 1.0 : 0.0;
    return op + 1;
}

const Op* call_function(const Op* op, Machine& m)
{
    const auto* const held = meant<function::FunctionPtr>(m, op->a);
    const function::FunctionPtr& expected = m.program->functions[op->b];
    if (!held || *held != expected) return m.leave(op);
    double* const at = m.registers + op->to;
    if (expected->components == 1) {
        at[0] = function::evaluate(*expected, at, function::no_host());
        return op + 1;
    }
    const function::Values values = function::evaluate_all(*expected, at, function::no_host());
    for (std::size_t i = 0; i < expected->components; ++i) at[i] = values[i];
    return op + 1;
}

const Op* curve(const Op* op, Machine& m)
{
    const auto* const held = meant<std::shared_ptr<const function::Spline>>(m, op->a);
    if (!held || (*held)->components() != op->b) return m.leave(op);
    double* const at = m.registers + op->to;
    const auto kind = op->jump < 0 ? (*held)->kind : static_cast<function::Spline::Kind>(op->jump);
    const auto values = (*held)->at(at[0], kind);
    for (std::size_t i = 0; i < op->b; ++i) at[i] = values[i];
    return op + 1;
}

const Op* select(const Op* op, Machine& m)
{
    m.registers[op->to] = m.registers[op->to + op->b];
    return op + 1;
}

const Op* gray(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    at[0] = 0.297 * at[0] + 0.589 * at[1] + 0.114 * at[2];
    return op + 1;
}

const Op* negate(const Op* op, Machine& m)
{
    for (std::uint32_t i = 0; i < op->b; ++i) m.registers[op->to + i] = -m.registers[op->to + i];
    return op + 1;
}

const Op* negate_truth(const Op* op, Machine& m)
{
    for (std::uint32_t i = 0; i < op->b; ++i) m.registers[op->to + i] = truth(m.registers[op->to + i]) ? 0.0 : 1.0;
    return op + 1;
}

const Op* choose_if(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    at[0] = truth(at[0]) ? at[1] : at[2];
    return op + 1;
}

const Op* choose_by_sign(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    at[0] = at[0] < 0.0 ? at[1] : op->b == 0 || at[0] == 0.0 ? at[2] : at[3];
    return op + 1;
}

const Op* cross(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    put3(at, glm::cross(at3(at), at3(at + 3)));
    return op + 1;
}

const Op* rotate(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    put3(at, rotated(at3(at), at3(at + 3)));
    return op + 1;
}

const Op* normalize(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    if (!(glm::length(at3(at)) != 0.0)) return m.leave(op);
    put3(at, scene::unit(at3(at), m.program->povray));
    return op + 1;
}

const Op* vector_length(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    at[0] = glm::length(at3(at));
    return op + 1;
}

const Op* vector_dot(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    at[0] = glm::dot(at3(at), at3(at + 3));
    return op + 1;
}

}  // namespace

const Handler kLoadTuple = load_tuple;
const Handler kLoadComponent = load_component;
const Handler kStoreTuple = store_tuple;
const Handler kSplat = splat;
const Handler kLength = vector_length;
const Handler kDot = vector_dot;
const Handler kTrace = trace;
const Handler kInside = inside;
const Handler kCallFunction = call_function;
const Handler kCurve = curve;
const Handler kSelect = select;
const Handler kGray = gray;
const Handler kNegateTuple = negate;
const Handler kNot = negate_truth;
const Handler kChooseIf = choose_if;
const Handler kChooseBySign = choose_by_sign;
const Handler kCross = cross;
const Handler kRotate = rotate;
const Handler kNormalize = normalize;

}  // namespace parser::blocks
