#pragma once

#include "parser/stream/token_stream.h"

#include <memory>
#include <string>
#include <vector>

namespace parser {

/// A declared `function { }`: its parameters and its compiled body (reference manual 3.3.1.9; spec of the language 6).
/// Bodies that the program cannot evaluate yet (pattern, pigment, internal, ...) are kept as `unavailable`: declaring one
/// is fine, calling it is an error that names the reason.
class Function {
public:
    enum class Op : std::uint8_t {
        Constant, Parameter, Negate, Add, Subtract, Multiply, Divide, Less, Greater, LessEqual, GreaterEqual, Equal,
        NotEqual, And, Or, Call, User, Component
    };
    /// A node of the body; operands are indices of earlier nodes.
    struct Node {
        Op op = Op::Constant;
        Kind function = Kind::EndOfText;               ///< Call: the reserved word
        double number = 0;                             ///< Constant
        std::vector<std::uint32_t> operands;           ///< Parameter: register number
        std::shared_ptr<const Function> user;          ///< User
    };

    std::vector<std::uint32_t> registers;  ///< register of each parameter: x and u are 0, y and v 1, z 2, others from 3
    std::uint32_t register_count = 3;
    std::vector<Node> nodes;               ///< the last one is the result
    std::string unavailable;               ///< why it cannot be called; empty if it can

    double evaluate(const std::vector<double>& arguments) const;
    /// The first reason found in the body and what it calls; empty if it can be evaluated.
    const std::string& obstacle() const { return unavailable; }
};

/// At the word `function`: parameters and body.
std::shared_ptr<const Function> read_function_value(TokenStream& stream);
/// After the function's name: `( a, b, ... )`.
Tuple call_function(TokenStream& stream, const Function& function, const Token& name, int requested);

}  // namespace parser
