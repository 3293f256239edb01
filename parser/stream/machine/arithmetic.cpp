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

// Tables of the handlers, by what makes one: the last of it varies most quickly.
constexpr std::size_t kBinaries = 18, kRelations = 6, kPlaces = 3;

template <std::size_t... i>
constexpr std::array<Handler, sizeof...(i)> binaries(std::index_sequence<i...>)
{
    constexpr auto f = [](std::size_t at) { return static_cast<Binary>(at / 27); };
    constexpr auto to = [=](std::size_t at) { return is_sum(f(at)) ? static_cast<Target>(at % 3) : Target::Register; };
    return {run_binary<f(i), static_cast<Operand>(i / 9 % 3), static_cast<Operand>(i / 3 % 3), to(i)>...};
}

template <std::size_t... i>
constexpr std::array<Handler, sizeof...(i)> relation_jumps(std::index_sequence<i...>)
{
    constexpr std::size_t kFirst = static_cast<std::size_t>(Binary::Less);
    return {run_relation_jump<static_cast<Binary>(kFirst + i / 18), static_cast<Operand>(i / 6 % 3),
                              static_cast<Operand>(i / 2 % 3), i % 2 != 0>...};
}

template <std::size_t... i>
constexpr std::array<Handler, sizeof...(i)> truth_jumps(std::index_sequence<i...>)
{
    return {run_truth_jump<static_cast<Operand>(i / 2), i % 2 != 0>...};
}

template <std::size_t... i>
constexpr std::array<Handler, sizeof...(i)> moves(std::index_sequence<i...>)
{
    return {run_move<static_cast<Operand>(i / 3), static_cast<Target>(i % 3)>...};
}

constexpr std::array kFunctions = {
    Kind::Abs,  Kind::Acos,    Kind::Asin,    Kind::Atan, Kind::Cosh,  Kind::Sinh,  Kind::Tanh,
    Kind::Ceil, Kind::Cos,     Kind::Degrees, Kind::Exp,  Kind::Floor, Kind::Int,   Kind::Ln,
    Kind::Log,  Kind::Radians, Kind::Sin,     Kind::Sqrt, Kind::Tan,   Kind::Minus, Kind::Rand,
};

template <std::size_t... i>
constexpr std::array<Handler, sizeof...(i)> functions(std::index_sequence<i...>)
{
    return {run_function<kFunctions[i / 3], static_cast<Operand>(i % 3)>...};
}

constexpr std::size_t at(Operand o) { return static_cast<std::size_t>(o); }

}  // namespace

Handler binary_handler(Binary f, Operand a, Operand b, Target to)
{
    static constexpr auto kAll = binaries(std::make_index_sequence<kBinaries * kPlaces * kPlaces * kPlaces>());
    return kAll[27 * static_cast<std::size_t>(f) + 9 * at(a) + 3 * at(b) + static_cast<std::size_t>(to)];
}

Handler relation_jump_handler(Binary f, Operand a, Operand b, bool sense)
{
    static constexpr auto kAll = relation_jumps(std::make_index_sequence<kRelations * kPlaces * kPlaces * 2>());
    const std::size_t which = static_cast<std::size_t>(f) - static_cast<std::size_t>(Binary::Less);
    return kAll[18 * which + 6 * at(a) + 2 * at(b) + (sense ? 1 : 0)];
}

Handler truth_jump_handler(Operand a, bool sense)
{
    static constexpr auto kAll = truth_jumps(std::make_index_sequence<kPlaces * 2>());
    return kAll[2 * at(a) + (sense ? 1 : 0)];
}

Handler move_handler(Operand a, Target to)
{
    static constexpr auto kAll = moves(std::make_index_sequence<kPlaces * kPlaces>());
    return kAll[3 * at(a) + static_cast<std::size_t>(to)];
}

Handler function_handler(Kind f, Operand a)
{
    static constexpr auto kAll = functions(std::make_index_sequence<kFunctions.size() * kPlaces>());
    const auto found = std::find(kFunctions.begin(), kFunctions.end(), f);
    return found == kFunctions.end() ? nullptr : kAll[3 * static_cast<std::size_t>(found - kFunctions.begin()) + at(a)];
}

Handler combine_handler(Binary f)
{
    static constexpr std::array<Handler, 4> kAll = {combine<Binary::Add>, combine<Binary::Subtract>,
                                                    combine<Binary::Multiply>, combine<Binary::Divide>};
    return kAll[static_cast<std::size_t>(f)];
}

}  // namespace parser::blocks
