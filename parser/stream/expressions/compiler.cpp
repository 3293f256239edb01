#include "parser/stream/expressions/compiler.h"

/// Operators, and where an expression ends.
namespace parser {

/// `+ 2` and `* 2` behind a number need no stack.
bool Compiler::fold_number(Code code, int left)
{
    if (left != 1 || out_.ops.empty()) return false;
    const CompiledOp& last = out_.ops.back();
    if (last.code != Code::Constant) return false;
    const double number = last.number;
    const bool subtract = code == Code::Subtract;
    if (code != Code::Add && code != Code::Multiply && !subtract) return false;
    out_.ops.pop_back();
    --depth_;
    emit(code == Code::Multiply ? Code::MultiplyNumber : Code::AddNumber, 0).number = subtract ? -number : number;
    return true;
}

int Compiler::sum(int requested)
{
    if (stands_alone()) alone_ = at_;
    int left = product(requested);
    while (left > 0 && (kind() == Kind::Plus || kind() == Kind::Minus)) {
        const Code code = take(Kind::Plus) ? Code::Add : (++at_, Code::Subtract);
        const std::size_t before = out_.ops.size();
        const int right = product(left);
        if (right < 0) return -1;
        const bool single = out_.ops.size() == before + 1 && right == 1;
        if (!single || !fold_number(code, left)) left = combine(code, left, right);
    }
    return left;
}

int Compiler::product(int requested)
{
    int left = factor(requested);
    while (left > 0 && (kind() == Kind::Star || kind() == Kind::Slash)) {
        const Code code = take(Kind::Star) ? Code::Multiply : (++at_, Code::Divide);
        const std::size_t before = out_.ops.size();
        const int right = factor(left);
        if (right < 0) return -1;
        const bool single = out_.ops.size() == before + 1 && right == 1;
        if (!single || !fold_number(code, left)) left = combine(code, left, right);
    }
    return left;
}

int Compiler::relation(int requested)
{
    if (meanings_.texts() && begins_text(tokens_[at_], meanings_)) {
        if (!text() || !is_relation(kind())) return -1;
        const Kind which = tokens_[at_++].kind;
        if (!text()) return -1;
        text_depth_ -= 2;
        emit(Code::TextRelation, 1).kind = which;
        return splat(requested);
    }
    int left = sum(requested);
    while (left > 0 && is_relation(kind())) {
        const Kind which = tokens_[at_++].kind;
        if (left != 1 || sum(1) != 1) return -1;
        emit(Code::Relation, -1).kind = which;
    }
    return left;
}

int Compiler::full(int requested)
{
    if (++nesting_ > kDeepestNesting) return -1;
    int left = relation(requested);
    while (left > 0 && (kind() == Kind::Ampersand || kind() == Kind::Bar)) {
        const Code code = take(Kind::Ampersand) ? Code::And : (++at_, Code::Or);
        if (left != 1 || relation(1) != 1) return -1;
        emit(code, -1);
    }
    if (left > 0 && take(Kind::Question)) {
        if (left != 1 || requested != 1 || full(1) != 1 || !take(Kind::Colon) || full(1) != 1) return -1;
        emit(Code::Choose, -2);
        if (kind() == Kind::Ampersand || kind() == Kind::Bar || kind() == Kind::Question) return -1;
    }
    --nesting_;
    return left;
}

int Compiler::factor(int requested)
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
    emit(minus ? Code::Negate : Code::Not, 0).a = static_cast<std::uint8_t>(count);
    return count;
}

int Compiler::select(int count, int requested)
{
    if (!take(Kind::Period)) return count;
    if (take(Kind::Gray)) {
        if (count < 3) return -1;
        emit(Code::Gray, 1 - count).a = static_cast<std::uint8_t>(count);
        return splat(requested);
    }
    const int index = component_index(kind());
    if (index < 0 || index >= count) return -1;
    ++at_;
    CompiledOp& op = emit(Code::Select, 1 - count);
    op.a = static_cast<std::uint8_t>(count);
    op.b = static_cast<std::uint8_t>(index);
    return splat(requested);
}

int Compiler::primary(int requested)
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

namespace {

/// Whether an expression surely ends at this token: a name might become a macro, a directive might go on.
bool ends_surely(Kind kind, bool raw)
{
    if (kind == Kind::Bad || kind == Kind::EndOfText) return false;
    return raw || (kind != Kind::Identifier && kind != Kind::Hash);
}

}  // namespace

bool compile_expression(const Token* tokens, std::uint32_t begin, std::uint32_t limit, const CompiledKey& key,
                        const Meanings& meanings, CompiledExpression& out)
{
    out.key = key;
    Compiler compiler(tokens, begin, limit, meanings, out);
    const int count = key.full() ? compiler.full(key.requested()) : compiler.sum(key.requested());
    if (count < 1 || count > 5 || !ends_surely(compiler.kind(), key.raw())) return false;
    const auto stores = [](const CompiledOp& op) { return op.code == CompiledOp::Code::StoreNormal; };
    if (const auto store = std::find_if(out.ops.begin(), out.ops.end(), stores); store != out.ops.end())
        if (std::any_of(store + 1, out.ops.end(),
                        [](const CompiledOp& op) { return op.code != CompiledOp::Code::Constant; }))
            return false;
    out.count = static_cast<std::uint8_t>(count);
    out.end = compiler.at();
    return true;
}

bool compile_text(const Token* tokens, std::uint32_t begin, std::uint32_t limit, const Meanings& meanings,
                  CompiledExpression& out)
{
    Compiler compiler(tokens, begin, limit, meanings, out);
    if (!compiler.text() || compiler.kind() == Kind::Bad || compiler.kind() == Kind::EndOfText) return false;
    out.end = compiler.at();
    return true;
}

bool compile_texts(const Token* tokens, std::uint32_t begin, std::uint32_t limit, const Meanings& meanings,
                   CompiledExpression& out)
{
    Compiler compiler(tokens, begin, limit, meanings, out);
    if (!compiler.texts() || compiler.kind() != Kind::RightParen) return false;
    out.end = compiler.at();
    return true;
}

bool compile_operand(const Token* tokens, std::uint32_t begin, std::uint32_t limit, int requested,
                     const Meanings& meanings, CompiledExpression& out)
{
    Compiler compiler(tokens, begin, limit, meanings, out);
    const int count = compiler.primary(requested);
    if (count < 1 || count > 5) return false;
    out.count = static_cast<std::uint8_t>(count);
    out.end = compiler.at();
    return true;
}

}  // namespace parser
