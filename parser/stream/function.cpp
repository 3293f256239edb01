#include "parser/stream/function.h"

#include "parser/stream/expression.h"

#include <fmt/format.h>

#include <cmath>

namespace parser {
namespace {

constexpr double kDegree = 0.01745329251994329576;

double to_int(double v)
{
    return v > -2147483649.0 && v < 2147483648.0 ? std::trunc(v) : -2147483648.0;
}

/// Functions inside a body report nothing: 1/0 is infinite, ln(-1) is no number (spec of the language 6.2).
double built_in(Kind kind, const std::vector<double>& a)
{
    switch (kind) {
    case Kind::Abs: return std::abs(a[0]);
    case Kind::Acos: return std::acos(a[0]);
    case Kind::Acosh: return std::acosh(a[0]);
    case Kind::Asin: return std::asin(a[0]);
    case Kind::Asinh: return std::asinh(a[0]);
    case Kind::Atan: return std::atan(a[0]);
    case Kind::Atanh: return std::atanh(a[0]);
    case Kind::Ceil: return std::ceil(a[0]);
    case Kind::Cos: return std::cos(a[0]);
    case Kind::Cosh: return std::cosh(a[0]);
    case Kind::Degrees: return a[0] / kDegree;
    case Kind::Exp: return std::exp(a[0]);
    case Kind::Floor: return std::floor(a[0]);
    case Kind::Int: return to_int(a[0]);
    case Kind::Ln: return std::log(a[0]);
    case Kind::Log: return std::log10(a[0]);
    case Kind::Radians: return a[0] * kDegree;
    case Kind::Sin: return std::sin(a[0]);
    case Kind::Sinh: return std::sinh(a[0]);
    case Kind::Sqrt: return std::sqrt(a[0]);
    case Kind::Tan: return std::tan(a[0]);
    case Kind::Tanh: return std::tanh(a[0]);
    case Kind::Atan2: return std::atan2(a[0], a[1]);
    case Kind::Div: return to_int(a[0] / a[1]);
    case Kind::Mod: return std::fmod(a[0], a[1]);
    case Kind::Pow: return std::pow(a[0], a[1]);
    case Kind::Max:
    case Kind::Min: {
        double best = a[0];
        for (const double v : a) best = std::isnan(v) || (kind == Kind::Max ? best < v : v < best) ? v : best;
        return best;
    }
    default: return a[0] < 0.0 ? a[1] : a[0] == 0.0 || a.size() < 4 ? a[2] : a[3];  // select
    }
}

double operate(Function::Op op, double a, double b)
{
    using Op = Function::Op;
    switch (op) {
    case Op::Add: return a + b;
    case Op::Subtract: return a - b;
    case Op::Multiply: return a * b;
    case Op::Divide: return a / b;
    case Op::Less: return a < b;
    case Op::Greater: return a > b;
    case Op::LessEqual: return a <= b;
    case Op::GreaterEqual: return a >= b;
    case Op::Equal: return a == b;
    case Op::NotEqual: return a != b;
    case Op::And: return a != 0.0 && b != 0.0;
    default: return a != 0.0 || b != 0.0;
    }
}

}  // namespace

double Function::evaluate(const std::vector<double>& arguments) const
{
    std::vector<double> loaded(register_count, 0.0);
    for (std::size_t i = 0; i < registers.size(); ++i) loaded[registers[i]] = arguments[i];
    std::vector<double> value(nodes.size()), operands;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Node& node = nodes[i];
        switch (node.op) {
        case Op::Constant: value[i] = node.number; break;
        case Op::Parameter: value[i] = loaded[node.operands[0]]; break;
        case Op::Negate: value[i] = -value[node.operands[0]]; break;
        case Op::Call:
        case Op::User:
            operands.clear();
            for (const std::uint32_t at : node.operands) operands.push_back(value[at]);
            value[i] = node.op == Op::Call ? built_in(node.function, operands) : node.user->evaluate(operands);
            break;
        default: value[i] = operate(node.op, value[node.operands[0]], value[node.operands[1]]);
        }
    }
    return value.back();
}

Tuple call_function(TokenStream& stream, const Function& function, const Token& name, int requested)
{
    const bool raw = stream.raw_operators();
    stream.set_raw_operators(false);
    stream.expect(Kind::LeftParen, fmt::format("'(' after the name of function {}", stream.word(name)));
    if (!function.unavailable.empty()) stream.fail(stream.place(name), function.unavailable);
    std::vector<double> arguments;
    for (std::size_t i = 0; i < function.registers.size(); ++i) {
        if (i > 0) stream.accept_comma();
        arguments.push_back(float_expr(stream));
    }
    stream.expect(Kind::RightParen, fmt::format("')' after {} arguments", function.registers.size()));
    stream.set_raw_operators(raw);
    Tuple result;
    const double value = function.evaluate(arguments);
    for (int i = 0; i < requested; ++i) result.at[static_cast<std::size_t>(i)] = value;
    result.count = requested;
    return result;
}

}  // namespace parser
