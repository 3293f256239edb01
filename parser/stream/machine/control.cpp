#include "parser/stream/machine/operands.h"
#include "parser/stream/expression.h"
#include "parser/stream/expressions/operand.h"
#include "parser/stream/files/data_file.h"
#include "parser/stream/limits.h"
#include "parser/stream/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

/// Branches, loops, calls.
namespace parser::blocks {
namespace {

const Op* jump(const Op* op, Machine&) { return op + op->jump; }

const Op* stop(const Op* op, Machine& m) { return m.leave(op); }

const Op* spend(const Op* op, Machine& m)
{
    m.budget -= op->a;
    if (m.budget < 0) {
        m.budget += m.supply.more();
        if (m.budget < 0) return m.leave(op);
    }
    return op + 1;
}

const Op* begin(const Op* op, Machine& m)
{
    if (m.values == 0) {
        m.random.keep();
        m.notes.clear();
    }
    return op + 1;
}

const Op* set(const Op* op, Machine& m)
{
    const Value* const value = m.symbols.find(m.info(op->a).name);
    const bool set = value && value->set();
    return set == (op->b == 0) ? op + 1 : op + op->jump;
}

/// The `#for` has its variable; null: the reader of tokens has to look at it.
double* variable(Machine& m, std::uint32_t slot)
{
    double* const own = m.slots[slot].own;
    return own ? own : m.place_to_store(slot, true, false);
}

const Op* for_begin(const Op* op, Machine& m)
{
    const double* const given = m.registers + op->b;
    if (!(std::abs(given[2]) >= kSlackOfFor)) return m.leave(op);
    double* const value = variable(m, op->a);
    if (!value) return m.leave(op);
    *value = given[0];
    return for_goes_on(given[0], given[1], given[2]) ? op + 1 : op + op->jump;
}

const Op* for_next(const Op* op, Machine& m)
{
    const double* const given = m.registers + op->b;
    double* const value = variable(m, op->a);
    if (!value) return m.leave(op);
    *value += given[1];
    return for_goes_on(*value, given[0], given[1]) ? op + op->jump : op + 1;
}

const Op* one_case(const Op* op, Machine& m)
{
    return std::abs(m.registers[op->a] - m.registers[op->b]) < kSame ? op + op->jump : op + 1;
}

const Op* range(const Op* op, Machine& m)
{
    const double value = m.registers[op->a];
    return m.registers[op->b] <= value && value <= m.registers[op->b + 1] ? op + op->jump : op + 1;
}

/// The cell that a parameter will be; null: the reader of tokens has to look at it.
Cell given(const Argument& argument, Machine& m)
{
    switch (argument.kind) {
    case Argument::Kind::Name: {
        const Cell* const cell = m.symbols.bound_cell(argument.name);
        const bool plain = cell && ((*cell)->get_if<Tuple>() || (*cell)->get_if<std::string>() ||
                                    (*cell)->get_if<std::shared_ptr<Array>>() ||
                                    (*cell)->get_if<std::shared_ptr<const scene::Object>>());
        return plain ? *cell : nullptr;
    }
    case Argument::Kind::Element: {
        const std::shared_ptr<Array>* const held = held_array(m, argument.slot);
        Value* const element = element_at(held, m.registers + argument.first, argument.count);
        const bool plain = element && (element->get_if<Tuple>() || element->get_if<std::string>());
        return plain ? Cell(*held, element) : nullptr;
    }
    case Argument::Kind::Number: return make_number_cell(m.registers + argument.first, argument.count);
    default: return make_cell(m.texts[argument.first]);
    }
}

const Op* call(const Op* op, Machine& m)
{
    constexpr std::size_t kMostNotes = 1 << 16;
    const Call& site = m.program->calls[op->a];
    const Value* const meant = m.symbols.find(site.macro->name);
    const auto* const macro = meant ? meant->get_if<std::shared_ptr<const Macro>>() : nullptr;
    if (!macro || *macro != site.macro || m.frames.size() >= m.most_frames || m.notes.size() > kMostNotes)
        return m.leave(op);
    const bool never = site.value && (site.value->result == 0 || m.guards + site.guards >= m.most_guards);
    if (never) return m.leave(op);
    const std::size_t open = m.blocks + (site.place == kNoIndex ? 0 : m.program->places[site.place].depth) + 1;
    if (open >= m.most_blocks) return m.leave(op);
    m.budget -= site.macro->end - site.macro->begin + site.after - site.token;
    if (m.budget < 0) {
        m.budget += m.supply.more();
        if (m.budget < 0) return m.leave(op);
    }
    std::vector<Cell>& cells = m.arguments;
    cells.clear();
    for (const Argument& argument : site.arguments)
        if (!cells.emplace_back(given(argument, m))) return m.leave(op);
    m.symbols.open_scope();
    for (std::size_t i = 0; i < cells.size(); ++i) m.symbols.bind(site.macro->parameters[i], std::move(cells[i]));
    m.blocks = open;
    if (site.value) {
        ++m.values;
        m.guards += site.guards;
    }
    m.push(site.value ? *site.value : m.supply.program_of(site), site, op + 1);
    ++m.calls;
    return m.program->ops.data();
}

const Op* leave_macro(const Op*, Machine& m)
{
    const Frame& left = m.frame();
    const Op* const back = left.back;
    const std::uint32_t place = left.call->place;
    m.symbols.close_scope();
    m.pop();
    m.blocks -= (place == kNoIndex ? 0 : m.program->places[place].depth) + 1;
    return back;
}

const Op* give(const Op* op, Machine& m)
{
    const double* const from = m.registers + op->a;
    double value[5];
    for (std::uint32_t i = 0; i < op->b; ++i) value[i] = from[i];
    m.guards -= m.frame().call->guards;
    --m.values;
    const Op* const back = leave_macro(op, m);
    double* const to = m.registers + back[-1].to;
    for (std::uint32_t i = 0; i < op->b; ++i) to[i] = value[i];
    return back;
}

const Op* constants(const Op* op, Machine& m)
{
    const ReadyValues& values = m.program->ready[op->a];
    std::copy(values.constants.begin(), values.constants.end(), m.registers + values.first);
    return op + 1;
}

const Op* ready(const Op* op, Machine& m)
{
    constexpr std::uint32_t kGuards = 40;  // more than the reader of tokens would need for it
    const ReadyValues& values = m.program->ready[op->a];
    const bool may = m.statements && m.values == 0 && m.guards + kGuards < m.most_guards;
    const RandomUndo::Hold hold(m.random);  // a texture may be read on the way
    return may && values.statement->run(m.registers + values.first, m.symbols) ? op + 1 : m.leave(op);
}

/// The end of the file, and what is no number, are for the reader of tokens.
const Op* read(const Op* op, Machine& m)
{
    const ReadSite& site = m.program->reads[op->a];
    const Value* const value = m.symbols.find(site.file);
    const auto* const file = value ? value->get_if<std::shared_ptr<DataFile>>() : nullptr;
    if (!file || !(*file)->reading() || m.values != 0) return m.leave(op);
    for (const std::uint32_t slot : site.slots)
        if (!m.slots[slot].numbers && !m.missing(op, slot)) return nullptr;
    if (!(*file)->read_numbers(m.registers, site.slots.size())) return m.leave(op);
    for (std::size_t i = 0; i < site.slots.size(); ++i) *m.slots[site.slots[i]].numbers = m.registers[i];
    return op + 1;
}

/// What is written stays so: the last thing that a statement does, and not in a macro whose value may be put back.
const Op* write(const Op* op, Machine& m)
{
    const Value* const value = m.symbols.find(op->b);
    const auto* const file = value ? value->get_if<std::shared_ptr<DataFile>>() : nullptr;
    const bool may = file && !(*file)->reading() && m.values == 0 && is_ascii(m.texts[op->a]);
    return may && (*file)->write(m.texts[op->a]) ? op + 1 : m.leave(op);
}

}  // namespace

const Handler kRead = read;
const Handler kWrite = write;
const Handler kConstants = constants;
const Handler kReady = ready;
const Handler kJump = jump;
const Handler kStop = stop;
const Handler kSpend = spend;
const Handler kBegin = begin;
const Handler kSet = set;
const Handler kForBegin = for_begin;
const Handler kForNext = for_next;
const Handler kCase = one_case;
const Handler kRange = range;
const Handler kCall = call;
const Handler kCallValue = call;
const Handler kGive = give;
const Handler kReturn = leave_macro;

}  // namespace parser::blocks
