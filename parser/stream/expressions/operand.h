#pragma once

#include "parser/stream/expression.h"

/// Inside of the expression reader: one operand, and the built-in functions.
namespace parser {

/// Whether a word or sign that is no name begins a number, a vector or a colour.
bool begins_operand(Kind kind);
/// Place of the component that a word behind a period names; -1: none.
int component_index(Kind word);

/// Operand with signs and component access: `-V.y`, `!a`, `(a < b)`, `<1, 2>`, `sin(x)`.
Tuple read_factor(TokenStream& stream, int requested);
/// `.x` and the like after an operand, if there.
void select_component(TokenStream& stream, Tuple& value, int requested);
/// Functions and constants that begin with the reserved word `word`, already taken.
double read_float_word(TokenStream& stream, const Token& word);
glm::dvec3 read_vector_word(TokenStream& stream, const Token& word);
/// `requested` components that all hold `value`.
Tuple replicated(double value, int requested);
/// An identifier that must be an object: argument of trace, inside, ...
std::shared_ptr<const scene::Object> read_object_identifier(TokenStream& stream);
/// Truncation towards zero to 32 bits; what does not fit (or is no number) becomes the smallest value.
inline std::int32_t to_int32(double value)
{
    constexpr std::int32_t kSmallest = -2147483647 - 1;
    return value > -2147483649.0 && value < 2147483648.0 ? static_cast<std::int32_t>(value) : kSmallest;
}
/// v turned about x, then y, then z.
glm::dvec3 rotated(glm::dvec3 v, const glm::dvec3& degrees);
/// `a relation b`, with the tolerance of the language.
bool relation_holds(Kind kind, double a, double b);
bool is_relation(Kind kind);
inline constexpr double kSame = 1e-10;  ///< comparisons and truth: values nearer than this are equal

}  // namespace parser
