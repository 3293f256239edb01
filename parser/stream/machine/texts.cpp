#include "parser/stream/machine/operands.h"
#include "parser/stream/expression.h"
#include "parser/stream/expressions/operand.h"
#include "parser/stream/expressions/text_functions.h"
#include "parser/stream/text.h"

#include <cstdlib>

/// Operations on strings.
namespace parser::blocks {
namespace {

const std::string* text_of(Machine& m, std::uint32_t slot)
{
    const Value* const value = m.value_of(slot);
    return value ? value->get_if<std::string>() : nullptr;
}

Value* element_of(Machine& m, const Op* op)
{
    return element_at(held_array(m, op->a), m.registers + op->b, static_cast<std::size_t>(op->jump));
}

const Op* constant(const Op* op, Machine& m)
{
    m.texts[op->to] = m.program->texts[op->a];
    return op + 1;
}

const Op* load(const Op* op, Machine& m)
{
    const std::string* const text = text_of(m, op->a);
    if (!text) return m.leave(op);
    m.texts[op->to] = *text;
    return op + 1;
}

const Op* load_text_element(const Op* op, Machine& m)
{
    const Value* const element = element_of(m, op);
    const auto* const text = element ? element->get_if<std::string>() : nullptr;
    if (!text) return m.leave(op);
    m.texts[op->to] = *text;
    return op + 1;
}

const Op* append(const Op* op, Machine& m)
{
    m.texts[op->to] += m.texts[op->a];
    return op + 1;
}

const Op* number(const Op* op, Machine& m)
{
    const double* const given = m.registers + op->a;
    m.texts[op->to].clear();
    add_number_text(m.texts[op->to], given[0], given[1], given[2]);
    return op + 1;
}

/// vstr: the separator is what stands in the register of the result.
const Op* tuple(const Op* op, Machine& m)
{
    const double *const given = m.registers + op->a, *const behind = given + 1 + op->b;
    std::string& text = m.texts[op->to];
    text = tuple_text(given[0], given + 1, static_cast<int>(op->b), text, behind[0], behind[1]);
    return op + 1;
}

const Op* character(const Op* op, Machine& m)
{
    return text_of_code(m.registers[op->a], m.texts[op->to]) ? op + 1 : m.leave(op);
}

const Op* part(const Op* op, Machine& m)
{
    const double* const given = m.registers + op->a;
    return keep_part(m.texts[op->to], given[0], given[1]) ? op + 1 : m.leave(op);
}

template <bool upper>
const Op* other_case(const Op* op, Machine& m)
{
    std::string& text = m.texts[op->to];
    if (!is_ascii(text)) return m.leave(op);
    change_case(text, upper);
    return op + 1;
}

const Op* length(const Op* op, Machine& m)
{
    m.registers[op->to] = static_cast<double>(length_of(m.texts[op->a]));
    return op + 1;
}

const Op* first(const Op* op, Machine& m)
{
    m.registers[op->to] = first_of(m.texts[op->a]);
    return op + 1;
}

const Op* number_in(const Op* op, Machine& m)
{
    m.registers[op->to] = std::strtod(m.texts[op->a].c_str(), nullptr);
    return op + 1;
}

const Op* order(const Op* op, Machine& m)
{
    m.registers[op->to] = order_of(m.texts[op->a], m.texts[op->b]);
    return op + 1;
}

const Op* relation(const Op* op, Machine& m)
{
    const int compared = m.texts[op->a].compare(m.texts[op->b]);
    m.registers[op->to] = relation_holds(static_cast<Kind>(op->jump), compared, 0.0) ? 1.0 : 0.0;
    return op + 1;
}

const Op* store_text(const Op* op, Machine& m)
{
    Value* const to = m.value_to_store(op->to, op->jump != 0);
    if (!to) return m.leave(op);
    if (auto* const same = to->get_if<std::string>()) same->swap(m.texts[op->a]);
    else *to = std::move(m.texts[op->a]);
    return op + 1;
}

const Op* store_text_element(const Op* op, Machine& m)
{
    static const std::uint32_t kTexts = kind_of(Value(std::string()));
    Value* const element = element_of(m, op);
    if (!element || !takes(**held_array(m, op->a), kTexts)) return m.leave(op);
    note_element(m, *held_array(m, op->a), element);
    *element = std::move(m.texts[op->to]);
    return op + 1;
}

}  // namespace

const Handler kTextConstant = constant;
const Handler kTextLoad = load;
const Handler kTextElement = load_text_element;
const Handler kTextAppend = append;
const Handler kTextNumber = number;
const Handler kTextTuple = tuple;
const Handler kTextCharacter = character;
const Handler kTextPart = part;
const Handler kTextUpper = other_case<true>;
const Handler kTextLower = other_case<false>;
const Handler kTextLength = length;
const Handler kTextFirst = first;
const Handler kTextValue = number_in;
const Handler kTextOrder = order;
const Handler kTextRelation = relation;
const Handler kStoreText = store_text;
const Handler kStoreTextElement = store_text_element;

}  // namespace parser::blocks
