#pragma once

#include "function/program.h"
#include "parser/lexer/token.h"
#include "parser/stream/symbols.h"
#include "parser/stream/value.h"

#include <vector>

/// Expressions that loops and macros read again and again, compiled at their second reading to a list of operations on
/// a stack of numbers. Component counts are known when the list is made: every name is looked at again while it runs,
/// and what has become another type, or would be an error or a warning, is left to the reader of tokens, which starts
/// afresh.
namespace parser {

class GrammarHooks;
struct LanguageState;

/// How an expression is read; the same place may be read in several ways.
struct CompiledKey {
    std::uint8_t bits = 0;
    CompiledKey() = default;
    /// `requested` components, see requested_expr.
    CompiledKey(int requested, bool full, bool raw)
        : bits(static_cast<std::uint8_t>(requested | (full ? 8 : 0) | (raw ? 16 : 0)))
    {}
    int requested() const { return bits & 7; }
    bool full() const { return (bits & 8) != 0; }
    bool raw() const { return (bits & 16) != 0; }
    bool operator==(const CompiledKey&) const = default;
};

struct CompiledOp {
    enum class Code : std::uint8_t {
        Constant,
        Load,
        LoadTuple,
        Element,
        Splat,
        Select,
        Gray,
        Negate,
        Not,
        Add,
        Subtract,
        Multiply,
        Divide,
        AddTuple,
        SubtractTuple,
        MultiplyTuple,
        DivideTuple,
        AddNumber,
        MultiplyNumber,
        Relation,
        And,
        Or,
        Choose,
        Function1,
        Function2,
        Min,
        Max,
        Choose3,
        Choose4,
        Length,
        Dot,
        Cross,
        Normalize,
        Rotate,
        Call,
        Random,
        Inside,
        Trace,
        StoreNormal,
    };
    Code code = Code::Constant;
    std::uint8_t a = 1, b = 1;  ///< component counts of the operands, or what the code says
    Kind kind = Kind::Number;   ///< Relation, Function1, Function2: which
    std::uint32_t name = kNoIndex;
    double number = 0;  ///< Constant, AddNumber, MultiplyNumber
};

struct CompiledExpression {
    CompiledKey key;
    std::uint32_t end = 0;   ///< token behind the expression
    std::uint8_t count = 1;  ///< components of the result
    std::vector<CompiledOp> ops;
    std::vector<function::FunctionPtr> functions;  ///< that Call expects, by CompiledOp::b
    std::uint32_t next = kNoIndex;                 ///< another list for the same place
};

/// What a list works on.
struct CompiledContext {
    const Symbols& symbols;
    std::vector<std::uint32_t>& random_streams;
    GrammarHooks& hooks;
};

/// Compiles the expression at tokens[begin] if it is of the kinds known here and ends before `limit` at a token that
/// ends it for certain. Nothing is executed; false: leave it to the reader of tokens.
bool compile_expression(const Token* tokens, std::uint32_t begin, std::uint32_t limit, const CompiledKey& key,
                        const Symbols& symbols, CompiledExpression& out);
/// False: something is not as the list expects, and nothing has changed.
bool run_compiled(const CompiledExpression& expression, const CompiledContext& context, double* result);

}  // namespace parser
