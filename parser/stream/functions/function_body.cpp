#include "parser/stream/functions/function_body.h"

#include "parser/stream/functions/function.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace parser {
namespace {

using Op = function::Op;

std::optional<Op> loose_operator(Kind kind, int level)
{
    if (level == 2) return relation_of(kind);
    if (kind != (level == 0 ? Kind::Bar : Kind::Ampersand)) return std::nullopt;
    return level == 0 ? Op::Or : Op::And;
}

/// Operator and number of arguments of a built-in function.
struct BuiltIn {
    Op op;
    std::size_t arguments;
};
std::optional<BuiltIn> built_in_of(Kind kind)
{
    switch (kind) {
    case Kind::Abs: return BuiltIn{Op::Abs, 1};
    case Kind::Acos: return BuiltIn{Op::Acos, 1};
    case Kind::Acosh: return BuiltIn{Op::Acosh, 1};
    case Kind::Asin: return BuiltIn{Op::Asin, 1};
    case Kind::Asinh: return BuiltIn{Op::Asinh, 1};
    case Kind::Atan: return BuiltIn{Op::Atan, 1};
    case Kind::Atanh: return BuiltIn{Op::Atanh, 1};
    case Kind::Ceil: return BuiltIn{Op::Ceil, 1};
    case Kind::Cos: return BuiltIn{Op::Cos, 1};
    case Kind::Cosh: return BuiltIn{Op::Cosh, 1};
    case Kind::Degrees: return BuiltIn{Op::Degrees, 1};
    case Kind::Exp: return BuiltIn{Op::Exp, 1};
    case Kind::Floor: return BuiltIn{Op::Floor, 1};
    case Kind::Int: return BuiltIn{Op::Int, 1};
    case Kind::Ln: return BuiltIn{Op::Ln, 1};
    case Kind::Log: return BuiltIn{Op::Log, 1};
    case Kind::Radians: return BuiltIn{Op::Radians, 1};
    case Kind::Sin: return BuiltIn{Op::Sin, 1};
    case Kind::Sinh: return BuiltIn{Op::Sinh, 1};
    case Kind::Sqrt: return BuiltIn{Op::Sqrt, 1};
    case Kind::Tan: return BuiltIn{Op::Tan, 1};
    case Kind::Tanh: return BuiltIn{Op::Tanh, 1};
    case Kind::Atan2: return BuiltIn{Op::Atan2, 2};
    case Kind::Div: return BuiltIn{Op::IntDivide, 2};
    case Kind::Mod: return BuiltIn{Op::Modulo, 2};
    case Kind::Max: return BuiltIn{Op::Max, 2};
    case Kind::Min: return BuiltIn{Op::Min, 2};
    default: return std::nullopt;
    }
}

}  // namespace

std::optional<Op> relation_of(Kind kind)
{
    switch (kind) {
    case Kind::Less: return Op::Less;
    case Kind::Greater: return Op::Greater;
    case Kind::LessEqual: return Op::LessEqual;
    case Kind::GreaterEqual: return Op::GreaterEqual;
    case Kind::Equal: return Op::Equal;
    case Kind::NotEqual: return Op::NotEqual;
    default: return std::nullopt;
    }
}

BodyReader::Value BodyReader::read()
{
    const auto guard = stream_.nest();
    return level(0);
}

BodyReader::Value BodyReader::level(int which)
{
    if (build_.full()) stream_.fail(stream_.here(), "this function is too long");
    if (which == 3) return sum();
    Value left = level(which + 1);
    while (const auto op = loose_operator(stream_.peek().kind, which)) {
        stream_.next();
        left = build_.binary(*op, left, level(which + 1));
    }
    return left;
}

BodyReader::Value BodyReader::sum()
{
    Value left = product();
    double pending = 0.0;  // constants added to `left` one after the other
    const auto settled = [&] { return pending != 0.0 ? build_.binary(Op::Add, left, build_.constant(pending)) : left; };
    for (;;) {
        const Kind kind = stream_.peek().kind;
        if (kind != Kind::Plus && kind != Kind::Minus) return settled();
        stream_.next();
        const Value right = product();
        if (build_.is_constant(right)) {
            pending += kind == Kind::Plus ? build_.number(right) : -build_.number(right);
            continue;
        }
        left = build_.binary(kind == Kind::Plus ? Op::Add : Op::Subtract, settled(), right);
        pending = 0.0;
    }
}

BodyReader::Value BodyReader::product()
{
    Value left = signed_operand();
    for (;;) {
        const Kind kind = stream_.peek().kind;
        if (kind != Kind::Star && kind != Kind::Slash) return left;
        const scene::SourceRef at = stream_.place(stream_.next());
        const Value right = signed_operand();
        if (!build_.is_constant(right)) {
            left = build_.binary(kind == Kind::Star ? Op::Multiply : Op::Divide, left, right);
            continue;
        }
        const double v = build_.number(right);
        if (kind == Kind::Slash && v == 0.0) stream_.fail(at, "division by zero");
        if (build_.is_constant(left)) {
            left = build_.binary(kind == Kind::Star ? Op::Multiply : Op::Divide, left, right);
        } else if (v != 1.0) {
            left = build_.binary(Op::Multiply, left, kind == Kind::Star ? right : build_.constant(1.0 / v));
        }
    }
}

BodyReader::Value BodyReader::signed_operand()
{
    if (stream_.accept(Kind::Plus)) return operand();
    if (stream_.accept(Kind::Minus)) return build_.unary(Op::Negate, operand());
    return operand();
}

BodyReader::Value BodyReader::operand()
{
    const Token token = stream_.peek();
    if (token.kind == Kind::Number) return stream_.next(), build_.constant(token.number);
    if (stream_.accept(Kind::LeftParen)) {
        const Value inner = read();
        stream_.expect(Kind::RightParen, "')'");
        return inner;
    }
    if (token.kind == Kind::Identifier || is_keyword(token.kind))
        if (const auto known = names_.find(stream_.word(token)); known != names_.end())
            return stream_.next(), known->second;
    switch (token.kind) {
    case Kind::X:
    case Kind::Y:
    case Kind::Z:
    case Kind::U:
    case Kind::V:  // no parameter is called so
        return stream_.next(), build_.constant(0.0);
    case Kind::Pi: return stream_.next(), build_.constant(std::numbers::pi);
    case Kind::Tau: return stream_.next(), build_.constant(2.0 * std::numbers::pi);
    case Kind::Clock:
        return stream_.next(), build_.constant(static_cast<double>(static_cast<float>(stream_.options().clock)));
    case Kind::Identifier: return named(token);
    default: break;
    }
    if (lexical_class(token.kind) == LexicalClass::Float) return built_in(token);
    stream_.fail_expected("a number, a parameter or a function");
}

BodyReader::Value BodyReader::named(const Token& token)
{
    stream_.next();
    Cell cell = stream_.symbols().find_cell(token.name);
    if (!cell && token.name == stream_.declaring())
        stream_.fail(stream_.place(token),
                     fmt::format("function '{}' calls itself: functions cannot recurse", stream_.word(token)));
    if (!cell) stream_.fail_undeclared(token);
    if (is_container(*cell)) cell = stream_.subscripted(cell, token, false);
    if (const Tuple* tuple = cell->get_if<Tuple>(); tuple && tuple->count == 1) return build_.constant(tuple->at[0]);
    if (const auto* called = cell->get_if<function::FunctionPtr>()) return user_function(token, *called);
    stream_.fail(stream_.place(token), fmt::format("'{}' is no number and no function", stream_.word(token)));
}

BodyReader::Value BodyReader::user_function(const Token& name, const function::FunctionPtr& found)
{
    const function::FunctionPtr called = found;  // reading may change what the name stands for
    constexpr std::uint32_t kDeepest = 200;      // every level takes some kilobytes of a thread's stack
    if (called->depth >= kDeepest) stream_.fail(stream_.place(name), "functions call each other too deeply here");
    const auto operands = arguments();
    if (operands.size() != called->parameters)
        stream_.fail(stream_.place(name),
                     fmt::format("function {} takes {} arguments", stream_.word(name), called->parameters));
    const Value value = build_.call(called, operands);
    return called->components == 1 ? value : component(value, called->components);
}

BodyReader::Value BodyReader::component(Value vector, std::uint32_t count)
{
    stream_.expect(Kind::Period, "'.' and a component of this function's vector, as in .x or .red");
    const Token name = stream_.next();
    const auto at = [&](std::uint32_t k) { return k < count ? build_.component(vector, k) : build_.constant(0.0); };
    const auto scaled = [&](double by, std::uint32_t k) {
        return build_.binary(Op::Multiply, build_.constant(by), at(k));
    };
    const auto plus = [&](Value a, Value b) { return build_.binary(Op::Add, a, b); };
    switch (name.kind) {
    case Kind::X:
    case Kind::U:
    case Kind::Red: return at(0);
    case Kind::Y:
    case Kind::V:
    case Kind::Green: return at(1);
    case Kind::Z:
    case Kind::Blue: return at(2);
    case Kind::T:
    case Kind::Filter: return at(3);
    case Kind::Transmit: return at(4);
    case Kind::Gray: return plus(plus(scaled(0.297, 0), scaled(0.589, 1)), scaled(0.114, 2));
    default: break;
    }
    const std::string word = name.kind == Kind::Identifier ? stream_.word(name) : std::string();
    if (word == "grey") return plus(plus(scaled(0.297, 0), scaled(0.589, 1)), scaled(0.114, 2));
    if (word == "hf")
        return build_.binary(Op::Multiply, plus(at(0), build_.binary(Op::Divide, at(1), build_.constant(255.0))),
                             build_.constant(0.996093));
    stream_.fail(stream_.place(name), "expected a component after '.', as in .x or .red");
}

void BodyReader::comma() { stream_.expect(Kind::Comma, "',' and the next argument"); }

std::vector<BodyReader::Value> BodyReader::arguments()
{
    std::vector<Value> values;
    stream_.expect(Kind::LeftParen, "'(' and the function's arguments");
    do values.push_back(read());
    while (stream_.accept_comma());
    stream_.expect(Kind::RightParen, "')' after the function's arguments");
    return values;
}

BodyReader::Value BodyReader::built_in(const Token& token)
{
    stream_.next();
    switch (token.kind) {
    case Kind::Sum:
    case Kind::Prod: return loop(token);
    case Kind::Select: return select(token);
    case Kind::Pow: return power(token, arguments());
    default: break;
    }
    const auto known = built_in_of(token.kind);
    if (!known) stream_.fail(stream_.place(token), fmt::format("{} cannot stand in a function", spelling(token.kind)));
    const auto operands = arguments();
    const bool more = token.kind == Kind::Min || token.kind == Kind::Max;
    if (more ? operands.size() < 2 : operands.size() != known->arguments)
        stream_.fail(stream_.place(token),
                     fmt::format("{} takes {}{} argument{}, not {}", spelling(token.kind), more ? "at least " : "",
                                 known->arguments, known->arguments == 1 ? "" : "s", operands.size()));
    if (known->arguments == 1) return build_.unary(known->op, operands[0]);
    Value value = operands[0];
    for (std::size_t i = 1; i < operands.size(); ++i) value = build_.binary(known->op, value, operands[i]);
    return value;
}

}  // namespace parser
