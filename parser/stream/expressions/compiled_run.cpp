#include "parser/stream/expressions/compiled.h"

#include "function/evaluate.h"
#include "parser/stream/hooks.h"
#include "parser/stream/expressions/operand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parser {
namespace {

using Code = CompiledOp::Code;
constexpr double kDegree = 0.01745329251994329576;

/// Streams of random numbers are set back where a list stops halfway.
class RandomUndo {
public:
    explicit RandomUndo(std::vector<std::uint32_t>& streams) : streams_(streams) {}
    bool draw(double index, double& out)
    {
        const std::int32_t i = to_int32(index);
        if (used_ == std::size(old_) || i < 0 || static_cast<std::size_t>(i) >= streams_.size()) return false;
        std::uint32_t& s = streams_[static_cast<std::size_t>(i)];
        old_[used_++] = {i, s};
        s = 1812433253u * s + 12345u;
        out = s / 4294967295.0;
        return true;
    }
    bool give_up()
    {
        while (used_ > 0) {
            --used_;
            streams_[static_cast<std::size_t>(old_[used_].index)] = old_[used_].state;
        }
        return false;
    }

private:
    struct Old {
        std::int32_t index;
        std::uint32_t state;
    };
    std::vector<std::uint32_t>& streams_;
    Old old_[8];
    std::size_t used_ = 0;
};

/// False where the reader of tokens has something to say.
bool function_of_one(Kind kind, double& a)
{
    switch (kind) {
    case Kind::Abs: a = std::abs(a); return true;
    case Kind::Acos:
        if (!(a >= -1.0 && a <= 1.0)) return false;
        a = std::acos(a);
        return true;
    case Kind::Asin:
        if (!(a >= -1.0 && a <= 1.0)) return false;
        a = std::asin(a);
        return true;
    case Kind::Atan: a = std::atan(a); return true;
    case Kind::Cosh: a = std::cosh(a); return true;
    case Kind::Sinh: a = std::sinh(a); return true;
    case Kind::Tanh: a = std::tanh(a); return true;
    case Kind::Ceil: a = std::ceil(a); return true;
    case Kind::Cos: a = std::cos(a); return true;
    case Kind::Degrees: a = a / kDegree; return true;
    case Kind::Exp: a = std::exp(a); return true;
    case Kind::Floor: a = std::floor(a); return true;
    case Kind::Int: a = to_int32(a); return true;
    case Kind::Ln:
        if (!(a > 0.0)) return false;
        a = std::log(a);
        return true;
    case Kind::Log:
        if (!(a > 0.0)) return false;
        a = std::log10(a);
        return true;
    case Kind::Radians: a = a * kDegree; return true;
    case Kind::Sin: a = std::sin(a); return true;
    case Kind::Sqrt:
        if (!(a >= 0.0)) return false;
        a = std::sqrt(a);
        return true;
    default: a = std::tan(a); return true;
    }
}

bool function_of_two(Kind kind, double& a, double b)
{
    switch (kind) {
    case Kind::Atan2:
        if (std::abs(a) <= kSame && std::abs(b) <= kSame) return false;
        a = std::atan2(a, b);
        return true;
    case Kind::Div: a = to_int32(a / b); return true;
    case Kind::Mod: a = std::fmod(a, b); return true;
    default:
        if (a == 0.0 && b == 0.0) return false;
        a = std::pow(a, b);
        return true;
    }
}

bool truth(double v) { return std::abs(v) > kSame; }

/// left (a numbers) op right (b numbers), the result where left stood. False: a division by zero.
bool combine(Code code, double* left, int a, const double* right, int b)
{
    double other[5];
    for (int i = 0; i < std::max(a, b); ++i) other[i] = i < b ? right[i] : b == 1 ? right[0] : 0.0;
    for (int i = a; i < b; ++i) left[i] = a == 1 ? left[0] : 0.0;
    for (int i = 0; i < std::max(a, b); ++i) {
        switch (code) {
        case Code::AddTuple: left[i] = left[i] + other[i]; break;
        case Code::SubtractTuple: left[i] = left[i] - other[i]; break;
        case Code::MultiplyTuple: left[i] = left[i] * other[i]; break;
        default:
            if (other[i] == 0.0) return false;
            left[i] = left[i] / other[i];
        }
    }
    return true;
}

/// The same on the stack.
bool combine_at(const CompiledOp& op, double*& top)
{
    double* const left = top - op.b - op.a;
    double right[5];
    std::copy(top - op.b, top, right);
    if (!combine(op.code, left, op.a, right, op.b)) return false;
    top = left + std::max(op.a, op.b);
    return true;
}

/// The subscripts at `top` become the element's components.
bool load_element(const CompiledOp& op, const Symbols& symbols, double* subscripts)
{
    const Value* value = symbols.find(op.name);
    const auto* held = value ? value->get_if<std::shared_ptr<Array>>() : nullptr;
    if (!held || (*held)->sizes.size() != op.a) return false;
    const Array& array = **held;
    std::size_t index = 0;
    for (std::size_t i = 0; i < op.a; ++i) {
        const double at = subscripts[i] + kSubscriptSlack;
        if (!(at >= 0.0 && at < array.sizes[i])) return false;
        index = index * array.sizes[i] + static_cast<std::size_t>(at);
    }
    const Tuple* element = array.elements[index].get_if<Tuple>();
    if (!element || element->count != op.b) return false;
    for (std::size_t i = 0; i < op.b; ++i) subscripts[i] = element->at[i];
    return true;
}

bool call(const CompiledOp& op, const CompiledExpression& expression, const Symbols& symbols, double* arguments)
{
    const Value* value = symbols.find(op.name);
    const auto* held = value ? value->get_if<function::FunctionPtr>() : nullptr;
    const function::FunctionPtr& expected = expression.functions[op.b];
    if (!held || *held != expected) return false;
    if (expected->components == 1) {
        arguments[0] = function::evaluate(*expected, arguments, function::no_host());
        return true;
    }
    const function::Values values = function::evaluate_all(*expected, arguments, function::no_host());
    for (std::size_t i = 0; i < expected->components; ++i) arguments[i] = values[i];
    return true;
}

glm::dvec3 at3(const double* v) { return {v[0], v[1], v[2]}; }
void put3(double* to, const glm::dvec3& v)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
}

/// A list at work: its stack and what it has to undo.
class Run {
public:
    Run(const CompiledExpression& expression, const CompiledContext& context)
        : expression_(expression), context_(context), random_(context.random_streams)
    {}

    bool all(double* result)
    {
        for (const CompiledOp& op : expression_.ops)
            if (!step(op)) return random_.give_up();
        result[0] = stack_[0];
        for (int i = 1; i < expression_.count; ++i) result[i] = stack_[i];
        return true;
    }

private:
    /// The operations that most lists are made of.
    bool step(const CompiledOp& op)
    {
        switch (op.code) {
        case Code::Constant: *top_++ = op.number; return true;
        case Code::Load: return load(op.name, 1);
        case Code::LoadTuple: return load(op.name, op.a);
        case Code::Element:
            if (!load_element(op, context_.symbols, top_ - op.a)) return false;
            top_ += op.b - op.a;
            return true;
        case Code::Add:
            --top_;
            top_[-1] += top_[0];
            return true;
        case Code::Subtract:
            --top_;
            top_[-1] -= top_[0];
            return true;
        case Code::Multiply:
            --top_;
            top_[-1] *= top_[0];
            return true;
        case Code::Divide: --top_; return top_[0] != 0.0 ? (top_[-1] /= top_[0], true) : false;
        case Code::AddTuple:
            if (op.a != op.b) return combine_at(op, top_);
            top_ -= op.b;
            for (int i = 0; i < op.a; ++i) top_[i - op.a] += top_[i];
            return true;
        case Code::SubtractTuple:
            if (op.a != op.b) return combine_at(op, top_);
            top_ -= op.b;
            for (int i = 0; i < op.a; ++i) top_[i - op.a] -= top_[i];
            return true;
        case Code::MultiplyTuple:
        case Code::DivideTuple: return combine_at(op, top_);
        case Code::AddNumber: top_[-1] += op.number; return true;
        case Code::MultiplyNumber: top_[-1] *= op.number; return true;
        case Code::Relation:
            --top_;
            top_[-1] = relation_holds(op.kind, top_[-1], top_[0]) ? 1.0 : 0.0;
            return true;
        case Code::And:
            --top_;
            top_[-1] = truth(top_[-1]) && truth(top_[0]) ? 1.0 : 0.0;
            return true;
        case Code::Or:
            --top_;
            top_[-1] = truth(top_[-1]) || truth(top_[0]) ? 1.0 : 0.0;
            return true;
        case Code::Length:
            top_ -= 2;
            top_[-1] = glm::length(at3(top_ - 1));
            return true;
        case Code::Random: return random_.draw(top_[-1], top_[-1]);
        default: return shape(op) || function(op);
        }
    }

    /// What moves, chooses or turns over components. False: none of these.
    bool shape(const CompiledOp& op)
    {
        switch (op.code) {
        case Code::Splat:
            for (int i = 1; i < op.a; ++i, ++top_) *top_ = top_[-1];
            return true;
        case Code::Select: {
            const double chosen = top_[op.b - op.a];
            top_ -= op.a - 1;
            top_[-1] = chosen;
            return true;
        }
        case Code::Gray:
            top_ -= op.a - 1;
            top_[-1] = 0.297 * top_[-1] + 0.589 * top_[0] + 0.114 * top_[1];
            return true;
        case Code::Negate:
            for (int i = 1; i <= op.a; ++i) top_[-i] = -top_[-i];
            return true;
        case Code::Not:
            for (int i = 1; i <= op.a; ++i) top_[-i] = truth(top_[-i]) ? 0.0 : 1.0;
            return true;
        case Code::Choose:
            top_ -= 2;
            top_[-1] = truth(top_[-1]) ? top_[0] : top_[1];
            return true;
        case Code::Min:
            --top_;
            top_[-1] = top_[0] < top_[-1] ? top_[0] : top_[-1];
            return true;
        case Code::Max:
            --top_;
            top_[-1] = top_[-1] < top_[0] ? top_[0] : top_[-1];
            return true;
        case Code::Choose3:
            top_ -= 2;
            top_[-1] = top_[-1] < 0.0 ? top_[0] : top_[1];
            return true;
        case Code::Choose4:
            top_ -= 3;
            top_[-1] = top_[-1] < 0.0 ? top_[0] : top_[-1] == 0.0 ? top_[1] : top_[2];
            return true;
        default: return false;
        }
    }

    /// Functions. False: the reader of tokens has something to say.
    bool function(const CompiledOp& op)
    {
        switch (op.code) {
        case Code::Function1: return function_of_one(op.kind, top_[-1]);
        case Code::Function2: --top_; return function_of_two(op.kind, top_[-1], top_[0]);
        case Code::Dot:
            top_ -= 5;
            top_[-1] = glm::dot(at3(top_ - 1), at3(top_ + 2));
            return true;
        case Code::Cross:
            top_ -= 3;
            put3(top_ - 3, glm::cross(at3(top_ - 3), at3(top_)));
            return true;
        case Code::Normalize: {
            const double length = glm::length(at3(top_ - 3));
            if (!(length != 0.0)) return false;
            put3(top_ - 3, at3(top_ - 3) / length);
            return true;
        }
        case Code::Rotate:
            top_ -= 3;
            put3(top_ - 3, rotated(at3(top_ - 3), at3(top_)));
            return true;
        case Code::Call:
            if (!call(op, expression_, context_.symbols, top_ - op.a)) return false;
            top_ += static_cast<int>(expression_.functions[op.b]->components) - op.a;
            return true;
        case Code::Inside: return inside(op);
        case Code::Trace: return trace(op);
        case Code::StoreNormal: return store_normal(op);
        default: return false;
        }
    }

    bool load(std::uint32_t name, int count)
    {
        const Value* value = context_.symbols.find_known(name);
        const Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
        if (!tuple || tuple->count != count) return false;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) *top_++ = tuple->at[i];
        return true;
    }

    const std::shared_ptr<const scene::Object>* object(const CompiledOp& op) const
    {
        const Value* value = context_.symbols.find(op.name);
        return value ? value->get_if<std::shared_ptr<const scene::Object>>() : nullptr;
    }

    bool inside(const CompiledOp& op)
    {
        const auto* asked = object(op);
        if (!asked) return false;
        top_ -= 2;
        const auto answer = context_.hooks.inside(*asked, at3(top_ - 1));
        if (!answer) return false;
        top_[-1] = *answer ? 1.0 : 0.0;
        return true;
    }

    bool trace(const CompiledOp& op)
    {
        const auto* asked = object(op);
        if (!asked) return false;
        top_ -= 3;
        const auto answer = context_.hooks.trace(*asked, at3(top_ - 3), glm::normalize(at3(top_)));
        if (!answer) return false;
        normal_ = answer->hit ? answer->normal : glm::dvec3(0.0);
        put3(top_ - 3, answer->hit ? answer->point : glm::dvec3(0.0));
        return true;
    }

    bool store_normal(const CompiledOp& op)
    {
        Value* value = context_.symbols.find(op.name);
        Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
        if (!tuple || tuple->count != 3) return false;
        *tuple = Tuple::of(normal_);
        return true;
    }

    const CompiledExpression& expression_;
    const CompiledContext& context_;
    RandomUndo random_;
    double stack_[64];        // not cleared: a list writes before it reads
    double* top_ = stack_;    // the first free place
    glm::dvec3 normal_{0.0};  // that the last trace() found
};

}  // namespace

bool run_compiled(const CompiledExpression& expression, const CompiledContext& context, double* result)
{
    return Run(expression, context).all(result);
}

}  // namespace parser
