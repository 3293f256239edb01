#pragma once

#include "function/program.h"
#include "numbers/functions/functions.h"
#include "numbers/remainder.h"

#include <cmath>
#include <limits>

/// The operators and built-in functions on one number: the meaning that all ways of evaluation share. Nothing is
/// checked: 1/0 is infinite, ln(-1) no number (spec 5b, 15.4).
namespace function {

inline constexpr double kDegree = 0.01745329251994329576;

/// Truncation through 32 bits: what does not fit becomes the least number, and no zero has a sign.
inline double truncated(double v)
{
    return v > -2147483649.0 && v < 2147483648.0 ? std::trunc(v) + 0.0 : -2147483648.0;
}

/// Operators that numbers/functions has for one number and for lanes.
#define OPERATORS_OF_NUMBERS(ASK)                                                                                      \
    ASK(Acos, acos)                                                                                                    \
    ASK(Acosh, acosh)                                                                                                  \
    ASK(Asin, asin)                                                                                                    \
    ASK(Asinh, asinh)                                                                                                  \
    ASK(Atan, atan)                                                                                                    \
    ASK(Atanh, atanh)                                                                                                  \
    ASK(Cos, cos)                                                                                                      \
    ASK(Cosh, cosh)                                                                                                    \
    ASK(Exp, exp)                                                                                                      \
    ASK(Ln, log)                                                                                                       \
    ASK(Log, log10)                                                                                                    \
    ASK(Sin, sin)                                                                                                      \
    ASK(Sinh, sinh)                                                                                                    \
    ASK(Tan, tan)                                                                                                      \
    ASK(Tanh, tanh)

template <Op op>
inline double binary(double a, double b)
{
    if constexpr (op == Op::Add) return a + b;
    if constexpr (op == Op::Subtract) return a - b;
    if constexpr (op == Op::Multiply) return a * b;
    if constexpr (op == Op::Divide) return a / b;
    // No number on either side: >, >= and != hold.
    if constexpr (op == Op::Less) return a < b ? 1.0 : 0.0;
    if constexpr (op == Op::LessEqual) return a <= b ? 1.0 : 0.0;
    if constexpr (op == Op::Greater) return a <= b ? 0.0 : 1.0;
    if constexpr (op == Op::GreaterEqual) return a < b ? 0.0 : 1.0;
    if constexpr (op == Op::Equal) return a == b ? 1.0 : 0.0;
    if constexpr (op == Op::NotEqual) return a == b ? 0.0 : 1.0;
    if constexpr (op == Op::And) return a != 0.0 && b != 0.0 ? 1.0 : 0.0;
    if constexpr (op == Op::Or) return a != 0.0 || b != 0.0 ? 1.0 : 0.0;
    if constexpr (op == Op::Min) return a <= b ? a : b;
    if constexpr (op == Op::Max) return a < b ? b : a;
    if constexpr (op == Op::Atan2) return numbers::atan2(a, b);
    if constexpr (op == Op::IntDivide) return truncated(a / b);
    if constexpr (op == Op::Modulo) return numbers::fmod(a, b);
    if constexpr (op == Op::Power) return numbers::pow(a, b);
    return 0.0;
}

template <Op op>
inline double unary(double a)
{
#define ASK(name, function)                                                                                            \
    if constexpr (op == Op::name) return numbers::function(a);
    OPERATORS_OF_NUMBERS(ASK)
#undef ASK
    if constexpr (op == Op::Negate) return -a;
    if constexpr (op == Op::Abs) return std::abs(a);
    if constexpr (op == Op::Ceil) return std::ceil(a);
    if constexpr (op == Op::Degrees) return a / kDegree;
    if constexpr (op == Op::Floor) return std::floor(a);
    if constexpr (op == Op::Int) return truncated(a);
    if constexpr (op == Op::Radians) return a * kDegree;
    if constexpr (op == Op::Sqrt) return std::sqrt(a);
    return 0.0;
}

/// Calls f.operator()<op>() for an operator known at run time.
template <class F>
decltype(auto) with_binary(Op op, F&& f)
{
    switch (op) {
#define CASE(name)                                                                                                     \
    case Op::name: return f.template operator()<Op::name>()
        CASE(Subtract);
        CASE(Multiply);
        CASE(Divide);
        CASE(Less);
        CASE(LessEqual);
        CASE(Greater);
        CASE(GreaterEqual);
        CASE(Equal);
        CASE(NotEqual);
        CASE(And);
        CASE(Or);
        CASE(Min);
        CASE(Max);
        CASE(Atan2);
        CASE(IntDivide);
        CASE(Modulo);
        CASE(Power);
    default: return f.template operator()<Op::Add>();
    }
}
template <class F>
decltype(auto) with_unary(Op op, F&& f)
{
    switch (op) {
        CASE(Abs);
        CASE(Acos);
        CASE(Acosh);
        CASE(Asin);
        CASE(Asinh);
        CASE(Atan);
        CASE(Atanh);
        CASE(Ceil);
        CASE(Cos);
        CASE(Cosh);
        CASE(Degrees);
        CASE(Exp);
        CASE(Floor);
        CASE(Int);
        CASE(Ln);
        CASE(Log);
        CASE(Radians);
        CASE(Sin);
        CASE(Sinh);
        CASE(Sqrt);
        CASE(Tan);
        CASE(Tanh);
#undef CASE
    default: return f.template operator()<Op::Negate>();
    }
}

inline double apply(Op op, double a, double b)
{
    return with_binary(op, [&]<Op o>() { return binary<o>(a, b); });
}
inline double apply(Op op, double a)
{
    return with_unary(op, [&]<Op o>() { return unary<o>(a); });
}

}  // namespace function
