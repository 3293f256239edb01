#pragma once

#include "parser/stream/blocks/emitter.h"

#include <algorithm>
#include <initializer_list>

namespace parser::blocks {

/// How an expression is read; the same place may be read in several ways.
struct Form {
    int requested = 1;  ///< components, see requested_expr
    bool full = false;  ///< see Level
    bool raw = false;   ///< directives are not executed behind the value
    bool operator==(const Form&) const = default;
};

/// A call of a macro that gives a number or vector where it stands.
struct ValueCall {
    std::shared_ptr<const Macro> macro;
    Form form;
    bool alone = false;  ///< it is all of a sum: the value may be one
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
    /// What gives the value of a macro; null: it is not that simple.
    virtual const Program* value_of(const ValueCall& /*call*/, const std::vector<Argument>& /*arguments*/) const
    {
        return nullptr;
    }

protected:
    const Symbols& symbols_;
};

/// What Meanings::components() says of an array of texts.
inline constexpr int kTextElements = 6;
/// Whether a text begins at the token.
bool begins_text(const Token& token, const Meanings& meanings);

/// Reads the tokens of an expression as read_factor and its kin do, but only looks, and emits what works it out.
/// Nothing is executed. Component counts are known then; -1 stands for "not known here", after which what was emitted
/// has to be given up. The components lie on the emitter's stack, or a text on that of texts.
class ExpressionCompiler {
public:
    ExpressionCompiler(const Token* tokens, std::uint32_t at, std::uint32_t limit, const Meanings& meanings,
                       Emitter& emitter)
        : tokens_(tokens), at_(at), limit_(limit), meanings_(meanings), emitter_(emitter)
    {}

    /// The whole of an expression that ends at a token that ends it for certain: its components; 0: not known.
    int expression(const Form& form);
    /// One operand without a sign, and nothing behind it.
    int operand(int requested);
    /// A text.
    bool whole_text();
    /// Texts up to a parenthesis that closes, joined.
    bool whole_texts();
    std::uint32_t at() const { return at_; }

private:
    static constexpr std::size_t kDeepestNesting = 40;
    Kind kind() const { return at_ < limit_ ? tokens_[at_].kind : Kind::EndOfText; }
    bool take(Kind wanted)
    {
        if (kind() != wanted) return false;
        ++at_;
        return true;
    }
    int splat(int requested)
    {
        if (requested > 1) emitter_.splat(static_cast<std::uint32_t>(requested));
        return requested;
    }
    int constant(double value, int requested)
    {
        emitter_.constant(value);
        return splat(requested);
    }
    int tuple(std::initializer_list<double> values, int requested)
    {
        for (const double v : values) emitter_.constant(v);
        return pad(static_cast<int>(values.size()), std::max(static_cast<int>(values.size()), requested));
    }
    int pad(int count, int wanted)
    {
        for (int i = count; i < wanted; ++i) emitter_.constant(0.0);
        return std::max(count, wanted);
    }
    /// Of a value with its own count.
    int own_count(int count, int requested)
    {
        return count == 1 ? splat(requested) : count == 3 ? pad(3, std::max(3, requested)) : count;
    }
    int sum(int requested);
    int full(int requested);
    int primary(int requested);
    int product(int requested);
    int factor(int requested);
    int relation(int requested);
    int select(int count, int requested);
    int identifier(int requested);
    int element(const Token& name, const Array& array, int requested);
    int literal();
    int call(const Token& name, const function::FunctionPtr& function, int requested);
    int curve(const Token& name, const function::Spline& spline);
    int float_word(Kind word, int requested);
    int float_function(Kind word);
    int trace(int requested);
    bool object(std::uint32_t& name);
    int vector_word(Kind word, int requested);
    bool text();
    bool texts();
    bool text_function(Kind word);
    bool text_identifier();
    int number_of_text(Kind word);
    bool dimension_size(Kind word);
    int macro_call(const std::shared_ptr<const Macro>& macro, int requested);
    bool macro_argument(Argument& out);
    const std::shared_ptr<const Macro>* macro_at(std::uint32_t at) const;
    bool stands_alone() const;
    bool subscripts(std::size_t count);
    bool comma() { return take(Kind::Comma), true; }
    bool number(bool whole = false) { return (whole ? full(1) : sum(1)) == 1; }
    /// So many, with commas between them or without.
    bool numbers(int count);
    bool vector();

    const Token* tokens_;
    std::uint32_t at_, limit_;
    const Meanings& meanings_;
    Emitter& emitter_;
    int brackets_ = 0;
    std::uint32_t alone_ = kNoIndex;  ///< token of a macro call that is all of a sum
    std::size_t nesting_ = 0;
};

/// The token that closes the parenthesis at `open`; `limit`: none before it does.
std::uint32_t closing_parenthesis(const Token* tokens, std::uint32_t open, std::uint32_t limit);

}  // namespace parser::blocks
