#include "parser/stream/expressions/compiler.h"

#include <numbers>

/// Operands: names, elements, calls, vectors, built-in functions.
namespace parser {

int Compiler::identifier(int requested)
{
    const Token& name = tokens_[at_++];
    const Value* value = meanings_.find(name.name);
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
    if (const auto* spline = value->get_if<std::shared_ptr<const function::Spline>>()) return curve(name, **spline);
    if (const auto* macro = value->get_if<std::shared_ptr<const Macro>>()) return macro_call(*macro, requested);
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
            if (!sample) return -1;
            break;
        }
    const int count = sample ? sample->count : meanings_.components(name.name);
    if (count == 0) return -1;
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
    if (function->asks_scene || function->parameters > kMostArguments || out_.functions.size() > 200 ||
        !take(Kind::LeftParen))
        return -1;
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

namespace {

std::uint8_t kind_of_curve(Kind word)
{
    using Kinds = function::Spline::Kind;
    switch (word) {
    case Kind::LinearSpline: return static_cast<std::uint8_t>(Kinds::Linear);
    case Kind::QuadraticSpline: return static_cast<std::uint8_t>(Kinds::Quadratic);
    case Kind::CubicSpline: return static_cast<std::uint8_t>(Kinds::Cubic);
    case Kind::NaturalSpline: return static_cast<std::uint8_t>(Kinds::Natural);
    default: return CompiledOp::kOwnKind;
    }
}

}  // namespace

/// `( t )` or `( t, kind )` behind the name of a spline.
int Compiler::curve(const Token& name, const function::Spline& spline)
{
    ++brackets_;
    const bool given = take(Kind::LeftParen) && number();
    --brackets_;
    std::uint8_t as = CompiledOp::kOwnKind;
    if (given && take(Kind::Comma)) {
        as = kind_of_curve(kind());
        if (as == CompiledOp::kOwnKind) return -1;
        ++at_;
    }
    if (!given || !take(Kind::RightParen)) return -1;
    const auto count = static_cast<int>(spline.components());
    CompiledOp& op = emit(Code::Curve, count - 1);
    op.name = name.name;
    op.a = as;
    op.b = static_cast<std::uint8_t>(count);
    return count;
}

bool Compiler::begins_operand() const
{
    switch (kind()) {
    case Kind::Number:
    case Kind::LeftParen:
    case Kind::Plus:
    case Kind::Minus:
    case Kind::Exclamation:
    case Kind::Less: return true;
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
    case Kind::True:
    case Kind::Yes:
    case Kind::On: return constant(1.0, requested);
    case Kind::False:
    case Kind::No:
    case Kind::Off: return constant(0.0, requested);
    default: break;
    }
    if (++nesting_ > kDeepestNesting || !take(Kind::LeftParen) || float_function(word) < 0 || !take(Kind::RightParen))
        return -1;
    --nesting_;
    return splat(requested);
}

int Compiler::float_function(Kind word)
{
    switch (word) {
    case Kind::Atan2:
    case Kind::Div:
    case Kind::Mod:
    case Kind::Pow:
        if (!number()) return -1;
        take(Kind::Comma);
        if (!number()) return -1;
        emit(Code::Function2, -1).kind = word;
        return 1;
    case Kind::Min:
    case Kind::Max:
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
    case Kind::Inside: {
        std::uint32_t name = kNoIndex;
        if (!object(name) || !vector()) return -1;
        return emit(Code::Inside, -2).name = name, 1;
    }
    case Kind::Abs:
    case Kind::Acos:
    case Kind::Asin:
    case Kind::Atan:
    case Kind::Cosh:
    case Kind::Sinh:
    case Kind::Tanh:
    case Kind::Ceil:
    case Kind::Cos:
    case Kind::Degrees:
    case Kind::Exp:
    case Kind::Floor:
    case Kind::Int:
    case Kind::Ln:
    case Kind::Log:
    case Kind::Radians:
    case Kind::Sin:
    case Kind::Sqrt:
    case Kind::Tan:
    case Kind::Rand:
        if (!number(true)) return -1;
        emit(word == Kind::Rand ? Code::Random : Code::Function1, 0).kind = word;
        return 1;
    case Kind::Asc:
    case Kind::Strlen:
    case Kind::Val:
    case Kind::Strcmp: return number_of_text(word);
    case Kind::Dimensions:
    case Kind::DimensionSize: return dimension_size(word) ? 1 : -1;
    default: return -1;
    }
}

/// The name of a declared object and the comma behind it.
bool Compiler::object(std::uint32_t& name)
{
    if (kind() != Kind::Identifier) return false;
    name = tokens_[at_++].name;
    const Value* value = meanings_.find(name);
    if (!value || !value->get_if<std::shared_ptr<const scene::Object>>()) return false;
    take(Kind::Comma);
    return true;
}

/// Behind the word. What it stores cannot be taken back: it has to be the whole expression (compile_expression sees to
/// it).
int Compiler::trace(int requested)
{
    std::uint32_t name = kNoIndex;
    if (!take(Kind::LeftParen) || !object(name) || !vector()) return -1;
    take(Kind::Comma);
    if (!vector()) return -1;
    emit(Code::Trace, -3).name = name;
    take(Kind::Comma);
    if (kind() == Kind::Identifier) {
        emit(Code::StoreNormal, 0).name = tokens_[at_].name;
        if (!meanings_.find(tokens_[at_++].name)) return -1;
    }
    return take(Kind::RightParen) ? pad(3, std::max(3, requested)) : -1;
}

int Compiler::vector_word(Kind word, int requested)
{
    switch (word) {
    case Kind::X: return tuple({1, 0, 0}, requested);
    case Kind::Y: return tuple({0, 1, 0}, requested);
    case Kind::Z: return tuple({0, 0, 1}, requested);
    case Kind::Trace: return trace(requested);
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

}  // namespace parser
