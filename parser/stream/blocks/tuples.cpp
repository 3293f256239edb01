#include "parser/stream/blocks/machine.h"
#include "parser/stream/blocks/operations.h"
#include "parser/stream/hooks.h"

/// Vectors and colours, and what is borrowed from the operations of single expressions.
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

const Op* add_tuple(const Op* op, Machine& m)
{
    for (std::uint32_t i = 0; i < op->b; ++i) m.registers[op->to + i] += m.registers[op->a + i];
    return op + 1;
}

const Op* subtract_tuple(const Op* op, Machine& m)
{
    for (std::uint32_t i = 0; i < op->b; ++i) m.registers[op->to + i] -= m.registers[op->a + i];
    return op + 1;
}

const Op* scale_tuple(const Op* op, Machine& m)
{
    const double factor = m.registers[op->a];
    for (std::uint32_t i = 0; i < op->b; ++i) m.registers[op->to + i] *= factor;
    return op + 1;
}

const Op* multiply_tuple(const Op* op, Machine& m)
{
    for (std::uint32_t i = 0; i < op->b; ++i) m.registers[op->to + i] *= m.registers[op->to + op->b + i];
    return op + 1;
}

const Op* splat(const Op* op, Machine& m)
{
    const double value = m.registers[op->to];
    for (std::uint32_t i = 1; i < op->b; ++i) m.registers[op->to + i] = value;
    return op + 1;
}

const Op* scaled_tuple(const Op* op, Machine& m)
{
    const double factor = m.registers[op->to];
    for (std::uint32_t i = 0; i < op->b; ++i) m.registers[op->to + i] = factor * m.registers[op->to + 1 + i];
    return op + 1;
}

const Op* divide_tuple(const Op* op, Machine& m)
{
    const double divisor = m.registers[op->a];
    if (divisor == 0.0) return m.leave(op);
    for (std::uint32_t i = 0; i < op->b; ++i) m.registers[op->to + i] /= divisor;
    return op + 1;
}

glm::dvec3 at3(const double* v) { return {v[0], v[1], v[2]}; }

/// The normal is stored before the statement is done: it is noted, as what comes behind may leave the statement.
const Op* trace(const Op* op, Machine& m)
{
    if (!m.slots[op->b].numbers && !m.missing(op, op->b)) return nullptr;
    const Value* const value = m.symbols.find(op->a);
    const auto* const asked = value ? value->get_if<std::shared_ptr<const scene::Object>>() : nullptr;
    if (!asked || !(*asked)->drawn()) return m.leave(op);
    double* const at = m.registers + op->to;
    const auto answer = m.context.hooks.trace(*asked, at3(at), glm::normalize(at3(at + 3)));
    if (!answer) return m.leave(op);
    m.note(op->b);
    const glm::dvec3 point = answer->hit ? answer->point : glm::dvec3(0.0);
    const glm::dvec3 normal = answer->hit ? answer->normal : glm::dvec3(0.0);
    double* const to = m.slots[op->b].numbers;
    for (int i = 0; i < 3; ++i) {
        at[i] = point[i];
        to[i] = normal[i];
    }
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

const Op* borrowed(const Op* op, Machine& m)
{
    const CompiledExpression& expression = m.program->expressions[op->a];
    return run_operation(expression, expression.ops[op->b], m.context, m.registers + op->to) ? op + 1 : m.leave(op);
}

}  // namespace

const Handler kLoadTuple = load_tuple;
const Handler kLoadComponent = load_component;
const Handler kStoreTuple = store_tuple;
const Handler kAddTuple = add_tuple;
const Handler kSubtractTuple = subtract_tuple;
const Handler kScaleTuple = scale_tuple;
const Handler kMultiplyTuple = multiply_tuple;
const Handler kSplat = splat;
const Handler kScaledTuple = scaled_tuple;
const Handler kDivideTuple = divide_tuple;
const Handler kLength = vector_length;
const Handler kDot = vector_dot;
const Handler kTrace = trace;
const Handler kBorrowed = borrowed;

}  // namespace parser::blocks
