#include "parser/stream/blocks/expression_compiler.h"
#include "parser/stream/expressions/operand.h"

#include <numbers>

/// Operands: names, elements, calls, vectors, built-in functions.
namespace parser::blocks {

int ExpressionCompiler::identifier(int requested)
{
    const Token& name = tokens_[at_++];
    const Value* value = meanings_.find(name.name);
    if (!value) return -1;
    if (const Tuple* tuple = value->get_if<Tuple>())
        return emitter_.load(name.name, static_cast<std::uint8_t>(tuple->count)) ? own_count(tuple->count, requested)
                                                                                 : -1;
    if (const auto* array = value->get_if<std::shared_ptr<Array>>()) return element(name, **array, requested);
    if (const auto* function = value->get_if<function::FunctionPtr>()) return call(name, *function, requested);
    if (const auto* spline = value->get_if<std::shared_ptr<const function::Spline>>()) return curve(name, **spline);
    if (const auto* macro = value->get_if<std::shared_ptr<const Macro>>()) return macro_call(*macro, requested);
    return -1;
}

/// `[ number ]`, so many times.
bool ExpressionCompiler::subscripts(std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i)
        if (!take(Kind::LeftSquare) || !number() || !take(Kind::RightSquare)) return false;
    return true;
}

int ExpressionCompiler::element(const Token& name, const Array& array, int requested)
{
    const std::size_t dimensions = array.sizes.size();
    if (!subscripts(dimensions)) return -1;
    const Tuple* sample = nullptr;
    for (const Value& one : array.elements)
        if (one.set()) {
            sample = one.get_if<Tuple>();
            if (!sample) return -1;
            break;
        }
    const int count = sample ? sample->count : meanings_.components(name.name);
    if (count == 0 || !emitter_.element(name.name, dimensions, static_cast<std::size_t>(count))) return -1;
    return own_count(count, requested);
}

int ExpressionCompiler::call(const Token& name, const function::FunctionPtr& function, int requested)
{
    constexpr std::uint32_t kMostArguments = 16;
    if (function->asks_scene || function->parameters > kMostArguments || !take(Kind::LeftParen)) return -1;
    if (!numbers(static_cast<int>(function->parameters)) || !take(Kind::RightParen)) return -1;
    emitter_.call_function(name.name, function);
    const auto count = static_cast<int>(function->components);
    return count == 1 ? splat(requested) : count;
}

namespace {

constexpr std::int32_t kNoKind = -1;

std::int32_t kind_of_curve(Kind word)
{
    using Kinds = function::Spline::Kind;
    switch (word) {
    case Kind::LinearSpline: return static_cast<std::int32_t>(Kinds::Linear);
    case Kind::QuadraticSpline: return static_cast<std::int32_t>(Kinds::Quadratic);
    case Kind::CubicSpline: return static_cast<std::int32_t>(Kinds::Cubic);
    case Kind::NaturalSpline: return static_cast<std::int32_t>(Kinds::Natural);
    default: return kNoKind;
    }
}

}  // namespace

/// `( t )` or `( t, kind )` behind the name of a spline.
int ExpressionCompiler::curve(const Token& name, const function::Spline& spline)
{
    ++brackets_;
    const bool given = take(Kind::LeftParen) && number();
    --brackets_;
    std::int32_t as = kNoKind;  // the spline's own
    if (given && take(Kind::Comma)) {
        as = kind_of_curve(kind());
        if (as == kNoKind) return -1;
        ++at_;
    }
    if (!given || !take(Kind::RightParen)) return -1;
    const auto count = static_cast<int>(spline.components());
    Op& op = emitter_.in_place(kCurve, 1, static_cast<std::size_t>(count));
    op.a = name.name;
    op.b = static_cast<std::uint32_t>(count);
    op.jump = as;
    return count;
}

int ExpressionCompiler::literal()
{
    if (++nesting_ > kDeepestNesting || !number()) return -1;
    take(Kind::Comma);
    if (!number()) return -1;
    int count = 2;
    for (; count < 5; ++count) {
        take(Kind::Comma);
        // What a name is not stops the compilation.
        if (kind() != Kind::Identifier && !begins_operand(kind())) break;
        if (!number()) return -1;
    }
    --nesting_;
    return take(Kind::Greater) ? count : -1;
}

bool ExpressionCompiler::vector()
{
    const int count = sum(3);
    if (count < 0 || count > 3) return false;
    pad(count, 3);
    return true;
}

int ExpressionCompiler::float_word(Kind word, int requested)
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

bool ExpressionCompiler::numbers(int count)
{
    for (int i = 0; i < count; ++i) {
        if (i > 0) take(Kind::Comma);
        if (!number()) return false;
    }
    return true;
}

int ExpressionCompiler::float_function(Kind word)
{
    switch (word) {
    case Kind::Atan2: return numbers(2) ? emitter_.binary(Binary::Atan2), 1 : -1;
    case Kind::Div: return numbers(2) ? emitter_.binary(Binary::IntDivide), 1 : -1;
    case Kind::Mod: return numbers(2) ? emitter_.binary(Binary::Modulo), 1 : -1;
    case Kind::Pow: return numbers(2) ? emitter_.binary(Binary::Power), 1 : -1;
    case Kind::Min:
    case Kind::Max:
        if (!number()) return -1;
        while (take(Kind::Comma)) {
            if (!number()) return -1;
            emitter_.binary(word == Kind::Min ? Binary::Min : Binary::Max);
        }
        return 1;
    case Kind::Select: {
        if (!numbers(3)) return -1;
        const bool four = take(Kind::Comma);
        if (four && !number()) return -1;
        emitter_.in_place(kChooseBySign, four ? 4 : 3, 1).b = four ? 1 : 0;
        return 1;
    }
    case Kind::Vlength:
        if (!vector()) return -1;
        emitter_.in_place(kLength, 3, 1);
        return 1;
    case Kind::Vdot:
        if (!vector() || !comma() || !vector()) return -1;
        emitter_.in_place(kDot, 6, 1);
        return 1;
    case Kind::Inside: {
        std::uint32_t name = kNoIndex;
        if (!object(name) || !vector()) return -1;
        emitter_.in_place(kInside, 3, 1).a = name;
        return 1;
    }
    case Kind::Asc:
    case Kind::Strlen:
    case Kind::Val:
    case Kind::Strcmp: return number_of_text(word);
    case Kind::Dimensions:
    case Kind::DimensionSize: return dimension_size(word) ? 1 : -1;
    default: return is_function(word) && number(true) ? emitter_.function(word), 1 : -1;
    }
}

/// The name of a declared object and the comma behind it.
bool ExpressionCompiler::object(std::uint32_t& name)
{
    if (kind() != Kind::Identifier) return false;
    name = tokens_[at_++].name;
    const Value* value = meanings_.find(name);
    if (!value || !value->get_if<std::shared_ptr<const scene::Object>>()) return false;
    take(Kind::Comma);
    return true;
}

/// Behind the word. What it stores cannot be taken back: it has to be the whole expression (expression() sees to it).
int ExpressionCompiler::trace(int requested)
{
    std::uint32_t name = kNoIndex;
    if (!take(Kind::LeftParen) || !object(name) || !vector()) return -1;
    take(Kind::Comma);
    if (!vector()) return -1;
    take(Kind::Comma);
    std::uint32_t normal = kNoIndex;
    if (kind() == Kind::Identifier) {
        normal = tokens_[at_].name;
        if (!meanings_.find(tokens_[at_++].name)) return -1;
    }
    return emitter_.trace(name, normal) && take(Kind::RightParen) ? pad(3, std::max(3, requested)) : -1;
}

int ExpressionCompiler::vector_word(Kind word, int requested)
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
    emitter_.in_place(word == Kind::Vcross ? kCross : word == Kind::Vrotate ? kRotate : kNormalize, two ? 6 : 3, 3);
    return pad(3, std::max(3, requested));
}

}  // namespace parser::blocks
