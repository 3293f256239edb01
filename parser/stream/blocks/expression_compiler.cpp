#include "parser/stream/blocks/expression_compiler.h"

#include "parser/stream/expressions/operand.h"
#include "parser/stream/functions/function.h"

/// Operators, and where an expression ends.
namespace parser::blocks {
namespace {

/// Whether an expression surely ends at this token: a name might become a macro, a directive might go on.
bool ends_surely(Kind kind, bool raw)
{
    if (kind == Kind::Bad || kind == Kind::EndOfText) return false;
    return raw || (kind != Kind::Identifier && kind != Kind::Hash);
}

}  // namespace

std::uint32_t closing_parenthesis(const Token* tokens, std::uint32_t open, std::uint32_t limit)
{
    int depth = 0;
    for (std::uint32_t at = open; at < limit; ++at) {
        depth += tokens[at].kind == Kind::LeftParen ? 1 : tokens[at].kind == Kind::RightParen ? -1 : 0;
        if (depth == 0) return at;
    }
    return limit;
}

int ExpressionCompiler::sum(int requested)
{
    if (stands_alone()) alone_ = at_;
    int left = product(requested);
    while (left > 0 && (kind() == Kind::Plus || kind() == Kind::Minus)) {
        const Binary f = take(Kind::Plus) ? Binary::Add : (++at_, Binary::Subtract);
        const int right = product(left);
        if (right < 0) return -1;
        left = emitter_.combine(f, left, right);
    }
    return left;
}

int ExpressionCompiler::product(int requested)
{
    int left = factor(requested);
    while (left > 0 && (kind() == Kind::Star || kind() == Kind::Slash)) {
        const Binary f = take(Kind::Star) ? Binary::Multiply : (++at_, Binary::Divide);
        const int right = factor(left);
        if (right < 0) return -1;
        left = emitter_.combine(f, left, right);
    }
    return left;
}

int ExpressionCompiler::relation(int requested)
{
    if (meanings_.texts() && begins_text(tokens_[at_], meanings_)) {
        if (!text() || !is_relation(kind())) return -1;
        const Kind which = tokens_[at_++].kind;
        if (!text()) return -1;
        emitter_.number_of_texts(kTextRelation, 2, static_cast<std::int32_t>(which));
        return splat(requested);
    }
    int left = sum(requested);
    while (left > 0 && is_relation(kind())) {
        const Kind which = tokens_[at_++].kind;
        if (left != 1 || sum(1) != 1) return -1;
        emitter_.binary(*relation_of(which));
    }
    return left;
}

int ExpressionCompiler::full(int requested)
{
    if (++nesting_ > kDeepestNesting) return -1;
    int left = relation(requested);
    while (left > 0 && (kind() == Kind::Ampersand || kind() == Kind::Bar)) {
        const Binary f = take(Kind::Ampersand) ? Binary::And : (++at_, Binary::Or);
        if (left != 1 || relation(1) != 1) return -1;
        emitter_.binary(f);
    }
    if (left > 0 && take(Kind::Question)) {
        if (left != 1 || requested != 1 || full(1) != 1 || !take(Kind::Colon) || full(1) != 1) return -1;
        emitter_.in_place(kChooseIf, 3, 1);
        if (kind() == Kind::Ampersand || kind() == Kind::Bar || kind() == Kind::Question) return -1;
    }
    --nesting_;
    return left;
}

int ExpressionCompiler::factor(int requested)
{
    while (take(Kind::Plus)) {}
    const bool minus = kind() == Kind::Minus;
    if (!minus && kind() != Kind::Exclamation) {
        const int count = primary(requested);
        return count > 0 ? select(count, requested) : -1;
    }
    ++at_;
    if (++nesting_ > kDeepestNesting) return -1;
    const int count = factor(requested);
    --nesting_;
    if (count < 0) return -1;
    if (minus) emitter_.negate(static_cast<std::uint32_t>(count));
    else emitter_.each_in_place(kNot, static_cast<std::uint32_t>(count));
    return count;
}

int ExpressionCompiler::select(int count, int requested)
{
    if (!take(Kind::Period)) return count;
    if (take(Kind::Gray)) {
        if (count < 3) return -1;
        emitter_.in_place(kGray, static_cast<std::size_t>(count), 1);
        return splat(requested);
    }
    const int index = component_index(kind());
    if (index < 0 || index >= count) return -1;
    ++at_;
    emitter_.select(static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(index));
    return splat(requested);
}

int ExpressionCompiler::primary(int requested)
{
    const Kind first = kind();
    switch (first) {
    case Kind::Number: return constant(tokens_[at_++].number, requested);
    case Kind::Identifier: return identifier(requested);
    case Kind::Less: {
        ++at_;
        ++brackets_;
        const int count = literal();
        --brackets_;
        return count;
    }
    case Kind::LeftParen: {
        ++at_;
        ++brackets_;
        const int count = full(requested);
        --brackets_;
        return count > 0 && take(Kind::RightParen) ? count : -1;
    }
    case Kind::U: ++at_; return tuple({1, 0}, 0);
    case Kind::V: ++at_; return tuple({0, 1}, 0);
    default: break;
    }
    const LexicalClass word = lexical_class(first);
    if (word != LexicalClass::Float && word != LexicalClass::Vector) return -1;
    ++at_;
    ++brackets_;
    const int count = word == LexicalClass::Float ? float_word(first, requested) : vector_word(first, requested);
    --brackets_;
    return count;
}

int ExpressionCompiler::expression(const Form& form)
{
    const std::uint32_t first = emitter_.size();
    const int count = form.full ? full(form.requested) : sum(form.requested);
    if (count < 1 || count > 5 || emitter_.too_deep() || !ends_surely(kind(), form.raw)) return 0;
    return emitter_.stores_before_end(first) ? 0 : count;
}

int ExpressionCompiler::operand(int requested)
{
    const int count = primary(requested);
    return count < 1 || count > 5 || emitter_.too_deep() ? 0 : count;
}

bool ExpressionCompiler::whole_text()
{
    return text() && !emitter_.too_deep() && kind() != Kind::Bad && kind() != Kind::EndOfText;
}

bool ExpressionCompiler::whole_texts() { return texts() && !emitter_.too_deep() && kind() == Kind::RightParen; }

}  // namespace parser::blocks
