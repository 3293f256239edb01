#pragma once

#include "function/spline.h"
#include "parser/stream/values/compiled.h"
#include "parser/stream/expressions/operand.h"

#include <algorithm>
#include <initializer_list>

namespace parser {

/// Reads tokens as read_factor and its kin do, but only looks: -1 stands for "not known here".
class Compiler {
public:
    using Code = CompiledOp::Code;
    Compiler(const Token* tokens, std::uint32_t at, std::uint32_t limit, const Meanings& meanings,
             CompiledExpression& out)
        : tokens_(tokens), at_(at), limit_(limit), meanings_(meanings), out_(out)
    {}

    int sum(int requested);
    int full(int requested);
    bool text();
    bool texts();
    int primary(int requested);
    std::uint32_t at() const { return at_; }
    Kind kind() const { return at_ < limit_ ? tokens_[at_].kind : Kind::EndOfText; }

private:
    static constexpr std::size_t kDeepestStack = 48, kDeepestNesting = 40, kDeepestTexts = 12;
    bool take(Kind wanted)
    {
        if (kind() != wanted) return false;
        ++at_;
        return true;
    }
    CompiledOp& emit(Code code, int grows)
    {
        depth_ += grows;
        if (depth_ > static_cast<int>(kDeepestStack)) too_deep_ = true;
        CompiledOp op;
        op.code = code;
        return out_.ops.emplace_back(op);
    }
    int splat(int requested)
    {
        if (requested > 1) emit(Code::Splat, requested - 1).a = static_cast<std::uint8_t>(requested);
        return requested;
    }
    int constant(double value, int requested)
    {
        emit(Code::Constant, 1).number = value;
        return splat(requested);
    }
    int tuple(std::initializer_list<double> values, int requested)
    {
        for (const double v : values) emit(Code::Constant, 1).number = v;
        return pad(static_cast<int>(values.size()), std::max(static_cast<int>(values.size()), requested));
    }
    int pad(int count, int wanted)
    {
        for (int i = count; i < wanted; ++i) emit(Code::Constant, 1).number = 0.0;
        return std::max(count, wanted);
    }
    /// Both operands are on the stack: the shorter side grows inside the operation.
    int combine(Code scalar, int left, int right)
    {
        const int count = std::max(left, right);
        const bool plain = left == 1 && right == 1;
        const Code code = plain ? scalar
                                : static_cast<Code>(static_cast<int>(scalar) + 4);  // ...Tuple stands four behind
        CompiledOp& op = emit(code, count - left - right);
        op.a = static_cast<std::uint8_t>(left);
        op.b = static_cast<std::uint8_t>(right);
        return too_deep_ ? -1 : count;
    }
    bool fold_number(Code code, int left);
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
    bool text_function(Kind word);
    bool text_identifier();
    int number_of_text(Kind word);
    bool dimension_size(Kind word);
    int macro_call(const std::shared_ptr<const Macro>& macro, int requested);
    bool macro_argument(CompiledArgument& out);
    const std::shared_ptr<const Macro>* macro_at(std::uint32_t at) const;
    bool stands_alone() const;
    bool push_text()
    {
        if (++text_depth_ > kDeepestTexts) too_deep_ = true;
        return !too_deep_;
    }
    bool comma() { return take(Kind::Comma), true; }
    bool number(bool whole = false) { return (whole ? full(1) : sum(1)) == 1; }
    bool vector();
    bool begins_operand() const;

    const Token* tokens_;
    std::uint32_t at_, limit_;
    const Meanings& meanings_;
    CompiledExpression& out_;
    int depth_ = 0, brackets_ = 0;
    std::uint32_t alone_ = kNoIndex;  ///< token of a macro call that is all of a sum
    std::size_t nesting_ = 0, text_depth_ = 0;
    bool too_deep_ = false;
};

}  // namespace parser
