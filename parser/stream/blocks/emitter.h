#pragma once

#include "parser/stream/blocks/operations.h"
#include "parser/stream/blocks/program.h"

#include <optional>
#include <utility>

namespace parser::blocks {

/// Turns lists of operations on a stack into operations with operands in registers, slots and constants.
class Emitter {
public:
    explicit Emitter(Program& program) : program_(program) {}

    /// The slot of a name that is expected to mean `kind`; kNoIndex: another kind is expected of it elsewhere.
    std::uint32_t slot(std::uint32_t name, std::uint8_t kind);
    /// Names may turn from a number, vector or colour to one of another length: a slot for each.
    void let_turn() { turning_ = true; }
    Op& emit(Handler run);
    std::uint32_t size() const { return static_cast<std::uint32_t>(program_.ops.size()); }
    /// Jumps of the operation `from` lead to the next that will be emitted.
    void land(std::uint32_t from) { program_.ops[from].jump = static_cast<std::int32_t>(size() - from); }
    void land(const std::vector<std::uint32_t>& all)
    {
        for (const std::uint32_t from : all) land(from);
    }

    /// The components of the expression, or its text, lie on the stack then. False: not possible.
    bool expression(CompiledExpression&& read);
    /// The last `count` entries of the stack lie in registers, in order: the first of them.
    std::uint32_t in_registers(std::size_t count);
    /// Takes them off.
    void drop(std::size_t count) { stack_.resize(stack_.size() - count); }
    /// As if the operations from `ops` on had not been emitted, which left so many entries.
    void rewind(std::size_t ops, std::size_t count)
    {
        program_.ops.resize(ops);
        drop(count);
        last_ = {};
    }
    void clear() { stack_.clear(), texts_ = 0, last_ = {}; }
    /// The number on top goes to a slot.
    void store_number(std::uint32_t to, bool local);
    /// Jumps if the number on top is as true as `sense`: the operation whose jump is to be set.
    std::uint32_t jump_if(bool sense);
    /// `count` components on the stack become the five of a colour; `transmits`: the fourth is transmit, not filter.
    void color(std::size_t count, bool transmits);
    void store_element(std::uint32_t array, std::size_t dimensions);
    /// Registers that expressions leave alone.
    std::uint32_t keep(std::uint32_t count) { return std::exchange(program_.registers, program_.registers + count); }
    /// Where calls stand from here on.
    void at_place(std::uint32_t place) { place_ = place; }
    void move_to(std::uint32_t kept);  ///< the number on top
    /// The `count` numbers on top go to registers from `kept` on; constants go to `constants` instead.
    void move_all_to(std::uint32_t kept, std::size_t count, double* constants);

private:
    struct Entry {
        Operand where = Operand::Register;
        std::uint32_t index = 0;
        double number = 0;
    };
    /// The operation emitted last, if it leaves the number on top in a register.
    struct Last {
        std::uint32_t op = kNoIndex;
        Binary f = Binary::Add;
        Operand a = Operand::Register, b = Operand::Register;
    };
    std::uint32_t depth() const { return static_cast<std::uint32_t>(stack_.size()); }
    void push_register() { stack_.push_back({Operand::Register, depth(), 0}); }
    void push_registers(std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i) push_register();
    }
    Entry pop()
    {
        const Entry top = stack_.back();
        stack_.pop_back();
        return top;
    }
    bool operation(const CompiledExpression& read, std::size_t& at, std::uint32_t expression);
    bool load_text(const CompiledOp& op);
    bool text_operation(const CompiledOp& op);
    bool load_tuple(const CompiledExpression& read, std::size_t& at);
    bool element(const CompiledOp& op);
    bool tuples(const CompiledOp& op, std::uint32_t expression, std::size_t at);
    bool borrow(std::uint32_t expression, std::size_t at, std::size_t takes, std::size_t gives);
    bool in_place(Handler run, std::size_t takes, std::size_t gives, std::uint32_t b);
    bool trace(std::uint32_t object, std::uint32_t normal);
    bool binary(Binary f);
    void fill(std::uint32_t to, Operand where, std::uint32_t index);
    bool macro_call(const CompiledCall& read, std::size_t count);
    void unary(Handler run, const Entry& operand);
    void register_of(Entry& entry, std::uint32_t to);

    Program& program_;
    std::vector<Entry> stack_;
    std::uint32_t texts_ = 0, place_ = kNoIndex;
    bool turning_ = false;
    Last last_;
};

}  // namespace parser::blocks
