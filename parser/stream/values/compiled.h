#pragma once

#include "function/program.h"
#include "parser/lexer/token.h"
#include "parser/stream/values/random_undo.h"
#include "parser/stream/values/symbols.h"
#include "parser/stream/values/value.h"

#include <string>
#include <vector>

/// Expressions that loops and macros read again and again, compiled at their second reading to a list of operations on
/// a stack of numbers. Component counts are known when the list is made: every name is looked at again while it runs,
/// and what has become another type, or would be an error or a warning, is left to the reader of tokens, which starts
/// afresh.
namespace parser {

namespace blocks {
struct Program;
}
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
        Curve,
        // Texts, on a stack of their own; in blocks only.
        TextConstant,
        TextLoad,
        TextElement,
        TextAppend,
        TextNumber,
        TextTuple,
        TextCharacter,
        TextPart,
        TextUpper,
        TextLower,
        TextLength,
        TextFirst,
        TextValue,
        TextOrder,
        TextRelation,
        DimensionSize,
        MacroCall,
    };
    static constexpr std::uint8_t kOwnKind = 255;  ///< Curve: `a` if the call names no kind of spline
    Code code = Code::Constant;
    std::uint8_t a = 1, b = 1;  ///< component counts of the operands, or what the code says
    Kind kind = Kind::Number;   ///< Relation, Function1, Function2: which
    std::uint32_t name = kNoIndex;
    double number = 0;  ///< Constant, AddNumber, MultiplyNumber
};

/// What a macro is given in a call that stands in an expression.
struct CompiledArgument {
    enum class Kind : std::uint8_t { Name, Element, Number, Text };
    Kind kind = Kind::Number;
    std::uint8_t count = 1;  ///< components, or subscripts
    std::uint32_t name = 0;  ///< Name, Element
};

/// A macro that gives a number or vector where it is called.
struct CompiledCall {
    std::shared_ptr<const Macro> macro;
    std::vector<CompiledArgument> arguments;
    std::uint32_t token = 0, after = 0;  ///< the macro's name; behind the arguments
    std::uint32_t guards = 0;            ///< at most so deep is the reader of tokens nested there
    int requested = 1;                   ///< see requested_expr
    bool raw = true;                     ///< directives may not be executed behind the value
    bool alone = false;                  ///< it is all of a sum: the value may be one
    bool named = false;                  ///< the value may be a variable as such (an answer of Meanings::value_of)
    const blocks::Program* program = nullptr;  ///< that gives the value (another)
};

struct CompiledExpression {
    CompiledKey key;
    std::uint32_t end = 0;   ///< token behind the expression
    std::uint8_t count = 1;  ///< components of the result
    std::vector<CompiledOp> ops;
    std::vector<function::FunctionPtr> functions;  ///< that Call expects, by CompiledOp::b
    std::vector<std::string> texts;                ///< that TextConstant names
    std::vector<CompiledCall> calls;               ///< that MacroCall names
    std::uint32_t next = kNoIndex;                 ///< another list for the same place
};

/// What a list works on.
struct CompiledContext {
    const Symbols& symbols;
    RandomUndo& random;
    GrammarHooks& hooks;
};

/// What names mean to the compiler: what they mean now, unless something else is known of them.
class Meanings {
public:
    explicit Meanings(const Symbols& symbols) : symbols_(symbols) {}
    virtual ~Meanings() = default;
    virtual const Value* find(std::uint32_t name) const { return symbols_.find(name); }
    /// Components of the elements of an array that has none yet; 0: not known.
    virtual int components(std::uint32_t /*name*/) const { return 0; }
    /// The text of a literal; false: texts are left to the reader of tokens.
    virtual bool literal(const Token& /*token*/, std::string& /*out*/) const { return false; }
    virtual bool texts() const { return false; }
    /// Components of the value that a macro gives; 0: not known, or it is not that simple.
    virtual int value_of(CompiledCall& /*call*/) const { return 0; }

protected:
    const Symbols& symbols_;
};

/// Compiles the expression at tokens[begin] if it is of the kinds known here and ends before `limit` at a token that
/// ends it for certain. Nothing is executed; false: leave it to the reader of tokens.
bool compile_expression(const Token* tokens, std::uint32_t begin, std::uint32_t limit, const CompiledKey& key,
                        const Meanings& meanings, CompiledExpression& out);
/// The same of a text: its list leaves one text.
bool compile_text(const Token* tokens, std::uint32_t begin, std::uint32_t limit, const Meanings& meanings,
                  CompiledExpression& out);
/// Texts up to a parenthesis that closes, joined.
bool compile_texts(const Token* tokens, std::uint32_t begin, std::uint32_t limit, const Meanings& meanings,
                   CompiledExpression& out);
/// One operand without a sign, and nothing behind it.
bool compile_operand(const Token* tokens, std::uint32_t begin, std::uint32_t limit, int requested,
                     const Meanings& meanings, CompiledExpression& out);
/// Whether a text begins at the token.
bool begins_text(const Token& token, const Meanings& meanings);
/// What Meanings::components() says of an array of texts.
inline constexpr int kTextElements = 6;
/// False: something is not as the list expects, and nothing has changed.
bool run_compiled(const CompiledExpression& expression, const CompiledContext& context, double* result);
/// One operation of the list, on a stack whose first free place is `top`. False: not as expected, nothing has changed.
bool run_operation(const CompiledExpression& expression, const CompiledOp& op, const CompiledContext& context,
                   double* top);

}  // namespace parser
