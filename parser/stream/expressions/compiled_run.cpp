#include "parser/stream/values/compiled.h"

#include "function/points/evaluate.h"
#include "function/spline.h"
#include "parser/stream/values/elements.h"
#include "parser/stream/hooks.h"
#include "parser/stream/expressions/compiled_functions.h"
#include "parser/stream/expressions/operand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parser {
namespace {

using Code = CompiledOp::Code;

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
    if (!held) return false;
    const std::size_t index = element_index(**held, subscripts, op.a);
    if (index == kNoElement) return false;
    const Tuple* element = (*held)->elements[index].get_if<Tuple>();
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

/// A list at work on a stack.
class Run {
public:
    Run(const CompiledExpression& expression, const CompiledContext& context, double* top)
        : expression_(expression), context_(context), top_(top)
    {}

    bool all()
    {
        for (const CompiledOp& op : expression_.ops)
            if (!step(op)) return context_.random.give_up();
        return true;
    }

    /// One operation; first those that most lists are made of.
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
        case Code::Random: return context_.random.draw(top_[-1], top_[-1]);
        default: return shape(op) || function(op);
        }
    }

private:
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
        case Code::Curve: return curve(op);
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

    bool curve(const CompiledOp& op)
    {
        const Value* value = context_.symbols.find(op.name);
        const auto* held = value ? value->get_if<std::shared_ptr<const function::Spline>>() : nullptr;
        if (!held || (*held)->components() != op.b) return false;
        const function::Spline& spline = **held;
        const bool own = op.a == CompiledOp::kOwnKind;
        const auto at = spline.at(top_[-1], own ? spline.kind : static_cast<function::Spline::Kind>(op.a));
        --top_;
        for (std::size_t i = 0; i < op.b; ++i) *top_++ = at[i];
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
    double* top_;             // the first free place
    glm::dvec3 normal_{0.0};  // that the last trace() found
};

}  // namespace

bool run_compiled(const CompiledExpression& expression, const CompiledContext& context, double* result)
{
    if (const CompiledOp& only = expression.ops.front();
        expression.ops.size() == 1 && only.code == CompiledOp::Code::Constant && expression.count == 1) {
        result[0] = only.number;
        return true;
    }
    double stack[64];  // not cleared: a list writes before it reads
    context.random.keep();
    if (!Run(expression, context, stack).all()) return false;
    result[0] = stack[0];
    for (int i = 1; i < expression.count; ++i) result[i] = stack[i];
    return true;
}

bool run_operation(const CompiledExpression& expression, const CompiledOp& op, const CompiledContext& context,
                   double* top)
{
    return Run(expression, context, top).step(op);
}

}  // namespace parser
