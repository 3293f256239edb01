#include "parser/stream/expressions/operand.h"

#include "parser/stream/functions/function.h"

#include <algorithm>
#include <cmath>

namespace parser {
namespace {

/// Inside brackets directives are executed everywhere.
class Brackets {
public:
    explicit Brackets(TokenStream& stream) : stream_(stream), raw_(stream.raw_operators())
    {
        stream.set_raw_operators(false);
    }
    ~Brackets() { stream_.set_raw_operators(raw_); }
    Brackets(const Brackets&) = delete;
    Brackets& operator=(const Brackets&) = delete;

private:
    TokenStream& stream_;
    bool raw_;
};

/// Whether a value is one of these kinds, or an array whose first element is.
template <class... Kinds>
bool holds(const Value& value)
{
    if ((value.get_if<Kinds>() || ...)) return true;
    const auto* array = value.get_if<std::shared_ptr<Array>>();
    if (!array) return false;
    for (const Value& element : (*array)->elements)
        if (element.set()) return holds<Kinds...>(element);
    return false;
}

Tuple read_vector_literal(TokenStream& stream)
{
    const Brackets inside(stream);
    Tuple literal;
    literal.at[0] = float_expr(stream);
    stream.accept_comma();
    literal.at[1] = float_expr(stream);
    literal.count = 2;
    while (literal.count < 5) {
        stream.accept_comma();
        if (!at_expression(stream)) break;
        literal.at[static_cast<std::size_t>(literal.count++)] = float_expr(stream);
    }
    stream.expect(Kind::Greater, literal.count < 5 ? "a component or '>'" : "'>' after five components");
    return literal;
}

Tuple read_identifier(TokenStream& stream, int requested)
{
    Token name;
    Cell cell = stream.take_name(name);
    if (!cell) stream.fail_undeclared(name);
    if (is_container(*cell)) cell = stream.subscripted(cell, name, false);
    if (const Tuple* tuple = cell->get_if<Tuple>()) {
        if (tuple->count == 1) return replicated(tuple->at[0], requested);
        Tuple value = *tuple;
        if (value.count == 3) value.count = std::max(3, requested);
        return value;
    }
    if (const auto* function = cell->get_if<function::FunctionPtr>()) {
        const function::FunctionPtr called = *function;
        return call_function(stream, called, name, requested);
    }
    if (const auto* spline = cell->get_if<SplinePtr>()) {
        const SplinePtr called = *spline;
        return call_spline(stream, *called, name);
    }
    if (!cell->set()) stream.fail(stream.place(name), "'" + stream.word(name) + "' has no value yet");
    stream.fail(stream.place(name), "expected a number or vector, but '" + stream.word(name) + "' is declared as " +
                                        std::string(type_name(*cell)));
}

Tuple read_primary(TokenStream& stream, int requested)
{
    const Token token = stream.peek();
    if (stream.at_name()) return read_identifier(stream, requested);
    switch (token.kind) {
    case Kind::Number: stream.next(); return replicated(token.number, requested);
    case Kind::Less: stream.next(); return read_vector_literal(stream);
    case Kind::LeftParen: {
        stream.next();
        const Brackets inside(stream);
        const Tuple value = requested_expr(stream, requested, Level::Full);
        stream.expect(Kind::RightParen, "')'");
        return value;
    }
    default: break;
    }
    switch (lexical_class(token.kind)) {
    case LexicalClass::Float: {
        stream.next();
        const Brackets inside(stream);
        return replicated(read_float_word(stream, token), requested);
    }
    case LexicalClass::Vector: {
        stream.next();
        const Brackets inside(stream);
        Tuple value = Tuple::of(read_vector_word(stream, token));
        value.count = std::max(3, requested);
        return value;
    }
    case LexicalClass::Vector2: {
        stream.next();
        Tuple value{{token.kind == Kind::U ? 1.0 : 0.0, token.kind == Kind::V ? 1.0 : 0.0, 0, 0, 0}, 2};
        return value;
    }
    case LexicalClass::Vector4: stream.next(); return {{0, 0, 0, 1, 0}, 4};
    default: stream.fail_expected("a number or vector");
    }
}

}  // namespace

int component_index(Kind kind)
{
    switch (kind) {
    case Kind::X:
    case Kind::U:
    case Kind::Red: return 0;
    case Kind::Y:
    case Kind::V:
    case Kind::Green: return 1;
    case Kind::Z:
    case Kind::Blue: return 2;
    case Kind::T:
    case Kind::Filter: return 3;
    case Kind::Transmit: return 4;
    default: return -1;
    }
}

bool begins_operand(Kind kind)
{
    switch (kind) {
    case Kind::Number:
    case Kind::LeftParen:
    case Kind::Plus:
    case Kind::Minus:
    case Kind::Exclamation:
    case Kind::Less: return true;
    default: break;
    }
    switch (lexical_class(kind)) {
    case LexicalClass::Float:
    case LexicalClass::Vector:
    case LexicalClass::Vector2:
    case LexicalClass::Vector4:
    case LexicalClass::Color: return true;
    default: return false;
    }
}

bool at_expression(TokenStream& stream)
{
    const Token& token = stream.peek();
    if (!stream.at_name()) return begins_operand(token.kind);
    const Value* value = stream.named_ahead();
    return value && holds<Tuple, function::FunctionPtr, SplinePtr>(*value);
}

bool at_string(TokenStream& stream)
{
    const Token& token = stream.peek();
    if (token.kind == Kind::String || lexical_class(token.kind) == LexicalClass::String) return true;
    const Value* value = stream.named_ahead();
    return value && holds<std::string>(*value);
}

Tuple replicated(double value, int requested)
{
    Tuple tuple;
    std::fill(tuple.at.begin(), tuple.at.begin() + requested, value);
    tuple.count = requested;
    return tuple;
}

void select_component(TokenStream& stream, Tuple& value, int requested)
{
    if (stream.peek_operator().kind != Kind::Period) return;
    stream.next();
    const Token name = stream.next();
    if (name.kind == Kind::Gray) {
        value = replicated(0.297 * value.at[0] + 0.589 * value.at[1] + 0.114 * value.at[2], requested);
        return;
    }
    const int index = component_index(name.kind);
    if (index < 0) stream.fail(stream.place(name), "expected a component after '.', as in V.x or C.red");
    if (index >= value.count)
        stream.fail(stream.place(name), "the value has no component '" + std::string(spelling(name.kind)) + "'");
    value = replicated(value.at[static_cast<std::size_t>(index)], requested);
}

Tuple read_factor(TokenStream& stream, int requested)
{
    const auto guard = stream.nest();
    while (stream.peek().kind == Kind::Plus) stream.next();
    const Kind kind = stream.peek().kind;
    if (kind == Kind::Minus || kind == Kind::Exclamation) {
        stream.next();
        Tuple value = read_factor(stream, requested);
        for (std::size_t i = 0; i < static_cast<std::size_t>(value.count); ++i)
            value.at[i] = kind == Kind::Minus ? -value.at[i] : (std::abs(value.at[i]) > kSame ? 0.0 : 1.0);
        return value;
    }
    Tuple value = read_primary(stream, requested);
    select_component(stream, value, requested);
    return value;
}

}  // namespace parser
