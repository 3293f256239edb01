#pragma once

#include "parser/stream/token_stream.h"

#include <optional>
#include <string>

namespace parser {

/// Expressions as the scene language evaluates them while it reads (reference manual 3.3.1.3; spec 1, 3).
/// "Sum level": comparisons, logic and ?: need parentheses; this is what parameters, vector components and right-hand
/// sides take. "Full level": the condition of #if, arguments of one-parameter functions, the operand of `rgb`.
enum class Level { Sum, Full };

/// Whether the next token can begin a number, vector or colour operand (colour keywords included): the test for an
/// optional parameter such as `hollow [float]`.
bool at_expression(TokenStream& stream);
bool at_string(TokenStream& stream);
/// Whether a colour can begin here: `color`, `rgb`, ..., or any expression.
bool at_color(TokenStream& stream);

/// All of these fail with a located message when the text is something else.
double float_expr(TokenStream& stream, Level level = Level::Sum);
glm::dvec2 vector2_expr(TokenStream& stream, Level level = Level::Sum);
glm::dvec3 vector_expr(TokenStream& stream, Level level = Level::Sum);  ///< a float counts for all components
glm::dvec4 vector4_expr(TokenStream& stream, Level level = Level::Sum);
/// A value with as many components as are written.
Tuple untyped_expr(TokenStream& stream, Level level = Level::Sum);
/// A value of `requested` components (spec 1, 3.1); the functions above are made of it.
inline Tuple requested_expr(TokenStream& stream, int requested, Level level);
/// The same, read token by token.
Tuple read_expr(TokenStream& stream, int requested, Level level);
/// `rgb ...`, `red 1 green 0.5`, `color C transmit 0.5`, C, <...>; rounded to single precision.
scene::Color color_expr(TokenStream& stream);
/// color_expr() where filter and transmit mean nothing: warns about them and leaves them out.
scene::Color rgb_expr(TokenStream& stream);
std::string string_expr(TokenStream& stream);
/// A file name: backslashes of a literal stay.
std::string path_expr(TokenStream& stream);
/// `[float]` after a flag: true if absent or > 0 (`hollow`, `no_image`, `media_interaction off`).
bool optional_flag(TokenStream& stream);
/// `( name )`-free part: continues a Sum after `first`, whose tokens were already taken.
Tuple continue_sum(TokenStream& stream, Tuple first, int requested);

inline Tuple requested_expr(TokenStream& stream, int requested, Level level)
{
    Tuple value;
    return stream.run_compiled_here(requested, level == Level::Full, value) ? value
                                                                            : read_expr(stream, requested, level);
}

}  // namespace parser
