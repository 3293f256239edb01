#include "parser/stream/compiled.h"

#include "function/evaluate.h"
#include "parser/stream/operand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parser {
namespace {

using Code = CompiledOp::Code;
constexpr double kDegree = 0.01745329251994329576;
constexpr double kSubscriptSlack = 1e-10;

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
    struct Old { std::int32_t index; std::uint32_t state; };
    std::vector<std::uint32_t>& streams_;
    Old old_[8];
    std::size_t used_ = 0;
};

/// False where the reader of tokens has something to say.
bool function_of_one(Kind kind, double& a)
{
    switch (kind) {
    case Kind::Abs: a = std::abs(a); return true;
    case Kind::Acos: if (!(a >= -1.0 && a <= 1.0)) return false; a = std::acos(a); return true;
    case Kind::Asin: if (!(a >= -1.0 && a <= 1.0)) return false; a = std::asin(a); return true;
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
    case Kind::Ln: if (!(a > 0.0)) return false; a = std::log(a); return true;
    case Kind::Log: if (!(a > 0.0)) return false; a = std::log10(a); return true;
    case Kind::Radians: a = a * kDegree; return true;
    case Kind::Sin: a = std::sin(a); return true;
    case Kind::Sqrt: if (!(a >= 0.0)) return false; a = std::sqrt(a); return true;
    default: a = std::tan(a); return true;
    }
}

bool function_of_two(Kind kind, double& a, double b)
{
    switch (kind) {
    case Kind::Atan2: if (std::abs(a) <= kSame && std::abs(b) <= kSame) return false; a = std::atan2(a, b); return true;
    case Kind::Div: a = to_int32(a / b); return true;
    case Kind::Mod: a = std::fmod(a, b); return true;
    default: if (a == 0.0 && b == 0.0) return false; a = std::pow(a, b); return true;
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

}  // namespace

bool run_compiled(const CompiledExpression& expression, const CompiledContext& context, double* result)
{
    double stack[64];
    double* top = stack;  // the first free place
    RandomUndo random(context.random_streams);
    for (const CompiledOp& op : expression.ops) {
        switch (op.code) {
        case Code::Constant: *top++ = op.number; break;
        case Code::Load: {
            const Value* value = context.symbols.find_known(op.name);
            const Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
            if (!tuple || tuple->count != 1) return random.give_up();
            *top++ = tuple->at[0];
            break;
        }
        case Code::LoadTuple: {
            const Value* value = context.symbols.find_known(op.name);
            const Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
            if (!tuple || tuple->count != op.a) return random.give_up();
            for (std::size_t i = 0; i < op.a; ++i) *top++ = tuple->at[i];
            break;
        }
        case Code::Element:
            if (!load_element(op, context.symbols, top - op.a)) return random.give_up();
            top += op.b - op.a;
            break;
        case Code::Splat:
            for (int i = 1; i < op.a; ++i, ++top) *top = top[-1];
            break;
        case Code::Select: {
            const double chosen = top[op.b - op.a];
            top -= op.a - 1;
            top[-1] = chosen;
            break;
        }
        case Code::Gray: {
            top -= op.a - 1;
            top[-1] = 0.297 * top[-1] + 0.589 * top[0] + 0.114 * top[1];
            break;
        }
        case Code::Negate:
            for (int i = 1; i <= op.a; ++i) top[-i] = -top[-i];
            break;
        case Code::Not:
            for (int i = 1; i <= op.a; ++i) top[-i] = truth(top[-i]) ? 0.0 : 1.0;
            break;
        case Code::Add: --top; top[-1] += top[0]; break;
        case Code::Subtract: --top; top[-1] -= top[0]; break;
        case Code::Multiply: --top; top[-1] *= top[0]; break;
        case Code::Divide:
            --top;
            if (top[0] == 0.0) return random.give_up();
            top[-1] /= top[0];
            break;
        case Code::AddTuple:
            if (op.a != op.b) {
                if (!combine_at(op, top)) return random.give_up();
                break;
            }
            top -= op.b;
            for (int i = 0; i < op.a; ++i) top[i - op.a] += top[i];
            break;
        case Code::SubtractTuple:
            if (op.a != op.b) {
                if (!combine_at(op, top)) return random.give_up();
                break;
            }
            top -= op.b;
            for (int i = 0; i < op.a; ++i) top[i - op.a] -= top[i];
            break;
        case Code::MultiplyTuple:
        case Code::DivideTuple:
            if (!combine_at(op, top)) return random.give_up();
            break;
        case Code::AddNumber: top[-1] += op.number; break;
        case Code::MultiplyNumber: top[-1] *= op.number; break;
        case Code::Relation: --top; top[-1] = relation_holds(op.kind, top[-1], top[0]) ? 1.0 : 0.0; break;
        case Code::And: --top; top[-1] = truth(top[-1]) && truth(top[0]) ? 1.0 : 0.0; break;
        case Code::Or: --top; top[-1] = truth(top[-1]) || truth(top[0]) ? 1.0 : 0.0; break;
        case Code::Choose: top -= 2; top[-1] = truth(top[-1]) ? top[0] : top[1]; break;
        case Code::Function1: if (!function_of_one(op.kind, top[-1])) return random.give_up(); break;
        case Code::Function2: --top; if (!function_of_two(op.kind, top[-1], top[0])) return random.give_up(); break;
        case Code::Min: --top; top[-1] = top[0] < top[-1] ? top[0] : top[-1]; break;
        case Code::Max: --top; top[-1] = top[-1] < top[0] ? top[0] : top[-1]; break;
        case Code::Choose3: top -= 2; top[-1] = top[-1] < 0.0 ? top[0] : top[1]; break;
        case Code::Choose4: top -= 3; top[-1] = top[-1] < 0.0 ? top[0] : top[-1] == 0.0 ? top[1] : top[2]; break;
        case Code::Length: top -= 2; top[-1] = glm::length(at3(top - 1)); break;
        case Code::Dot: top -= 5; top[-1] = glm::dot(at3(top - 1), at3(top + 2)); break;
        case Code::Cross: top -= 3; put3(top - 3, glm::cross(at3(top - 3), at3(top))); break;
        case Code::Normalize: {
            const double length = glm::length(at3(top - 3));
            if (!(length != 0.0)) return random.give_up();
            put3(top - 3, at3(top - 3) / length);
            break;
        }
        case Code::Rotate: top -= 3; put3(top - 3, rotated(at3(top - 3), at3(top))); break;
        case Code::Call:
            if (!call(op, expression, context.symbols, top - op.a)) return random.give_up();
            top += static_cast<int>(expression.functions[op.b]->components) - op.a;
            break;
        case Code::Random: if (!random.draw(top[-1], top[-1])) return random.give_up(); break;
        }
    }
    result[0] = stack[0];
    for (int i = 1; i < expression.count; ++i) result[i] = stack[i];
    return true;
}

}  // namespace parser
