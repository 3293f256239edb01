#pragma once

#include "numbers/functions/functions.h"
#include "numbers/remainder.h"
#include "parser/stream/expressions/operand.h"

#include <cmath>
#include <cstdint>

/// Built-in functions of numbers, for compiled expressions. False: the reader of tokens has something to say.
namespace parser {

inline constexpr double kDegreeInRadians = 0.01745329251994329576;

/// `kind` of one number.
inline bool function_of_one(Kind kind, double& a)
{
    switch (kind) {
    case Kind::Abs: a = std::abs(a); return true;
    case Kind::Acos:
        if (!(a >= -1.0 && a <= 1.0)) return false;
        a = numbers::acos(a);
        return true;
    case Kind::Asin:
        if (!(a >= -1.0 && a <= 1.0)) return false;
        a = numbers::asin(a);
        return true;
    case Kind::Atan: a = numbers::atan(a); return true;
    case Kind::Cosh: a = numbers::cosh(a); return true;
    case Kind::Sinh: a = numbers::sinh(a); return true;
    case Kind::Tanh: a = numbers::tanh(a); return true;
    case Kind::Ceil: a = std::ceil(a); return true;
    case Kind::Cos: a = numbers::cos(a); return true;
    case Kind::Degrees: a = a / kDegreeInRadians; return true;
    case Kind::Exp: a = numbers::exp(a); return true;
    case Kind::Floor: a = std::floor(a); return true;
    case Kind::Int: a = to_int32(a); return true;
    case Kind::Ln:
        if (!(a > 0.0)) return false;
        a = numbers::log(a);
        return true;
    case Kind::Log:
        if (!(a > 0.0)) return false;
        a = numbers::log10(a);
        return true;
    case Kind::Radians: a = a * kDegreeInRadians; return true;
    case Kind::Sin: a = numbers::sin(a); return true;
    case Kind::Sqrt:
        if (!(a >= 0.0)) return false;
        a = std::sqrt(a);
        return true;
    default: a = numbers::tan(a); return true;
    }
}

/// `kind` of two numbers.
inline bool function_of_two(Kind kind, double& a, double b)
{
    switch (kind) {
    case Kind::Atan2:
        if (std::abs(a) <= kSame && std::abs(b) <= kSame) return false;
        a = numbers::atan2(a, b);
        return true;
    case Kind::Div: a = to_int32(a / b); return true;
    case Kind::Mod: a = numbers::fmod(a, b); return true;
    default:
        if (a == 0.0 && b == 0.0) return false;
        a = numbers::pow(a, b);
        return true;
    }
}

inline bool truth(double v) { return std::abs(v) > kSame; }

}  // namespace parser
