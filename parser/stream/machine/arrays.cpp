#include "parser/stream/machine/operands.h"
#include "parser/stream/expression.h"
#include "parser/stream/expressions/operand.h"

#include <array>
#include <cmath>

/// Elements of arrays, and arrays as a whole.
namespace parser::blocks {
namespace {

constexpr double kMostElementsHere = 1'000'000;  // a larger array is made by the reader of tokens

template <Operand S>
const Op* load_element(const Op* op, Machine& m)
{
    const double* const at = fetch<S>(op, op->b, m);
    if (S == Operand::Slot && !at) return m.missing(op, op->b);
    const Value* const element = element_at(held_array(m, op->a), at, 1);
    const Tuple* const tuple = element ? element->get_if<Tuple>() : nullptr;
    if (!tuple || tuple->count != 1) return m.leave(op);
    m.registers[op->to] = tuple->at[0];
    return op + 1;
}

template <Operand S, Operand T>
const Op* load_element2(const Op* op, Machine& m)
{
    const auto last = static_cast<std::uint32_t>(op->jump);
    const double* const first = fetch<S>(op, op->b, m);
    if (S == Operand::Slot && !first) return m.missing(op, op->b);
    const double* const second = fetch<T>(op, last, m);
    if (T == Operand::Slot && !second) return m.missing(op, last);
    const double at[2] = {*first, *second};
    const Value* const element = element_at(held_array(m, op->a), at, 2);
    const Tuple* const tuple = element ? element->get_if<Tuple>() : nullptr;
    if (!tuple || tuple->count != 1) return m.leave(op);
    m.registers[op->to] = tuple->at[0];
    return op + 1;
}

const Op* load_elements(const Op* op, Machine& m)
{
    double* const at = m.registers + op->to;
    const Value* const element = element_at(held_array(m, op->a), at, op->b);
    const Tuple* const tuple = element ? element->get_if<Tuple>() : nullptr;
    if (!tuple || tuple->count != op->jump) return m.leave(op);
    for (int i = 0; i < op->jump; ++i) at[i] = tuple->at[static_cast<std::size_t>(i)];
    return op + 1;
}

std::uint32_t kind_of_components(int count) { return kind_of(Value(Tuple{{}, count})); }

template <Operand S, Operand V>
const Op* store_element(const Op* op, Machine& m)
{
    const double* const at = fetch<S>(op, op->b, m);
    if (S == Operand::Slot && !at) return m.missing(op, op->b);
    const double* const value = fetch<V>(op, op->to, m);
    if (V == Operand::Slot && !value) return m.missing(op, op->to);
    static const std::uint32_t kNumber = kind_of_components(1);
    const std::shared_ptr<Array>* const array = held_array(m, op->a);
    Value* const element = element_at(array, at, 1);
    if (!element || !takes(**array, kNumber)) return m.leave(op);
    note_element(m, *array, element);
    if (Tuple* const tuple = element->get_if<Tuple>()) *tuple = Tuple::of(*value);
    else *element = Tuple::of(*value);
    return op + 1;
}

const Op* store_elements(const Op* op, Machine& m)
{
    const double* const at = m.registers + op->b;
    const std::shared_ptr<Array>* const array = held_array(m, op->a);
    Value* const element = element_at(array, at, op->to);
    if (!element || !takes(**array, kind_of_components(op->jump))) return m.leave(op);
    Tuple made;
    made.count = op->jump;
    for (std::size_t i = 0; i < static_cast<std::size_t>(op->jump); ++i) made.at[i] = at[op->to + i];
    note_element(m, *array, element);
    *element = made.stored();
    return op + 1;
}

const Op* make_array(const Op* op, Machine& m)
{
    auto array = std::make_shared<Array>();
    double elements = 1;
    for (std::uint32_t i = 0; i < op->to; ++i) {
        const double size = std::floor(m.registers[op->b + i] + kSubscriptSlack);
        elements *= size;
        if (!(size >= 1.0 && elements <= kMostElementsHere)) return m.leave(op);
        array->sizes.push_back(static_cast<std::uint32_t>(size));
    }
    Value* const to = m.value_to_store(op->a, op->jump != 0);
    if (!to) return m.leave(op);
    array->elements.resize(static_cast<std::size_t>(elements));
    *to = std::move(array);
    return op + 1;
}

const Op* copy_array(const Op* op, Machine& m)
{
    const Value* const from = m.value_of(op->a);
    if (!from || !from->get_if<std::shared_ptr<Array>>()) return m.leave(op);
    Value copy = deep_copy(*from);
    Value* const to = m.value_to_store(op->to, op->jump != 0);
    if (!to) return m.leave(op);
    *to = std::move(copy);
    return op + 1;
}

/// Register `to` becomes the size of the dimension that it names, or (b = 0) the number of dimensions.
const Op* dimension_size(const Op* op, Machine& m)
{
    const std::shared_ptr<Array>* const held = held_array(m, op->a);
    if (!held) return m.leave(op);
    const Array& array = **held;
    double& to = m.registers[op->to];
    to = op->b == 0 ? static_cast<double>(array.sizes.size()) : size_of_dimension(array, to);
    return op + 1;
}

constexpr Operand R = Operand::Register, S = Operand::Slot, C = Operand::Constant;

}  // namespace

Handler element_handler(Operand subscript)
{
    static constexpr std::array<Handler, 3> kAll = {load_element<R>, load_element<S>, load_element<C>};
    return kAll[static_cast<std::size_t>(subscript)];
}

Handler element2_handler(Operand first, Operand second)
{
    static constexpr std::array<Handler, 9> kAll = {load_element2<R, R>, load_element2<R, S>, load_element2<R, C>,
                                                    load_element2<S, R>, load_element2<S, S>, load_element2<S, C>,
                                                    load_element2<C, R>, load_element2<C, S>, load_element2<C, C>};
    return kAll[static_cast<std::size_t>(first) * 3 + static_cast<std::size_t>(second)];
}

Handler store_element_handler(Operand subscript, Operand value)
{
    static constexpr std::array<Handler, 9> kAll = {store_element<R, R>, store_element<R, S>, store_element<R, C>,
                                                    store_element<S, R>, store_element<S, S>, store_element<S, C>,
                                                    store_element<C, R>, store_element<C, S>, store_element<C, C>};
    return kAll[static_cast<std::size_t>(subscript) * 3 + static_cast<std::size_t>(value)];
}

const Handler kElement = load_elements;
const Handler kStoreElement = store_elements;
const Handler kMakeArray = make_array;
const Handler kCopyArray = copy_array;
const Handler kDimensionSize = dimension_size;

}  // namespace parser::blocks
