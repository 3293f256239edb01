#pragma once

#include "parser/stream/expressions/operand.h"

#include <cmath>

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
        a = std::acos(a);
        return true;
    case Kind::Asin:
        if (!(a >= -1.0 && a <= 1.0)) return false;
        a = std::asin(a);
        return true;
    case Kind::Atan: a = std::atan(a); return true;
    case Kind::Cosh: a = std::cosh(a); return true;
    case Kind::Sinh: a = std::sinh(a); return true;
    case Kind::Tanh: a = std::tanh(a); return true;
    case Kind::Ceil: a = std::ceil(a); return true;
    case Kind::Cos: a = std::cos(a); return true;
    case Kind::Degrees: a = a / kDegreeInRadians; return true;
    case Kind::Exp: a = std::exp(a); return true;
    case Kind::Floor: a = std::floor(a); return true;
    case Kind::Int: a = to_int32(a); return true;
    case Kind::Ln:
        if (!(a > 0.0)) return false;
        a = std::log(a);
        return true;
    case Kind::Log:
        if (!(a > 0.0)) return false;
        a = std::log10(a);
        return true;
    case Kind::Radians: a = a * kDegreeInRadians; return true;
    case Kind::Sin: a = std::sin(a); return true;
    case Kind::Sqrt:
        if (!(a >= 0.0)) return false;
        a = std::sqrt(a);
        return true;
    default: a = std::tan(a); return true;
    }
}

/// `kind` of two numbers.
inline bool function_of_two(Kind kind, double& a, double b)
{
    switch (kind) {
    case Kind::Atan2:
        if (std::abs(a) <= kSame && std::abs(b) <= kSame) return false;
        a = std::atan2(a, b);
        return true;
    case Kind::Div: a = to_int32(a / b); return true;
    case Kind::Mod: a = std::fmod(a, b); return true;
    default:
        if (a == 0.0 && b == 0.0) return false;
        a = std::pow(a, b);
        return true;
    }
}

inline bool truth(double v) { return std::abs(v) > kSame; }

}  // namespace parser
