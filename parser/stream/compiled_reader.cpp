#include "parser/stream/compiled.h"
#include "parser/stream/operand.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace parser {
namespace {

using Code = CompiledOp::Code;
constexpr std::size_t kDeepestStack = 48, kDeepestNesting = 40;

/// Reads tokens as read_factor and its kin do, but only looks: -1 stands for "not known here".
class Compiler {
public:
    Compiler(const Token* tokens, std::uint32_t at, std::uint32_t limit, const Symbols& symbols, CompiledExpression& out)
        : tokens_(tokens), at_(at), limit_(limit), symbols_(symbols), out_(out) {}

    int sum(int requested);
    int full(int requested);
    std::uint32_t at() const { return at_; }
    Kind kind() const { return at_ < limit_ ? tokens_[at_].kind : Kind::EndOfText; }

private:
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
        const Code code = plain ? scalar : static_cast<Code>(static_cast<int>(scalar) + 4);  // ...Tuple stands four behind
        CompiledOp& op = emit(code, count - left - right);
        op.a = static_cast<std::uint8_t>(left);
        op.b = static_cast<std::uint8_t>(right);
        return too_deep_ ? -1 : count;
    }
    bool fold_number(Code code, int left);
    int product(int requested);
    int factor(int requested);
    int primary(int requested);
    int relation(int requested);
    int select(int count, int requested);
    int identifier(int requested);
    int element(const Token& name, const Array& array, int requested);
    int literal();
    int call(const Token& name, const function::FunctionPtr& function, int requested);
    int float_word(Kind word, int requested);
    int float_function(Kind word);
    int vector_word(Kind word, int requested);
    bool number(bool whole = false) { return (whole ? full(1) : sum(1)) == 1; }
    bool vector();
    bool begins_operand() const;

    const Token* tokens_;
    std::uint32_t at_, limit_;
    const Symbols& symbols_;
    CompiledExpression& out_;
    int depth_ = 0;
    std::size_t nesting_ = 0;
    bool too_deep_ = false;
};

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

bool is_relation(Kind kind)
{
    return kind == Kind::Less || kind == Kind::Greater || kind == Kind::LessEqual || kind == Kind::GreaterEqual ||
           kind == Kind::Equal || kind == Kind::NotEqual;
}

int Compiler::relation(int requested)
{
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

int component_of(Kind kind)
{
    switch (kind) {
    case Kind::X: case Kind::U: case Kind::Red: return 0;
    case Kind::Y: case Kind::V: case Kind::Green: return 1;
    case Kind::Z: case Kind::Blue: return 2;
    case Kind::T: case Kind::Filter: return 3;
    case Kind::Transmit: return 4;
    default: return -1;
    }
}

int Compiler::select(int count, int requested)
{
    if (!take(Kind::Period)) return count;
    if (take(Kind::Gray)) {
        if (count < 3) return -1;
        emit(Code::Gray, 1 - count).a = static_cast<std::uint8_t>(count);
        return splat(requested);
    }
    const int index = component_of(kind());
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
    case Kind::Less: ++at_; return literal();
    case Kind::LeftParen: {
        ++at_;
        const int count = full(requested);
        return count > 0 && take(Kind::RightParen) ? count : -1;
    }
    case Kind::U: ++at_; return tuple({1, 0}, 0);
    case Kind::V: ++at_; return tuple({0, 1}, 0);
    default: break;
    }
    if (lexical_class(first) == LexicalClass::Float) return ++at_, float_word(first, requested);
    if (lexical_class(first) == LexicalClass::Vector) return ++at_, vector_word(first, requested);
    return -1;
}

int Compiler::identifier(int requested)
{
    const Token& name = tokens_[at_++];
    const Value* value = symbols_.find(name.name);
    if (!value) return -1;
    if (const Tuple* tuple = value->get_if<Tuple>()) {
        if (tuple->count == 1) {
            emit(Code::Load, 1).name = name.name;
            return splat(requested);
        }
        CompiledOp& op = emit(Code::LoadTuple, tuple->count);
        op.name = name.name;
        op.a = static_cast<std::uint8_t>(tuple->count);
        return tuple->count == 3 ? pad(3, std::max(3, requested)) : tuple->count;
    }
    if (const auto* array = value->get_if<std::shared_ptr<Array>>()) return element(name, **array, requested);
    if (const auto* function = value->get_if<function::FunctionPtr>()) return call(name, *function, requested);
    return -1;
}

int Compiler::element(const Token& name, const Array& array, int requested)
{
    const auto dimensions = static_cast<int>(array.sizes.size());
    for (int i = 0; i < dimensions; ++i)
        if (!take(Kind::LeftSquare) || !number() || !take(Kind::RightSquare)) return -1;
    const Tuple* sample = nullptr;
    for (const Value& one : array.elements)
        if (one.set()) {
            sample = one.get_if<Tuple>();
            break;
        }
    if (!sample) return -1;
    const int count = sample->count;
    CompiledOp& op = emit(Code::Element, count - dimensions);
    op.name = name.name;
    op.a = static_cast<std::uint8_t>(dimensions);
    op.b = static_cast<std::uint8_t>(count);
    if (count == 1) return splat(requested);
    return count == 3 ? pad(3, std::max(3, requested)) : count;
}

int Compiler::call(const Token& name, const function::FunctionPtr& function, int requested)
{
    constexpr std::uint32_t kMostArguments = 16;
    if (function->asks_scene || function->parameters > kMostArguments || out_.functions.size() > 200 || !take(Kind::LeftParen)) return -1;
    const auto arguments = static_cast<int>(function->parameters);
    for (int i = 0; i < arguments; ++i) {
        if (i > 0) take(Kind::Comma);
        if (!number()) return -1;
    }
    if (!take(Kind::RightParen)) return -1;
    const auto count = static_cast<int>(function->components);
    CompiledOp& op = emit(Code::Call, count - arguments);
    op.name = name.name;
    op.a = static_cast<std::uint8_t>(arguments);
    op.b = static_cast<std::uint8_t>(out_.functions.size());
    out_.functions.push_back(function);
    return count == 1 ? splat(requested) : count;
}

bool Compiler::begins_operand() const
{
    switch (kind()) {
    case Kind::Number: case Kind::LeftParen: case Kind::Plus: case Kind::Minus: case Kind::Exclamation: case Kind::Less: return true;
    case Kind::Identifier: return true;  // what it is not stops the compilation
    default: break;
    }
    const LexicalClass kind_class = lexical_class(kind());
    return kind_class != LexicalClass::None && kind_class != LexicalClass::String && kind_class != LexicalClass::Other;
}

int Compiler::literal()
{
    if (++nesting_ > kDeepestNesting || !number()) return -1;
    take(Kind::Comma);
    if (!number()) return -1;
    int count = 2;
    for (; count < 5; ++count) {
        take(Kind::Comma);
        if (!begins_operand()) break;
        if (!number()) return -1;
    }
    --nesting_;
    return take(Kind::Greater) ? count : -1;
}

bool Compiler::vector()
{
    const int count = sum(3);
    if (count < 0 || count > 3) return false;
    pad(count, 3);
    return true;
}

int Compiler::float_word(Kind word, int requested)
{
    switch (word) {
    case Kind::Pi: return constant(std::numbers::pi, requested);
    case Kind::True: case Kind::Yes: case Kind::On: return constant(1.0, requested);
    case Kind::False: case Kind::No: case Kind::Off: return constant(0.0, requested);
    default: break;
    }
    if (++nesting_ > kDeepestNesting || !take(Kind::LeftParen) || float_function(word) < 0 || !take(Kind::RightParen)) return -1;
    --nesting_;
    return splat(requested);
}

int Compiler::float_function(Kind word)
{
    switch (word) {
    case Kind::Atan2: case Kind::Div: case Kind::Mod: case Kind::Pow:
        if (!number()) return -1;
        take(Kind::Comma);
        if (!number()) return -1;
        emit(Code::Function2, -1).kind = word;
        return 1;
    case Kind::Min: case Kind::Max:
        if (!number()) return -1;
        while (take(Kind::Comma)) {
            if (!number()) return -1;
            emit(word == Kind::Min ? Code::Min : Code::Max, -1);
        }
        return 1;
    case Kind::Select: {
        if (!number()) return -1;
        take(Kind::Comma);
        if (!number()) return -1;
        take(Kind::Comma);
        if (!number()) return -1;
        if (!take(Kind::Comma)) return emit(Code::Choose3, -2), 1;
        if (!number()) return -1;
        return emit(Code::Choose4, -3), 1;
    }
    case Kind::Vlength:
        if (!vector()) return -1;
        return emit(Code::Length, -2), 1;
    case Kind::Vdot:
        if (!vector()) return -1;
        take(Kind::Comma);
        if (!vector()) return -1;
        return emit(Code::Dot, -5), 1;
    case Kind::Abs: case Kind::Acos: case Kind::Asin: case Kind::Atan: case Kind::Cosh: case Kind::Sinh: case Kind::Tanh:
    case Kind::Ceil: case Kind::Cos: case Kind::Degrees: case Kind::Exp: case Kind::Floor: case Kind::Int: case Kind::Ln:
    case Kind::Log: case Kind::Radians: case Kind::Sin: case Kind::Sqrt: case Kind::Tan: case Kind::Rand:
        if (!number(true)) return -1;
        emit(word == Kind::Rand ? Code::Random : Code::Function1, 0).kind = word;
        return 1;
    default: return -1;
    }
}

int Compiler::vector_word(Kind word, int requested)
{
    switch (word) {
    case Kind::X: return tuple({1, 0, 0}, requested);
    case Kind::Y: return tuple({0, 1, 0}, requested);
    case Kind::Z: return tuple({0, 0, 1}, requested);
    default: break;
    }
    const bool two = word == Kind::Vcross || word == Kind::Vrotate;
    if (!two && word != Kind::Vnormalize) return -1;
    if (++nesting_ > kDeepestNesting || !take(Kind::LeftParen) || !vector()) return -1;
    if (two) {
        take(Kind::Comma);
        if (!vector()) return -1;
    }
    if (!take(Kind::RightParen)) return -1;
    --nesting_;
    emit(word == Kind::Vcross ? Code::Cross : word == Kind::Vrotate ? Code::Rotate : Code::Normalize, two ? -3 : 0);
    return pad(3, std::max(3, requested));
}

/// Whether an expression surely ends at this token: a name might become a macro, a directive might go on.
bool ends_surely(Kind kind, bool raw)
{
    if (kind == Kind::Bad || kind == Kind::EndOfText) return false;
    return raw || (kind != Kind::Identifier && kind != Kind::Hash);
}

}  // namespace

bool compile_expression(const Token* tokens, std::uint32_t begin, std::uint32_t limit, const CompiledKey& key,
                        const Symbols& symbols, CompiledExpression& out)
{
    out.key = key;
    Compiler compiler(tokens, begin, limit, symbols, out);
    const int count = key.full() ? compiler.full(key.requested()) : compiler.sum(key.requested());
    if (count < 1 || count > 5 || !ends_surely(compiler.kind(), key.raw())) return false;
    out.count = static_cast<std::uint8_t>(count);
    out.end = compiler.at();
    return true;
}

}  // namespace parser
