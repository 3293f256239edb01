#include "parser/stream/expression.h"

#include "parser/stream/function.h"
#include "parser/stream/operand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parser {
namespace {

/// Inside brackets directives are executed everywhere.
class Brackets {
public:
    explicit Brackets(TokenStream& stream) : stream_(stream), raw_(stream.raw_operators()) { stream.set_raw_operators(false); }
    ~Brackets() { stream_.set_raw_operators(raw_); }
    Brackets(const Brackets&) = delete;
    Brackets& operator=(const Brackets&) = delete;

private:
    TokenStream& stream_;
    bool raw_;
};

/// The shorter side grows: a float by replication, others by zeros.
void promote(Tuple& value, int count)
{
    if (value.count >= count) return;
    if (value.count == 1) std::fill(value.at.begin() + 1, value.at.begin() + count, value.at[0]);
    value.count = count;
}

bool is_operand_identifier(const Value& value)
{
    if (value.get_if<Tuple>() || value.get_if<std::shared_ptr<const Function>>() ||
        value.get_if<std::shared_ptr<const Spline>>())
        return true;
    const auto* array = value.get_if<std::shared_ptr<Array>>();
    if (!array) return false;
    for (const Value& element : (*array)->elements)
        if (element.set()) return is_operand_identifier(element);
    return false;
}

bool is_string_identifier(const Value& value)
{
    if (value.get_if<std::string>()) return true;
    const auto* array = value.get_if<std::shared_ptr<Array>>();
    if (!array) return false;
    for (const Value& element : (*array)->elements)
        if (element.set()) return is_string_identifier(element);
    return false;
}

bool begins_operand(TokenStream& stream, const Token& token)
{
    switch (token.kind) {
    case Kind::Number: case Kind::LeftParen: case Kind::Plus: case Kind::Minus: case Kind::Exclamation: case Kind::Less:
        return true;
    case Kind::Identifier: {
        const Value* value = stream.value_of(token);
        return value && is_operand_identifier(*value);
    }
    default:
        switch (lexical_class(token.kind)) {
        case LexicalClass::Float: case LexicalClass::Vector: case LexicalClass::Vector2: case LexicalClass::Vector4:
        case LexicalClass::Color: return true;
        default: return false;
        }
    }
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
        if (!begins_operand(stream, stream.peek())) break;
        literal.at[static_cast<std::size_t>(literal.count++)] = float_expr(stream);
    }
    stream.expect(Kind::Greater, literal.count < 5 ? "a component or '>'" : "'>' after five components");
    return literal;
}

Tuple read_identifier(TokenStream& stream, int requested)
{
    const Token name = stream.next();
    Cell cell = stream.symbols().find_cell(name.name);
    if (!cell) stream.fail_undeclared(name);
    if (cell->get_if<std::shared_ptr<Array>>()) cell = stream.subscripted(cell, name, false);
    if (const Tuple* tuple = cell->get_if<Tuple>()) {
        if (tuple->count == 1) return replicated(tuple->at[0], requested);
        Tuple value = *tuple;
        if (value.count == 3) value.count = std::max(3, requested);
        return value;
    }
    if (const auto* function = cell->get_if<std::shared_ptr<const Function>>()) {
        const std::shared_ptr<const Function> called = *function;
        return call_function(stream, *called, name, requested);
    }
    if (!cell->set()) stream.fail(stream.place(name), "'" + stream.word(name) + "' has no value yet");
    stream.fail(stream.place(name), "expected a number or vector, but '" + stream.word(name) + "' is declared as " +
                                        std::string(type_name(*cell)));
}

Tuple read_primary(TokenStream& stream, int requested)
{
    const Token token = stream.peek();
    switch (token.kind) {
    case Kind::Number: stream.next(); return replicated(token.number, requested);
    case Kind::Identifier: return read_identifier(stream, requested);
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

int component_index(Kind kind)
{
    switch (kind) {
    case Kind::X: case Kind::U: case Kind::Red: return 0;
    case Kind::Y: case Kind::V: case Kind::Green: return 1;
    case Kind::Z: case Kind::Blue: return 2;
    case Kind::T: case Kind::Filter: return 3;
    case Kind::Transmit: return 4;
    default: return -1;
    }
}

/// `.x` and the like after an operand.
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
    if (index >= value.count) stream.fail(stream.place(name), "the value has no component '" + std::string(spelling(name.kind)) + "'");
    value = replicated(value.at[static_cast<std::size_t>(index)], requested);
}

template <class Operation> void combine(Tuple& left, Tuple right, Operation operation)
{
    promote(left, right.count);
    promote(right, left.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(left.count); ++i) left.at[i] = operation(left.at[i], right.at[i]);
}

void divide(TokenStream& stream, Tuple& left, const Tuple& right, const scene::SourceRef& at)
{
    bool by_zero = false;
    combine(left, right, [&](double a, double b) {
        if (b != 0.0) return a / b;
        by_zero = true;
        return std::numeric_limits<double>::infinity();  // whatever the sign, also 0/0
    });
    if (by_zero) stream.warn(at, "division by zero");
}

Tuple continue_product(TokenStream& stream, Tuple left)
{
    for (;;) {
        const Kind kind = stream.peek_operator().kind;
        if (kind != Kind::Star && kind != Kind::Slash) return left;
        const scene::SourceRef at = stream.place(stream.next());
        const Tuple right = read_factor(stream, left.count);
        if (kind == Kind::Star) combine(left, right, [](double a, double b) { return a * b; });
        else divide(stream, left, right, at);
    }
}

Tuple continue_terms(TokenStream& stream, Tuple left)
{
    for (;;) {
        const Kind kind = stream.peek_operator().kind;
        if (kind != Kind::Plus && kind != Kind::Minus) return left;
        stream.next();
        const int count = left.count;
        const Tuple right = stream.language().version < 150 ? read_factor(stream, count)
                                                            : continue_product(stream, read_factor(stream, count));
        if (kind == Kind::Plus) combine(left, right, [](double a, double b) { return a + b; });
        else combine(left, right, [](double a, double b) { return a - b; });
    }
}

Tuple read_sum(TokenStream& stream, int requested)
{
    return continue_terms(stream, continue_product(stream, read_factor(stream, requested)));
}

bool relation_holds(Kind kind, double a, double b)
{
    switch (kind) {
    case Kind::Less: return a < b;
    case Kind::Greater: return a > b;
    case Kind::LessEqual: return a <= b || !(std::abs(a - b) > kSame);
    case Kind::GreaterEqual: return a >= b || !(std::abs(a - b) > kSame);
    case Kind::Equal: return !(std::abs(a - b) > kSame);
    default: return std::abs(a - b) > kSame;
    }
}

bool is_relation(Kind kind)
{
    return kind == Kind::Less || kind == Kind::Greater || kind == Kind::LessEqual || kind == Kind::GreaterEqual ||
           kind == Kind::Equal || kind == Kind::NotEqual;
}

Tuple read_relation(TokenStream& stream, int requested)
{
    if (at_string(stream)) {
        const std::string left = string_expr(stream);
        if (!is_relation(stream.peek().kind)) stream.fail_expected("a comparison of texts");
        const Kind kind = stream.next().kind;
        const std::string right = string_expr(stream);
        return replicated(relation_holds(kind, left.compare(right), 0.0) ? 1.0 : 0.0, requested);
    }
    Tuple left = read_sum(stream, requested);
    while (is_relation(stream.peek_operator().kind)) {
        const Kind kind = stream.next().kind;
        combine(left, read_sum(stream, left.count),
                [kind](double a, double b) { return relation_holds(kind, a, b) ? 1.0 : 0.0; });
    }
    return left;
}

Tuple read_full(TokenStream& stream, int requested)
{
    Tuple left = read_relation(stream, requested);
    const auto truth = [](double v) { return std::abs(v) > kSame; };
    for (;;) {
        const Kind kind = stream.peek_operator().kind;
        if (kind == Kind::Ampersand || kind == Kind::Bar) {
            stream.next();
            combine(left, read_relation(stream, left.count), [&](double a, double b) {
                return (kind == Kind::Ampersand ? truth(a) && truth(b) : truth(a) || truth(b)) ? 1.0 : 0.0;
            });
            continue;
        }
        if (kind != Kind::Question) return left;
        const scene::SourceRef at = stream.place(stream.next());
        if (left.count != requested && left.count != 1) stream.fail(at, "the condition before '?' must be a number");
        const bool chosen = truth(left.at[0]);
        const auto guard = stream.nest();
        const Tuple yes = read_full(stream, requested);
        stream.expect(Kind::Colon, "':' between the two values of '?'");
        const Tuple no = read_full(stream, requested);
        return chosen ? yes : no;  // both were evaluated, as in POV-Ray
    }
}

}  // namespace

Tuple replicated(double value, int requested)
{
    Tuple tuple;
    std::fill(tuple.at.begin(), tuple.at.begin() + requested, value);
    tuple.count = requested;
    return tuple;
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

Tuple continue_sum(TokenStream& stream, Tuple first, int requested)
{
    select_component(stream, first, requested);
    return continue_terms(stream, continue_product(stream, first));
}

Tuple requested_expr(TokenStream& stream, int requested, Level level)
{
    if (level == Level::Full) return read_full(stream, requested);
    return stream.language().version < 150 ? read_factor(stream, requested) : read_sum(stream, requested);
}

bool at_expression(TokenStream& stream)
{
    return begins_operand(stream, stream.peek());
}

bool at_string(TokenStream& stream)
{
    const Token& token = stream.peek();
    if (token.kind == Kind::String || lexical_class(token.kind) == LexicalClass::String) return true;
    if (token.kind != Kind::Identifier) return false;
    const Value* value = stream.value_of(token);
    return value && is_string_identifier(*value);
}

double float_expr(TokenStream& stream, Level level)
{
    const scene::SourceRef at = stream.here();
    const Tuple value = requested_expr(stream, 1, level);
    if (value.count != 1) stream.fail(at, "expected a number, found a vector or color");
    return value.at[0];
}

glm::dvec2 vector2_expr(TokenStream& stream, Level level)
{
    const scene::SourceRef at = stream.here();
    const Tuple value = requested_expr(stream, 2, level);
    if (value.count > 2) stream.fail(at, "expected two numbers, as in <0, 1>, found more");
    return {value.at[0], value.at[1]};
}

glm::dvec3 vector_expr(TokenStream& stream, Level level)
{
    const scene::SourceRef at = stream.here();
    const Tuple value = requested_expr(stream, 3, level);
    if (value.count > 3) stream.fail(at, "expected a vector of three numbers, found more");
    return value.vec3();
}

glm::dvec4 vector4_expr(TokenStream& stream, Level level)
{
    const scene::SourceRef at = stream.here();
    const Tuple value = requested_expr(stream, 4, level);
    if (value.count > 4) stream.fail(at, "expected a vector of four numbers, found more");
    return {value.at[0], value.at[1], value.at[2], value.at[3]};
}

Tuple untyped_expr(TokenStream& stream, Level level)
{
    return requested_expr(stream, 1, level);
}

bool optional_flag(TokenStream& stream)
{
    return !at_expression(stream) || float_expr(stream) > 0.0;
}

}  // namespace parser
