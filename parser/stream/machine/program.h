#pragma once

#include "function/program.h"
#include "parser/lexer/token.h"
#include "parser/stream/language_state.h"
#include "parser/stream/ready_statement.h"
#include "parser/stream/values/value.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// A block of directives over numbers, texts and arrays as a list of operations (docs/blocks.md).
namespace parser::blocks {

class Machine;
struct Op;
/// Does the operation and gives the next one; null: the block is left at this operation.
using Handler = const Op* (*)(const Op*, Machine&);

struct Op {
    Handler run = nullptr;
    std::uint32_t to = 0;        ///< where the result goes: a register or a slot
    std::uint32_t a = 0, b = 0;  ///< operands: registers, slots or what the handler says
    std::int32_t jump = 0;       ///< to the operation so many places on
    double number = 0;           ///< an operand that is a constant
};
static_assert(sizeof(Op) == 32);

/// What a name of the block is expected to mean: 1 to 5 components, or one of these.
enum SlotKind : std::uint8_t { kAny = 0, kFloat = 1, kText = 6, kArray = 7 };

struct SlotInfo {
    std::uint32_t name = kNoIndex;
    std::uint8_t kind = kAny;
};

enum class PlaceKind : std::uint8_t { If, Switch, While, For };

/// A conditional or loop that is open somewhere in the block.
struct Place {
    std::uint32_t parent = kNoIndex;
    PlaceKind kind = PlaceKind::If;
    std::uint32_t branch = 0;       ///< Hash of the branch that is being read
    std::uint32_t again = 0;        ///< loops: token of the condition, or first of the body
    std::uint32_t name = kNoIndex;  ///< For: its variable
    std::uint32_t limit = 0;        ///< For: register of the last value; the step stands behind it
    std::uint32_t depth = 1;        ///< places around this one, and itself
};

/// From operation `op` on the reader of tokens would go on at `token`, with the conditionals and loops of `place` open.
struct Statement {
    std::uint32_t op = 0, token = 0, place = kNoIndex;
    bool undo = false;  ///< what it has drawn and stored is noted from its beginning on
};

struct Program;

struct Argument {
    enum class Kind : std::uint8_t { Name, Element, Number, Text };
    Kind kind = Kind::Number;
    std::uint8_t count = 1;   ///< components, or subscripts
    std::uint32_t name = 0;   ///< Name
    std::uint32_t slot = 0;   ///< Element: of the array
    std::uint32_t first = 0;  ///< register of the first component or subscript, or of the text
};

struct Call {
    std::shared_ptr<const Macro> macro;
    std::vector<Argument> arguments;
    std::uint32_t token = 0;  ///< the macro's name
    std::uint32_t after = 0;  ///< behind the arguments
    std::uint32_t place = kNoIndex;
    const Program* value = nullptr;   ///< what it gives is wanted; null: the call is a statement
    std::uint32_t guards = 0;         ///< at most so deep is the reader of tokens nested there
    mutable Program* body = nullptr;  ///< that Supply::program_of() gave last
};

/// A statement of the grammar and its values as far as they are constants.
struct ReadyValues {
    std::unique_ptr<ReadyStatement> statement;
    std::vector<double> constants;
    std::uint32_t first = 0;  ///< register of the first value
};

/// `#read` of numbers into variables that are numbers.
struct ReadSite {
    std::uint32_t file = kNoIndex;     ///< name of the open file
    std::vector<std::uint32_t> slots;  ///< in order
};

struct Program {
    std::vector<Op> ops;
    std::vector<SlotInfo> slots;
    std::vector<Statement> statements;  ///< by `op`
    std::vector<Place> places;
    std::vector<Call> calls;
    std::vector<function::FunctionPtr> functions;  ///< that calls expect
    std::vector<std::string> texts;
    std::vector<ReadyValues> ready;
    std::vector<ReadSite> reads;
    std::uint32_t registers = 0;
    std::uint32_t again = kNoIndex;             ///< the block is a loop: where its next pass is asked for
    std::uint32_t stops = 0;                    ///< how often it was left before its end
    std::uint32_t attempt = 0;                  ///< how often it was compiled
    int version = 0;                            ///< of the language
    scene::PovRay povray = scene::PovRay::V37;  ///< whose last bits its numbers have
    int result = 0;                             ///< components that a macro gives; 0: none
    bool named = false;                         ///< it may be a variable as such
    bool turning = false;                       ///< names have slots for several numbers of components
};

/// Registers below this are the stack of expressions.
inline constexpr std::uint32_t kStackRegisters = 64;
inline constexpr std::uint32_t kTextRegisters = 32;

}  // namespace parser::blocks
