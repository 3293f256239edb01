#pragma once

#include "parser/stream/machine/operations.h"
#include "parser/stream/machine/program.h"

#include <string>
#include <utility>

namespace parser::blocks {

/// Emits operations with operands in registers, slots and constants for whoever thinks of a stack: numbers on it wait
/// where they are, a variable or a constant, until something has to find them in registers.
class Emitter {
public:
    explicit Emitter(Program& program) : program_(program) {}

    /// The slot of a name that is expected to mean `kind`; kNoIndex: another kind is expected of it elsewhere.
    std::uint32_t slot(std::uint32_t name, std::uint8_t kind);
    /// Names may turn from a number, vector or colour to one of another length: a slot for each.
    void let_turn() { turning_ = true; }
    Op& emit(Handler run);
    std::uint32_t size() const { return static_cast<std::uint32_t>(program_.ops.size()); }
    std::uint32_t depth() const { return static_cast<std::uint32_t>(stack_.size()); }
    std::uint32_t texts() const { return texts_; }
    const std::vector<Call>& calls() const { return program_.calls; }
    /// More lay on the stacks since clear() than there are registers for.
    bool too_deep() const { return too_deep_; }
    /// Jumps of the operation `from` lead to the next that will be emitted.
    void land(std::uint32_t from) { program_.ops[from].jump = static_cast<std::int32_t>(size() - from); }
    void land(const std::vector<std::uint32_t>& all)
    {
        for (const std::uint32_t from : all) land(from);
    }

    // Numbers: what is on top is replaced by the result. False: not possible.
    void constant(double number) { push({Operand::Constant, 0, number}); }
    bool load(std::uint32_t name, std::uint8_t count);  ///< a variable of so many components
    void binary(Binary f);
    void function(Kind f);
    void negate(std::uint32_t count);
    void splat(std::uint32_t count);                        ///< the number on top, so many times
    void select(std::uint32_t count, std::uint32_t index);  ///< one of `count` components
    int combine(Binary f, int left, int right);             ///< of `left` and `right` components: how many it gives
    bool element(std::uint32_t name, std::size_t dimensions, std::size_t count);
    void call_function(std::uint32_t name, const function::FunctionPtr& called);
    bool trace(std::uint32_t object, std::uint32_t normal);
    bool dimension_size(std::uint32_t name, bool sized);
    /// A macro gives `count` components; what lies from `base` on are its arguments.
    void call_value(Call&& call, std::size_t base, std::size_t count);
    /// An operation that finds `takes` numbers in registers from its `to` on and leaves `gives` there.
    Op& in_place(Handler run, std::size_t takes, std::size_t gives);
    /// The same on each of `count` numbers, which its `b` says.
    void each_in_place(Handler run, std::uint32_t count) { in_place(run, count, count).b = count; }
    /// An operation emitted since `first` stores what an expression gives beside its value, and is not the last.
    bool stores_before_end(std::uint32_t first) const;

    // Texts: on a stack of their own.
    void text_constant(std::string&& text);
    bool text_load(std::uint32_t name);
    bool text_element(std::uint32_t name, std::size_t dimensions);
    void append_text();
    void text_of_numbers(Handler run, std::size_t taken);
    Op& change_text(Handler run, std::size_t taken);  ///< the one on top, by so many numbers
    void number_of_texts(Handler run, std::uint32_t taken, std::int32_t how = 0);

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
    void clear() { stack_.clear(), texts_ = 0, last_ = {}, too_deep_ = false; }
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

public:
    /// To try another form of what comes next.
    struct State {
        std::vector<Entry> stack;
        std::size_t ops;
        std::uint32_t texts;
        Last last;
    };
    State state() const { return {stack_, program_.ops.size(), texts_, last_}; }
    void back_to(const State& state)
    {
        stack_ = state.stack, texts_ = state.texts, last_ = state.last;
        program_.ops.resize(state.ops);
    }

private:
    static constexpr std::uint32_t kDeepestStack = kStackRegisters - 8, kDeepestTexts = kTextRegisters - 8;
    void push(const Entry& entry)
    {
        stack_.push_back(entry);
        too_deep_ = too_deep_ || stack_.size() > kDeepestStack;
    }
    void push_register() { push({Operand::Register, depth(), 0}); }
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
    Op& emit_text(Handler run)
    {
        Op& made = emit(run);
        made.to = texts_++;
        too_deep_ = too_deep_ || texts_ > kDeepestTexts;
        return made;
    }
    void fill(std::uint32_t to, Operand where, std::uint32_t index);
    void register_of(Entry& entry, std::uint32_t to);

    Program& program_;
    std::vector<Entry> stack_;
    std::uint32_t texts_ = 0, place_ = kNoIndex;
    bool turning_ = false, too_deep_ = false;
    Last last_;
};

}  // namespace parser::blocks
