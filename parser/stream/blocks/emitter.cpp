#include "parser/stream/blocks/emitter.h"

#include <algorithm>

namespace parser::blocks {
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

bool Emitter::load(std::uint32_t name, std::uint8_t count)
{
    const std::uint32_t from = slot(name, count);
    if (from == kNoIndex) return false;
    if (count == 1) return push({Operand::Slot, from, 0}), true;
    Op& made = emit(kLoadTuple);
    made.to = depth();
    made.a = from;
    made.b = count;
    push_registers(count);
    return true;
}

void Emitter::select(std::uint32_t count, std::uint32_t index)
{
    const std::uint32_t first = depth() - count;
    Op* const last = size() > 0 ? &program_.ops.back() : nullptr;
    if (last && last->run == kLoadTuple && last->to == first && last->b == count) {
        last->run = kLoadComponent;
        last->b = index;
        drop(count);
        push_register();
    } else {
        in_place(kSelect, count, 1).b = index;
    }
}

void Emitter::binary(Binary f)
{
    Entry b = pop(), a = pop();
    if (a.where == Operand::Constant && b.where == Operand::Constant) {
        if (f == Binary::Add) return constant(a.number + b.number);
        if (f == Binary::Subtract) return constant(a.number - b.number);
        if (f == Binary::Multiply) return constant(a.number * b.number);
        register_of(a, depth());
    }
    last_ = {size(), f, a.where, b.where};
    Op& op = emit(binary_handler(f, a.where, b.where, Target::Register));
    op.to = depth();
    op.a = a.index;
    op.b = b.index;
    op.number = a.where == Operand::Constant ? a.number : b.number;
    push_register();
}

void Emitter::function(Kind f)
{
    const Entry operand = pop();
    Op& op = emit(function_handler(f, operand.where));
    op.to = depth();
    op.a = operand.index;
    op.number = operand.number;
    push_register();
}

void Emitter::negate(std::uint32_t count)
{
    if (count > 1) each_in_place(kNegateTuple, count);
    else if (stack_.back().where == Operand::Constant) stack_.back().number = -stack_.back().number;
    else function(Kind::Minus);
}

void Emitter::splat(std::uint32_t count)
{
    const Entry top = stack_.back();
    if (top.where == Operand::Register) {
        in_place(kSplat, 1, count).b = count;
        return;
    }
    for (std::uint32_t i = 1; i < count; ++i) push(top);
}

int Emitter::combine(Binary f, int left, int right)
{
    const int count = std::max(left, right);
    if (count == 1) {
        binary(f);
    } else {
        Op& op = in_place(combine_handler(f), static_cast<std::size_t>(left + right), static_cast<std::size_t>(count));
        op.a = static_cast<std::uint32_t>(left);
        op.b = static_cast<std::uint32_t>(right);
    }
    return count;
}

Op& Emitter::in_place(Handler run, std::size_t takes, std::size_t gives)
{
    const std::uint32_t first = in_registers(takes);
    drop(takes);
    push_registers(gives);
    Op& op = emit(run);
    op.to = first;
    return op;
}

void Emitter::call_function(std::uint32_t name, const function::FunctionPtr& called)
{
    Op& op = in_place(kCallFunction, called->parameters, called->components);
    op.a = name;
    op.b = static_cast<std::uint32_t>(program_.functions.size());
    program_.functions.push_back(called);
}

bool Emitter::trace(std::uint32_t object, std::uint32_t normal)
{
    const std::uint32_t stored = normal == kNoIndex ? kNoIndex : slot(normal, 3);
    if (normal != kNoIndex && stored == kNoIndex) return false;
    Op& op = in_place(kTrace, 6, 3);
    op.a = object;
    op.b = stored;
    return true;
}

bool Emitter::stores_before_end(std::uint32_t first) const
{
    for (std::uint32_t i = first; i + 1 < size(); ++i)
        if (program_.ops[i].run == kTrace && program_.ops[i].b != kNoIndex) return true;
    return false;
}

bool Emitter::element(std::uint32_t name, std::size_t dimensions, std::size_t count)
{
    const std::uint32_t from = slot(name, kArray);
    if (from == kNoIndex) return false;
    if (count == 1 && dimensions == 1) {
        const Entry at = pop();
        Op& made = emit(element_handler(at.where));
        made.to = depth();
        made.a = from;
        made.b = at.index;
        made.number = at.number;
        push_register();
    } else if (count == 1 && dimensions == 2) {
        Entry second = pop(), first = pop();
        if (first.where == Operand::Constant && second.where == Operand::Constant) register_of(first, depth());
        Op& made = emit(element2_handler(first.where, second.where));
        made.to = depth();
        made.a = from;
        made.b = first.index;
        made.jump = static_cast<std::int32_t>(second.index);
        made.number = first.where == Operand::Constant ? first.number : second.number;
        push_register();
    } else {
        Op& made = in_place(kElement, dimensions, count);
        made.a = from;
        made.b = static_cast<std::uint32_t>(dimensions);
        made.jump = static_cast<std::int32_t>(count);
    }
    return true;
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
