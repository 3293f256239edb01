#include "parser/stream/machine/machine.h"

#include <algorithm>

namespace parser::blocks {
namespace {

/// Components of a value that is a tuple of `kind` components.
double* numbers_of(Value* value, std::uint8_t kind)
{
    Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
    return tuple && tuple->count == kind ? tuple->at.data() : nullptr;
}

}  // namespace

void Machine::enter(const Program& entered, std::uint32_t scope)
{
    frames.clear();
    frames.push_back({&entered, nullptr, 0, 0, nullptr, scope, calls});
    program = &entered;
    resolve();
}

void Machine::push(const Program& entered, const Call& call, const Op* back)
{
    const Frame& caller = frames.back();
    frames.push_back({&entered, back, caller.slots + caller.program->slots.size(),
                      caller.registers + caller.program->registers, &call, symbols.depth(), calls});
    program = &entered;
    resolve();
}

void Machine::pop()
{
    frames.pop_back();
    const Frame& back = frames.back();
    program = back.program;
    slots = slot_stack_.data() + back.slots;
    registers = register_stack_.data() + back.registers;
}

void Machine::note(std::uint32_t slot)
{
    if (Cell cell = symbols.find_cell(info(slot).name)) {
        Value old = *cell;
        notes.push_back({std::move(cell), std::move(old)});
    }
}

void Machine::undo_changes()
{
    for (; !notes.empty(); notes.pop_back()) *notes.back().cell = std::move(notes.back().old);
    random.give_up();
}

void Machine::undo_values()
{
    std::size_t first = 1;
    while (!frames[first].call->value) ++first;
    stopped = frames[first].back - 1;
    calls = frames[first].calls;
    while (frames.size() > first) {
        symbols.close_scope();
        pop();
    }
    values = 0;
}

void Machine::resolve()
{
    const Frame& entered = frames.back();
    const std::size_t slots_needed = entered.slots + program->slots.size(),
                      registers_needed = entered.registers + program->registers;
    if (slot_stack_.size() < slots_needed) slot_stack_.resize(std::max(slots_needed, 2 * slot_stack_.size()));
    if (register_stack_.size() < registers_needed)
        register_stack_.resize(std::max(registers_needed, 2 * register_stack_.size()));
    slots = slot_stack_.data() + entered.slots;
    registers = register_stack_.data() + entered.registers;
    for (std::size_t i = 0; i < program->slots.size(); ++i) {
        const SlotInfo& wanted = program->slots[i];
        Value* const value = symbols.find(wanted.name);
        slots[i] = {numbers_of(value, wanted.kind), nullptr, value, false};
    }
}

const Op* Machine::missing(const Op* op, std::uint32_t slot)
{
    const SlotInfo& wanted = info(slot);
    slots[slot].numbers = numbers_of(symbols.find(wanted.name), wanted.kind);
    return slots[slot].numbers ? op : leave(op);
}

/// Only the outermost frame can tell which of its slots lie in the cell.
bool Machine::may_turn(const Value& value) const
{
    return frames.size() == 1 && values == 0 && value.get_if<Tuple>() != nullptr;
}

/// The value becomes a tuple of zeros. Slots that lie in it mean nothing until they are looked up again.
void Machine::turn(Value& value, std::uint8_t count)
{
    if (const Tuple* const old = value.get_if<Tuple>())
        for (std::size_t i = 0; i < program->slots.size(); ++i)
            if (slots[i].numbers == old->at.data() || slots[i].own == old->at.data()) slots[i] = {};
    Tuple zero;
    zero.count = count;
    value = zero;
}

/// Slots of the same name with another number of components: it may have another cell now.
void Machine::forget_others(std::uint32_t slot)
{
    for (std::uint32_t i = 0; i < program->slots.size(); ++i)
        if (i != slot && info(i).name == info(slot).name) slots[i] = {};
}

double* Machine::place_to_store(std::uint32_t slot, bool local, bool turns)
{
    const SlotInfo& wanted = info(slot);
    const auto fits = [&](Value* value) {
        return !value->set() || numbers_of(value, wanted.kind) || (turns && may_turn(*value));
    };
    Value* value = nullptr;
    if (local) {
        value = symbols.in_current_scope(wanted.name) ? symbols.find(wanted.name) : nullptr;
        if (value && !fits(value)) return nullptr;
        if (value && values != 0) note(slot);
        if (!value) value = symbols.local(wanted.name, frame().scope).get();
    } else {
        value = symbols.find(wanted.name);
        if (value && !fits(value)) return nullptr;
        if (!value) value = symbols.declare(wanted.name).get();
        if (values != 0) note(slot);
    }
    if (!numbers_of(value, wanted.kind)) turn(*value, wanted.kind);
    if (program->turning) forget_others(slot);
    double* const numbers = numbers_of(value, wanted.kind);
    slots[slot] = {numbers, local ? numbers : slots[slot].own, value, local};
    return numbers;
}

Value* Machine::value_to_store(std::uint32_t slot, bool local)
{
    const SlotInfo& wanted = info(slot);
    const auto fits = [&](const Value& value) {
        return !value.set() || (wanted.kind == kText ? value.get_if<std::string>() != nullptr
                                                     : value.get_if<std::shared_ptr<Array>>() != nullptr);
    };
    if (local && !slots[slot].own_value) {
        Value* const old = symbols.in_current_scope(wanted.name) ? symbols.find(wanted.name) : nullptr;
        if (old && !fits(*old)) return nullptr;
        if (old && values != 0) note(slot);
        slots[slot].value = old ? old : symbols.local(wanted.name, frame().scope).get();
        slots[slot].own_value = true;
    } else if (!local) {
        if (!value_of(slot)) slots[slot].value = symbols.declare(wanted.name).get();
        if (values != 0) note(slot);
    }
    return fits(*slots[slot].value) ? slots[slot].value : nullptr;
}

}  // namespace parser::blocks
