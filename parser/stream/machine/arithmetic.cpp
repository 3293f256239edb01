#include "parser/stream/machine/operands.h"
#include "parser/stream/expressions/number_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

/// Numbers: one handler for each function and each place of its operands.
namespace parser::blocks {
namespace {

/// a = a f b; false: the reader of tokens has something to say.
template <Binary f>
bool apply(double& a, double b)
{
    if constexpr (f == Binary::Add) a = a + b;
    if constexpr (f == Binary::Subtract) a = a - b;
    if constexpr (f == Binary::Multiply) a = a * b;
    if constexpr (f == Binary::Divide) {
        if (b == 0.0) return false;
        a = a / b;
    }
    if constexpr (f == Binary::Less) a = relation_holds(Kind::Less, a, b) ? 1.0 : 0.0;
    if constexpr (f == Binary::And) a = truth(a) && truth(b) ? 1.0 : 0.0;
    if constexpr (f == Binary::Or) a = truth(a) || truth(b) ? 1.0 : 0.0;
    if constexpr (f == Binary::Min) a = b < a ? b : a;
    if constexpr (f == Binary::Max) a = a < b ? b : a;
    if constexpr (f == Binary::Modulo) return function_of_two(Kind::Mod, a, b);
    if constexpr (f == Binary::Power) return function_of_two(Kind::Pow, a, b);
    if constexpr (f == Binary::IntDivide) return function_of_two(Kind::Div, a, b);
    if constexpr (f == Binary::Atan2) return function_of_two(Kind::Atan2, a, b);
    return true;
}

/// relation_holds() of a relation known in advance.
template <Binary f>
bool holds(double a, double b)
{
    if constexpr (f == Binary::Less) return a < b;
    if constexpr (f == Binary::Greater) return a > b;
    if constexpr (f == Binary::LessEqual) return a <= b || !(std::abs(a - b) > kSame);
    if constexpr (f == Binary::GreaterEqual) return a >= b || !(std::abs(a - b) > kSame);
    if constexpr (f == Binary::Equal) return !(std::abs(a - b) > kSame);
    if constexpr (f == Binary::NotEqual) return std::abs(a - b) > kSame;
    return false;
}

template <Target where>
double* target(const Op* op, Machine& m)
{
    if constexpr (where == Target::Register) return m.registers + op->to;
    double* const known = where == Target::Declared ? m.slots[op->to].numbers : m.slots[op->to].own;
    if (where == Target::Declared && m.values != 0 && known) m.note(op->to);
    return known ? known : m.place_to_store(op->to, where == Target::Local, true);
}

template <Binary f, Operand A, Operand B, Target to>
const Op* run_binary(const Op* op, Machine& m)
{
    const double* const a = fetch<A>(op, op->a, m);
    if (A == Operand::Slot && !a) return m.missing(op, op->a);
    const double* const b = fetch<B>(op, op->b, m);
    if (B == Operand::Slot && !b) return m.missing(op, op->b);
    double value = *a;
    if constexpr (is_relation(f)) value = holds<f>(value, *b) ? 1.0 : 0.0;
    else if (!apply<f>(value, *b)) return m.leave(op);
    double* const out = target<to>(op, m);
    if (to != Target::Register && !out) return m.leave(op);
    *out = value;
    return op + 1;
}

template <Binary f, Operand A, Operand B, bool sense>
const Op* run_relation_jump(const Op* op, Machine& m)
{
    const double* const a = fetch<A>(op, op->a, m);
    if (A == Operand::Slot && !a) return m.missing(op, op->a);
    const double* const b = fetch<B>(op, op->b, m);
    if (B == Operand::Slot && !b) return m.missing(op, op->b);
    return holds<f>(*a, *b) == sense ? op + op->jump : op + 1;
}

template <Operand A, bool sense>
const Op* run_truth_jump(const Op* op, Machine& m)
{
    const double* const a = fetch<A>(op, op->a, m);
    if (A == Operand::Slot && !a) return m.missing(op, op->a);
    return truth(*a) == sense ? op + op->jump : op + 1;
}

template <Operand A, Target to>
const Op* run_move(const Op* op, Machine& m)
{
    const double* const a = fetch<A>(op, op->a, m);
    if (A == Operand::Slot && !a) return m.missing(op, op->a);
    const double value = *a;
    double* const out = target<to>(op, m);
    if (to != Target::Register && !out) return m.leave(op);
    *out = value;
    return op + 1;
}

template <Kind f, Operand A>
const Op* run_function(const Op* op, Machine& m)
{
    const double* const a = fetch<A>(op, op->a, m);
    if (A == Operand::Slot && !a) return m.missing(op, op->a);
    double value = *a;
    if constexpr (f == Kind::Minus) value = -value;
    else if constexpr (f == Kind::Rand) {
        if (!m.random.draw(value, value)) return m.leave(op);
    } else if (!function_of_one(f, value)) return m.leave(op);
    m.registers[op->to] = value;
    return op + 1;
}

/// A number grows by copies, others by zeros.
template <Binary f>
const Op* combine(const Op* op, Machine& m)
{
    const std::uint32_t a = op->a, b = op->b;
    double* const left = m.registers + op->to;
    const double* const right = left + a;
    if (a == b || b == 1) {
        for (std::uint32_t i = 0; i < a; ++i)
            if (!apply<f>(left[i], right[a == b ? i : 0])) return m.leave(op);
        return op + 1;
    }
    double other[5];
    const std::uint32_t count = std::max(a, b);
    for (std::uint32_t i = 0; i < count; ++i) other[i] = i < b ? right[i] : 0.0;
    for (std::uint32_t i = a; i < count; ++i) left[i] = a == 1 ? left[0] : 0.0;
    for (std::uint32_t i = 0; i < count; ++i)
        if (!apply<f>(left[i], other[i])) return m.leave(op);
    return op + 1;
}

constexpr std::size_t at(Operand o) { return static_cast<std::size_t>(o); }

template <Binary f, Operand A, Operand B>
constexpr std::array<Handler, 3> to_targets()
{
    constexpr bool sum = is_sum(f);
    return {run_binary<f, A, B, Target::Register>,       run_binary < f, A, B,
            sum ? Target::Declared : Target::Register >, run_binary < f, A, B,
            sum ? Target::Local : Target::Register > };
}

template <Binary f, std::size_t... i>
Handler pick_binary(Operand a, Operand b, Target to, std::index_sequence<i...>)
{
    static constexpr std::array<std::array<Handler, 3>, 9> kAll = {
        to_targets<f, static_cast<Operand>(i / 3), static_cast<Operand>(i % 3)>()...};
    return kAll[at(a) * 3 + at(b)][static_cast<std::size_t>(to)];
}

template <Binary f, std::size_t... i>
Handler pick_jump(Operand a, Operand b, bool sense, std::index_sequence<i...>)
{
    static constexpr std::array<std::array<Handler, 2>, 9> kAll = {std::array<Handler, 2>{
        run_relation_jump<f, static_cast<Operand>(i / 3), static_cast<Operand>(i % 3), false>,
        run_relation_jump<f, static_cast<Operand>(i / 3), static_cast<Operand>(i % 3), true>}...};
    return kAll[at(a) * 3 + at(b)][sense ? 1 : 0];
}

template <Kind f>
Handler pick_function(Operand a)
{
    static constexpr std::array<Handler, 3> kAll = {run_function<f, Operand::Register>, run_function<f, Operand::Slot>,
                                                    run_function<f, Operand::Constant>};
    return kAll[at(a)];
}

}  // namespace

Handler binary_handler(Binary f, Operand a, Operand b, Target to)
{
    constexpr auto all = std::make_index_sequence<9>();
    switch (f) {
    case Binary::Add: return pick_binary<Binary::Add>(a, b, to, all);
    case Binary::Subtract: return pick_binary<Binary::Subtract>(a, b, to, all);
    case Binary::Multiply: return pick_binary<Binary::Multiply>(a, b, to, all);
    case Binary::Divide: return pick_binary<Binary::Divide>(a, b, to, all);
    case Binary::Less: return pick_binary<Binary::Less>(a, b, to, all);
    case Binary::LessEqual: return pick_binary<Binary::LessEqual>(a, b, to, all);
    case Binary::Greater: return pick_binary<Binary::Greater>(a, b, to, all);
    case Binary::GreaterEqual: return pick_binary<Binary::GreaterEqual>(a, b, to, all);
    case Binary::Equal: return pick_binary<Binary::Equal>(a, b, to, all);
    case Binary::NotEqual: return pick_binary<Binary::NotEqual>(a, b, to, all);
    case Binary::And: return pick_binary<Binary::And>(a, b, to, all);
    case Binary::Or: return pick_binary<Binary::Or>(a, b, to, all);
    case Binary::Min: return pick_binary<Binary::Min>(a, b, to, all);
    case Binary::Max: return pick_binary<Binary::Max>(a, b, to, all);
    case Binary::Modulo: return pick_binary<Binary::Modulo>(a, b, to, all);
    case Binary::Power: return pick_binary<Binary::Power>(a, b, to, all);
    case Binary::IntDivide: return pick_binary<Binary::IntDivide>(a, b, to, all);
    default: return pick_binary<Binary::Atan2>(a, b, to, all);
    }
}

Handler relation_jump_handler(Binary f, Operand a, Operand b, bool sense)
{
    constexpr auto all = std::make_index_sequence<9>();
    switch (f) {
    case Binary::Less: return pick_jump<Binary::Less>(a, b, sense, all);
    case Binary::LessEqual: return pick_jump<Binary::LessEqual>(a, b, sense, all);
    case Binary::Greater: return pick_jump<Binary::Greater>(a, b, sense, all);
    case Binary::GreaterEqual: return pick_jump<Binary::GreaterEqual>(a, b, sense, all);
    case Binary::Equal: return pick_jump<Binary::Equal>(a, b, sense, all);
    default: return pick_jump<Binary::NotEqual>(a, b, sense, all);
    }
}

Handler truth_jump_handler(Operand a, bool sense)
{
    switch (a) {
    case Operand::Register:
        return sense ? run_truth_jump<Operand::Register, true> : run_truth_jump<Operand::Register, false>;
    case Operand::Slot: return sense ? run_truth_jump<Operand::Slot, true> : run_truth_jump<Operand::Slot, false>;
    default: return sense ? run_truth_jump<Operand::Constant, true> : run_truth_jump<Operand::Constant, false>;
    }
}

Handler move_handler(Operand a, Target to)
{
    constexpr auto row = []<Operand A>() {
        return std::array<Handler, 3>{run_move<A, Target::Register>, run_move<A, Target::Declared>,
                                      run_move<A, Target::Local>};
    };
    static constexpr std::array<std::array<Handler, 3>, 3> kAll = {row.template operator()<Operand::Register>(),
                                                                   row.template operator()<Operand::Slot>(),
                                                                   row.template operator()<Operand::Constant>()};
    return kAll[at(a)][static_cast<std::size_t>(to)];
}

Handler function_handler(Kind f, Operand a)
{
    switch (f) {
    case Kind::Abs: return pick_function<Kind::Abs>(a);
    case Kind::Acos: return pick_function<Kind::Acos>(a);
    case Kind::Asin: return pick_function<Kind::Asin>(a);
    case Kind::Atan: return pick_function<Kind::Atan>(a);
    case Kind::Cosh: return pick_function<Kind::Cosh>(a);
    case Kind::Sinh: return pick_function<Kind::Sinh>(a);
    case Kind::Tanh: return pick_function<Kind::Tanh>(a);
    case Kind::Ceil: return pick_function<Kind::Ceil>(a);
    case Kind::Cos: return pick_function<Kind::Cos>(a);
    case Kind::Degrees: return pick_function<Kind::Degrees>(a);
    case Kind::Exp: return pick_function<Kind::Exp>(a);
    case Kind::Floor: return pick_function<Kind::Floor>(a);
    case Kind::Int: return pick_function<Kind::Int>(a);
    case Kind::Ln: return pick_function<Kind::Ln>(a);
    case Kind::Log: return pick_function<Kind::Log>(a);
    case Kind::Radians: return pick_function<Kind::Radians>(a);
    case Kind::Sin: return pick_function<Kind::Sin>(a);
    case Kind::Sqrt: return pick_function<Kind::Sqrt>(a);
    case Kind::Tan: return pick_function<Kind::Tan>(a);
    case Kind::Minus: return pick_function<Kind::Minus>(a);
    case Kind::Rand: return pick_function<Kind::Rand>(a);
    default: return nullptr;
    }
}

Handler combine_handler(Binary f)
{
    switch (f) {
    case Binary::Add: return combine<Binary::Add>;
    case Binary::Subtract: return combine<Binary::Subtract>;
    case Binary::Multiply: return combine<Binary::Multiply>;
    default: return combine<Binary::Divide>;
    }
}

}  // namespace parser::blocks
