#pragma once

#include "parser/stream/machine/machine.h"
#include "parser/stream/machine/operations.h"
#include "parser/stream/values/elements.h"

/// Where operations find what they work on.
namespace parser::blocks {

/// Null: the slot's name means no number, Machine::missing() has to look at it.
template <Operand where>
const double* fetch(const Op* op, std::uint32_t operand, const Machine& m)
{
    if constexpr (where == Operand::Register) return m.registers + operand;
    if constexpr (where == Operand::Slot) return m.slots[operand].numbers;
    return &op->number;
}

inline const std::shared_ptr<Array>* held_array(Machine& m, std::uint32_t slot)
{
    Value* const value = m.value_of(slot);
    return value ? value->get_if<std::shared_ptr<Array>>() : nullptr;
}

/// Null: there is no such array, or element_index() knows none.
inline Value* element_at(const std::shared_ptr<Array>* array, const double* subscripts, std::size_t count)
{
    const std::size_t index = array ? element_index(**array, subscripts, count) : kNoElement;
    return index == kNoElement ? nullptr : &(*array)->elements[index];
}

/// Whether a value of that kind may become an element; the first one binds all.
inline bool takes(Array& array, std::uint32_t kind)
{
    if (array.mixed || (array.kind != 0 && array.kind != kind)) return false;
    array.kind = kind;
    return true;
}

/// An element is about to change: a call whose value is wanted may have to put it back.
inline void note_element(Machine& m, const std::shared_ptr<Array>& array, Value* element)
{
    if (m.values != 0) m.note(array, element);
}

}  // namespace parser::blocks
