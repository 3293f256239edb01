#include "parser/stream/blocks/emitter.h"

#include <algorithm>
#include <utility>

namespace parser::blocks {
namespace {

using Code = CompiledOp::Code;

std::optional<Binary> relation_of(Kind kind)
{
    switch (kind) {
    case Kind::Less: return Binary::Less;
    case Kind::LessEqual: return Binary::LessEqual;
    case Kind::Greater: return Binary::Greater;
    case Kind::GreaterEqual: return Binary::GreaterEqual;
    case Kind::Equal: return Binary::Equal;
    case Kind::NotEqual: return Binary::NotEqual;
    default: return std::nullopt;
    }
}

std::optional<Binary> binary_of(const CompiledOp& op)
{
    switch (op.code) {
    case Code::Add: return Binary::Add;
    case Code::Subtract: return Binary::Subtract;
    case Code::Multiply: return Binary::Multiply;
    case Code::Divide: return Binary::Divide;
    case Code::And: return Binary::And;
    case Code::Or: return Binary::Or;
    case Code::Min: return Binary::Min;
    case Code::Max: return Binary::Max;
    case Code::Relation: return relation_of(op.kind);
    case Code::Function2:
        switch (op.kind) {
        case Kind::Mod: return Binary::Modulo;
        case Kind::Pow: return Binary::Power;
        case Kind::Div: return Binary::IntDivide;
        default: return Binary::Atan2;
        }
    default: return std::nullopt;
    }
}

}  // namespace

std::uint32_t Emitter::slot(std::uint32_t name, std::uint8_t kind)
{
    const auto tuple = [](std::uint8_t one) { return one >= kFloat && one < kText; };
    for (std::uint32_t i = 0; i < program_.slots.size(); ++i) {
        const SlotInfo& known = program_.slots[i];
        if (known.name != name) continue;
        if (known.kind == kind || kind == kAny) return i;
        if (known.kind == kAny) continue;
        if (!turning_ || !tuple(known.kind) || !tuple(kind)) return kNoIndex;
        program_.turning = true;
    }
    program_.slots.push_back({name, kind});
    return static_cast<std::uint32_t>(program_.slots.size() - 1);
}

Op& Emitter::emit(Handler run)
{
    Op& made = program_.ops.emplace_back();
    made.run = run;
    return made;
}

void Emitter::register_of(Entry& entry, std::uint32_t to)
{
    if (entry.where == Operand::Register) return;
    Op& op = emit(move_handler(entry.where, Target::Register));
    op.to = to;
    op.a = entry.index;
    op.number = entry.number;
    entry = {Operand::Register, to, 0};
}

std::uint32_t Emitter::in_registers(std::size_t count)
{
    const std::uint32_t first = depth() - static_cast<std::uint32_t>(count);
    for (std::uint32_t i = first; i < depth(); ++i) register_of(stack_[i], i);
    return first;
}

bool Emitter::expression(CompiledExpression&& read)
{
    const auto index = static_cast<std::uint32_t>(program_.expressions.size());
    program_.expressions.push_back(std::move(read));
    const CompiledExpression& kept = program_.expressions.back();
    for (std::size_t i = 0; i < kept.ops.size(); ++i)
        if (!operation(kept, i, index)) return false;
    return true;
}

bool Emitter::binary(Binary f)
{
    Entry b = pop(), a = pop();
    if (a.where == Operand::Constant && b.where == Operand::Constant) {
        const bool folds = f == Binary::Add || f == Binary::Subtract || f == Binary::Multiply;
        if (folds) {
            const double number = f == Binary::Add        ? a.number + b.number
                                  : f == Binary::Subtract ? a.number - b.number
                                                          : a.number * b.number;
            stack_.push_back({Operand::Constant, 0, number});
            return true;
        }
        register_of(a, depth());
    }
    last_ = {size(), f, a.where, b.where};
    Op& op = emit(binary_handler(f, a.where, b.where, Target::Register));
    op.to = depth();
    op.a = a.index;
    op.b = b.index;
    op.number = a.where == Operand::Constant ? a.number : b.number;
    push_register();
    return true;
}

void Emitter::unary(Handler run, const Entry& operand)
{
    Op& op = emit(run);
    op.to = depth();
    op.a = operand.index;
    op.number = operand.number;
    push_register();
}

bool Emitter::borrow(std::uint32_t expression, std::size_t at, std::size_t takes, std::size_t gives)
{
    in_registers(takes);
    Op& op = emit(kBorrowed);
    op.to = depth();
    op.a = expression;
    op.b = static_cast<std::uint32_t>(at);
    drop(takes);
    push_registers(gives);
    return true;
}

bool Emitter::in_place(Handler run, std::size_t takes, std::size_t gives, std::uint32_t b)
{
    const std::uint32_t first = in_registers(takes);
    Op& op = emit(run);
    op.to = first;
    op.b = b;
    drop(takes);
    push_registers(gives);
    return true;
}

bool Emitter::trace(std::uint32_t object, std::uint32_t normal)
{
    const std::uint32_t to = slot(normal, 3);
    if (to == kNoIndex) return false;
    const std::uint32_t first = in_registers(6);
    Op& op = emit(kTrace);
    op.to = first;
    op.a = object;
    op.b = to;
    drop(3);
    return true;
}

bool Emitter::load_tuple(const CompiledExpression& read, std::size_t& at)
{
    const CompiledOp& op = read.ops[at];
    const std::uint32_t from = slot(op.name, op.a);
    if (from == kNoIndex) return false;
    const CompiledOp* const next = at + 1 < read.ops.size() ? &read.ops[at + 1] : nullptr;
    const bool one = next && next->code == Code::Select && next->a == op.a;
    Op& made = emit(one ? kLoadComponent : kLoadTuple);
    made.to = depth();
    made.a = from;
    made.b = one ? next->b : op.a;
    push_registers(one ? 1 : op.a);
    at += one ? 1 : 0;
    return true;
}

bool Emitter::element(const CompiledOp& op)
{
    const std::uint32_t from = slot(op.name, kArray);
    if (from == kNoIndex) return false;
    if (op.b == 1 && op.a == 1) {
        const Entry at = pop();
        Op& made = emit(element_handler(at.where));
        made.to = depth();
        made.a = from;
        made.b = at.index;
        made.number = at.number;
    } else if (op.b == 1 && op.a == 2) {
        Entry second = pop(), first = pop();
        if (first.where == Operand::Constant && second.where == Operand::Constant) register_of(first, depth());
        Op& made = emit(element2_handler(first.where, second.where));
        made.to = depth();
        made.a = from;
        made.b = first.index;
        made.jump = static_cast<std::int32_t>(second.index);
        made.number = first.where == Operand::Constant ? first.number : second.number;
    } else {
        const std::uint32_t first = in_registers(op.a);
        Op& made = emit(kElement);
        made.to = first;
        made.a = from;
        made.b = op.a;
        made.jump = op.b;
        drop(op.a);
    }
    push_registers(op.b);
    return true;
}

bool Emitter::operation(const CompiledExpression& read, std::size_t& at, std::uint32_t expression)
{
    const CompiledOp& op = read.ops[at];
    if (const auto f = binary_of(op)) return binary(*f);
    switch (op.code) {
    case Code::Constant: stack_.push_back({Operand::Constant, 0, op.number}); return true;
    case Code::Load: {
        const std::uint32_t from = slot(op.name, kFloat);
        stack_.push_back({Operand::Slot, from, 0});
        return from != kNoIndex;
    }
    case Code::LoadTuple: return load_tuple(read, at);
    case Code::Element: return element(op);
    case Code::AddNumber:
    case Code::MultiplyNumber:
        stack_.push_back({Operand::Constant, 0, op.number});
        return binary(op.code == Code::AddNumber ? Binary::Add : Binary::Multiply);
    case Code::Function1: {
        const Handler run = function_handler(op.kind, stack_.back().where);
        if (!run) return borrow(expression, at, 1, 1);
        return unary(run, pop()), true;
    }
    case Code::Random: {
        const Entry stream = pop();
        return unary(random_handler(stream.where), stream), true;
    }
    case Code::Negate:
        if (op.a != 1) return borrow(expression, at, op.a, op.a);
        if (stack_.back().where == Operand::Constant) {
            stack_.back().number = -stack_.back().number;
            return true;
        } else {
            const Entry operand = pop();
            return unary(negate_handler(operand.where), operand), true;
        }
    case Code::Splat:
        if (stack_.back().where == Operand::Register) return in_place(kSplat, 1, op.a, op.a);
        for (std::uint8_t i = 1; i < op.a; ++i) stack_.push_back(Entry(stack_.back()));
        return true;
    case Code::MacroCall: return macro_call(read.calls[op.name], op.a);
    case Code::Trace:
        if (at + 1 == read.ops.size() || read.ops[at + 1].code != Code::StoreNormal)
            return borrow(expression, at, 6, 3);
        return trace(op.name, read.ops[++at].name);
    default: return op.code >= Code::TextConstant ? text_operation(op) : tuples(op, expression, at);
    }
}

bool Emitter::tuples(const CompiledOp& op, std::uint32_t expression, std::size_t at)
{
    const bool scales = (op.code == Code::MultiplyTuple || op.code == Code::DivideTuple) && op.b == 1;
    const bool sums = (op.code == Code::AddTuple || op.code == Code::SubtractTuple) && op.a == op.b;
    switch (op.code) {
    case Code::AddTuple:
    case Code::SubtractTuple:
    case Code::MultiplyTuple:
    case Code::DivideTuple: {
        if (op.code == Code::MultiplyTuple && op.a == op.b) return in_place(kMultiplyTuple, 2u * op.b, op.b, op.b);
        if (op.code == Code::MultiplyTuple && op.a == 1) return in_place(kScaledTuple, 1u + op.b, op.b, op.b);
        if (!scales && !sums) return borrow(expression, at, op.a + op.b, std::max(op.a, op.b));
        const std::uint32_t first = in_registers(op.a + op.b);
        Op& made = emit(op.code == Code::AddTuple        ? kAddTuple
                        : op.code == Code::SubtractTuple ? kSubtractTuple
                        : op.code == Code::MultiplyTuple ? kScaleTuple
                                                         : kDivideTuple);
        made.to = first;
        made.a = first + op.a;
        made.b = op.a;
        drop(op.b);
        return true;
    }
    case Code::Select: return borrow(expression, at, op.a, 1);
    case Code::Gray: return borrow(expression, at, op.a, 1);
    case Code::Not: return borrow(expression, at, op.a, op.a);
    case Code::Choose:
    case Code::Choose3: return borrow(expression, at, 3, 1);
    case Code::Choose4: return borrow(expression, at, 4, 1);
    case Code::Length: return in_place(kLength, 3, 1, 0);
    case Code::Dot: return in_place(kDot, 6, 1, 0);
    case Code::Inside: return borrow(expression, at, 3, 1);
    case Code::Cross:
    case Code::Rotate: return borrow(expression, at, 6, 3);
    case Code::Normalize: return borrow(expression, at, 3, 3);
    case Code::Curve: return borrow(expression, at, 1, op.b);
    case Code::Call: return borrow(expression, at, op.a, program_.expressions[expression].functions[op.b]->components);
    default: return false;
    }
}

void Emitter::store_number(std::uint32_t to, bool local)
{
    const Target target = local ? Target::Local : Target::Declared;
    const Entry top = pop();
    if (top.where == Operand::Register && last_.op + 1 == size() && is_sum(last_.f)) {
        Op& op = program_.ops.back();
        op.run = binary_handler(last_.f, last_.a, last_.b, target);
        op.to = to;
        return;
    }
    Op& op = emit(move_handler(top.where, target));
    op.to = to;
    op.a = top.index;
    op.number = top.number;
}

void Emitter::move_to(std::uint32_t kept)
{
    const Entry top = pop();
    Op& op = emit(move_handler(top.where, Target::Register));
    op.to = kept;
    op.a = top.index;
    op.number = top.number;
}

void Emitter::move_all_to(std::uint32_t kept, std::size_t count, double* constants)
{
    const std::size_t first = stack_.size() - count;
    for (std::uint32_t i = 0; i < count; ++i) {
        const Entry& from = stack_[first + i];
        if (from.where == Operand::Constant) constants[i] = from.number;
        else fill(kept + i, from.where, from.index);
    }
    drop(count);
}

std::uint32_t Emitter::jump_if(bool sense)
{
    const Entry top = pop();
    if (top.where == Operand::Register && last_.op + 1 == size() && is_relation(last_.f)) {
        program_.ops.back().run = relation_jump_handler(last_.f, last_.a, last_.b, sense);
        return size() - 1;
    }
    Op& op = emit(truth_jump_handler(top.where, sense));
    op.a = top.index;
    op.number = top.number;
    return size() - 1;
}

void Emitter::fill(std::uint32_t to, Operand where, std::uint32_t index)
{
    Op& op = emit(move_handler(where, Target::Register));
    op.to = to;
    op.a = index;
}

void Emitter::color(std::size_t count, bool transmits)
{
    constexpr std::uint32_t kFilter = 3, kTransmit = 4, kAll = 5;
    const std::uint32_t first = in_registers(count);
    const bool moves = transmits && count == kTransmit;
    if (moves) fill(first + kTransmit, Operand::Register, first + kFilter);
    for (std::uint32_t i = moves ? kFilter : static_cast<std::uint32_t>(count); i < (moves ? kTransmit : kAll); ++i)
        fill(first + i, Operand::Constant, 0);
    push_registers(kAll - count);
}

void Emitter::store_element(std::uint32_t array, std::size_t dimensions)
{
    if (dimensions == 1) {
        Entry value = pop(), at = pop();
        if (value.where == Operand::Constant && at.where == Operand::Constant) register_of(at, depth());
        Op& op = emit(store_element_handler(at.where, value.where));
        op.a = array;
        op.b = at.index;
        op.to = value.index;
        op.number = at.where == Operand::Constant ? at.number : value.number;
        return;
    }
    const std::uint32_t first = in_registers(dimensions + 1);
    Op& op = emit(kStoreElement);
    op.a = array;
    op.b = first;
    op.to = static_cast<std::uint32_t>(dimensions);
    op.jump = 1;
    drop(dimensions + 1);
}

}  // namespace parser::blocks
