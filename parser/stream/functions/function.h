#pragma once

#include "function/program.h"
#include "parser/stream/token_stream.h"

namespace parser {

/// At the word `function`: parameters and body, compiled (reference manual 3.3.1.9; spec 5b, 15).
function::FunctionPtr read_function_value(TokenStream& stream);
/// The body behind the brace that has been taken, up to the one that closes it, which is taken too. `parameters`: names
/// in order; empty: x, y and z.
function::FunctionPtr read_function_body(TokenStream& stream, const std::vector<std::string>& parameters);
/// After the function's name: `( a, b, ... )`.
Tuple call_function(TokenStream& stream, const function::FunctionPtr& called, const Token& name, int requested);

using SplinePtr = std::shared_ptr<const function::Spline>;
/// At the word `spline`: the block.
SplinePtr read_spline(TokenStream& stream);
/// After a spline's name: `( t )` or `( t, type )`.
Tuple call_spline(TokenStream& stream, const function::Spline& spline, const Token& name);

/// The operator of a comparison; nothing: it is none.
std::optional<function::Op> relation_of(Kind kind);

}  // namespace parser
