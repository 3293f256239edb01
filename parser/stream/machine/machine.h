#pragma once

#include "parser/stream/machine/program.h"
#include "parser/stream/values/random_undo.h"
#include "parser/stream/values/symbols.h"

namespace parser {
class GrammarHooks;
}

namespace parser::blocks {

/// What a name means while a frame runs; null: nothing, or not what was expected.
struct Slot {
    double* numbers = nullptr;  ///< components
    double* own = nullptr;      ///< the same if `#local` has made it, or found it, in this frame's scope
    Value* value = nullptr;
    bool own_value = false;  ///< `value` is of this frame's scope
};

struct Frame {
    const Program* program = nullptr;
    const Op* back = nullptr;  ///< of the caller, behind the call
    std::size_t slots = 0, registers = 0;
    const Call* call = nullptr;  ///< by which it was entered; null: the outermost
    std::uint32_t scope = 0;
    std::uint64_t calls = 0;  ///< made before it
};

/// A value that a statement has changed before it was done.
struct Note {
    Cell cell;
    Value old;
};

/// What the machine asks of the stream that it works for.
class Supply {
public:
    virtual ~Supply() = default;
    /// More tokens that may be read; 0: none, or reading shall end.
    virtual std::int64_t more() = 0;
    /// The body of the macro that is called, whose parameters are bound.
    virtual const Program& program_of(const Call& call) = 0;
};

/// Runs programs. Everything that names mean stays in the cells of the symbols; slots point to it.
class Machine {
public:
    Machine(Symbols& symbols_of, RandomUndo& random_of, GrammarHooks& hooks_of, Supply& supply_of)
        : symbols(symbols_of), random(random_of), hooks(hooks_of), supply(supply_of)
    {}

    void enter(const Program& program, std::uint32_t scope);
    void push(const Program& program, const Call& call, const Op* back);
    void pop();
    /// What stands in the slot's variable, or in an element, may have to be put back.
    void note(std::uint32_t slot);
    void note(const std::shared_ptr<Array>& array, Value* element)
    {
        notes.push_back({Cell(array, element), *element});
    }
    /// Puts back what was noted and drawn since the statement began.
    void undo_changes();
    /// Leaves all calls whose values were wanted: it stands at the statement that began with them.
    void undo_values();
    void run(const Op* op)
    {
        while (op) op = op->run(op, *this);
    }
    const Op* leave(const Op* op)
    {
        stopped = op;
        return nullptr;
    }
    /// A slot of `op` means nothing: it may have come to mean something since the frame was entered.
    const Op* missing(const Op* op, std::uint32_t slot);
    /// Components of a slot that a store wants to write; null: it means something else. `turns`: a number, vector or
    /// colour of another length becomes one of the slot's.
    double* place_to_store(std::uint32_t slot, bool local, bool turns);
    Value* value_to_store(std::uint32_t slot, bool local);
    Value* value_of(std::uint32_t slot)
    {
        return slots[slot].value ? slots[slot].value : (slots[slot].value = symbols.find(info(slot).name));
    }
    const SlotInfo& info(std::uint32_t slot) const { return program->slots[slot]; }
    const Frame& frame() const { return frames.back(); }
    const double* registers_of(const Frame& frame) const { return register_stack_.data() + frame.registers; }

    Slot* slots = nullptr;
    double* registers = nullptr;
    const Program* program = nullptr;
    std::int64_t budget = 0;  ///< tokens that may be read
    Symbols& symbols;
    RandomUndo& random;
    GrammarHooks& hooks;
    Supply& supply;
    const Op* stopped = nullptr;
    std::vector<Frame> frames;
    std::vector<Cell> arguments;              ///< of the call that is being made
    std::vector<std::string> texts;           ///< registers of texts
    std::size_t most_frames = 0;              ///< calls inside each other, the outermost block included
    std::size_t blocks = 0, most_blocks = 0;  ///< conditionals, loops and calls that are open, at the last call
    std::uint64_t calls = 0;
    bool statements = false;                    ///< statements of the grammar may stand in the block
    std::size_t values = 0;                     ///< calls at work whose values are wanted
    std::uint32_t guards = 0, most_guards = 0;  ///< how deep the reader of tokens would be nested
    std::vector<Note> notes;                    ///< while there are such calls

private:
    void resolve();
    bool may_turn(const Value& value) const;
    void turn(Value& value, std::uint8_t count);
    void forget_others(std::uint32_t slot);
    std::vector<Slot> slot_stack_;
    std::vector<double> register_stack_;
};

}  // namespace parser::blocks
