#include "parser/stream/expression.h"

#include "parser/stream/expressions/operand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parser {
namespace {

/// The shorter side grows: a float by replication, others by zeros.
void promote(Tuple& value, int count)
{
    if (value.count >= count) return;
    if (value.count == 1) std::fill(value.at.begin() + 1, value.at.begin() + count, value.at[0]);
    value.count = count;
}

template <class Operation>
void combine(Tuple& left, Tuple right, Operation operation)
{
    promote(left, right.count);
    promote(right, left.count);
    for (std::size_t i = 0; i < static_cast<std::size_t>(left.count); ++i)
        left.at[i] = operation(left.at[i], right.at[i]);
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
        const Token at = stream.next();
        const Tuple right = read_factor(stream, left.count);
        if (kind == Kind::Star) combine(left, right, [](double a, double b) { return a * b; });
        else divide(stream, left, right, stream.place(at));
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

}  // namespace

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

namespace {

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

Tuple continue_sum(TokenStream& stream, Tuple first, int requested)
{
    select_component(stream, first, requested);
    return continue_terms(stream, continue_product(stream, first));
}

Tuple read_expr(TokenStream& stream, int requested, Level level)
{
    if (level == Level::Full) return read_full(stream, requested);
    return stream.language().version < 150 ? read_factor(stream, requested) : read_sum(stream, requested);
}

namespace {

/// `requested` components at most; an error names the expression's first token.
Tuple limited_expr(TokenStream& stream, int requested, Level level, const char* refusal)
{
    const Token& at = stream.peek();
    Tuple value;
    if (!stream.run_compiled_here(requested, level == Level::Full, value)) value = read_expr(stream, requested, level);
    if (value.count > requested) stream.fail(stream.place(at), refusal);
    return value;
}

}  // namespace

double float_expr(TokenStream& stream, Level level)
{
    return limited_expr(stream, 1, level, "expected a number, found a vector or color").at[0];
}

glm::dvec2 vector2_expr(TokenStream& stream, Level level)
{
    const Tuple value = limited_expr(stream, 2, level, "expected two numbers, as in <0, 1>, found more");
    return {value.at[0], value.at[1]};
}

glm::dvec3 vector_expr(TokenStream& stream, Level level)
{
    return limited_expr(stream, 3, level, "expected a vector of three numbers, found more").vec3();
}

glm::dvec4 vector4_expr(TokenStream& stream, Level level)
{
    const Tuple value = limited_expr(stream, 4, level, "expected a vector of four numbers, found more");
    return {value.at[0], value.at[1], value.at[2], value.at[3]};
}

Tuple untyped_expr(TokenStream& stream, Level level) { return requested_expr(stream, 1, level); }

bool optional_flag(TokenStream& stream) { return !at_expression(stream) || float_expr(stream) > 0.0; }

}  // namespace parser
