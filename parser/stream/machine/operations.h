#pragma once

#include "parser/stream/machine/program.h"

/// Handlers by what they do and where their operands lie.
namespace parser::blocks {

/// Where an operand lies: in a register, in a variable of one component, in the operation itself.
enum class Operand : std::uint8_t { Register, Slot, Constant };
/// Where a result goes.
enum class Target : std::uint8_t { Register, Declared, Local };

/// Of two operands: function::is_binary(f).
using Binary = function::Op;
constexpr bool is_relation(Binary f) { return f >= Binary::Less && f <= Binary::NotEqual; }
constexpr bool is_sum(Binary f) { return f <= Binary::Divide; }

/// to = a f b. Targets other than a register: is_sum(f) only.
Handler binary_handler(Binary f, Operand a, Operand b, Target to);
/// Jumps if (a f b) == sense; is_relation(f) only.
Handler relation_jump_handler(Binary f, Operand a, Operand b, bool sense);
/// Jumps if the truth of a is `sense`.
Handler truth_jump_handler(Operand a, bool sense);
/// to = a.
Handler move_handler(Operand a, Target to);
/// to = f(a), `f` a built-in function of one number, Rand or (the sign) Minus; null: none of these.
Handler function_handler(Kind f, Operand a);
inline bool is_function(Kind f) { return function_handler(f, Operand::Register) != nullptr; }
/// Registers from `to` on, a components f the b behind them: the shorter side grows. is_sum(f) only.
Handler combine_handler(Binary f);

// What works on `count` components in registers from `to` on.
extern const Handler kLoadTuple;      ///< slot a, count b
extern const Handler kLoadComponent;  ///< slot a, component b
extern const Handler kStoreTuple;     ///< slot `to`, registers from a on, count b; jump: local
extern const Handler kSplat;          ///< the number in `to`, count b
extern const Handler kSelect;         ///< to = component b of those from `to` on
extern const Handler kGray;           ///< the same of a colour's brightness
extern const Handler kNegateTuple;    ///< count b
extern const Handler kNot;            ///< count b
extern const Handler kChooseIf;       ///< condition, what it is if true, what if false
extern const Handler kChooseBySign;   ///< number, what it is below 0, else what; b: another one for above 0
extern const Handler kLength;         ///< vlength() of three
extern const Handler kDot;            ///< vdot() of three and three
extern const Handler kCross;
extern const Handler kRotate;
extern const Handler kNormalize;
extern const Handler kCallFunction;  ///< function b of the program, if the name a means it: arguments become components
extern const Handler kCurve;         ///< the spline a at `to`: b components; jump: of which kind, -1: its own
extern const Handler kInside;        ///< inside() of the object whose name is a: the point becomes the answer
/// trace() of the object whose name is a: origin and direction become the point; slot b, if there is one: the normal
extern const Handler kTrace;

// Arrays: slot a.
Handler element_handler(Operand subscript);                       ///< to = A[b], one component
Handler element2_handler(Operand first, Operand second);          ///< to = A[b][jump], one component
Handler store_element_handler(Operand subscript, Operand value);  ///< A[b] = to, one component
extern const Handler kElement;        ///< subscripts from `to` on; b: how many; jump: components, from `to` on
extern const Handler kStoreElement;   ///< the same from b on; `to`: subscripts; jump: components, from behind them on
extern const Handler kMakeArray;      ///< slot a, sizes in registers from b on, `to` of them; jump: local
extern const Handler kCopyArray;      ///< slot `to` = slot a; jump: local
extern const Handler kDimensionSize;  ///< slot a; b: of the dimension that register `to` names, else their number

// Texts: register `to`.
extern const Handler kTextConstant;  ///< text a of the program
extern const Handler kTextLoad;      ///< slot a
extern const Handler kTextElement;   ///< slot a, subscripts in registers from b on, `jump` of them
extern const Handler kTextAppend;    ///< to += a
extern const Handler kTextNumber;    ///< str of registers a, a + 1, a + 2
extern const Handler
    kTextTuple;  ///< vstr: registers from a on: how many, five components, width, precision; b: components
extern const Handler kTextCharacter;     ///< chr of register a
extern const Handler kTextPart;          ///< substr of text `to` by registers a, a + 1
extern const Handler kTextUpper;         ///< strupr
extern const Handler kTextLower;         ///< strlwr
extern const Handler kTextLength;        ///< register `to`: strlen of text a
extern const Handler kTextFirst;         ///< asc
extern const Handler kTextValue;         ///< val
extern const Handler kTextOrder;         ///< strcmp of texts a and b
extern const Handler kTextRelation;      ///< texts a and b; jump: which Kind
extern const Handler kStoreText;         ///< slot `to` = text a; jump: local
extern const Handler kStoreTextElement;  ///< slot a, subscripts in registers from b on, `jump` of them = text `to`

// Control.
extern const Handler kJump;
extern const Handler kStop;   ///< what follows is for the reader of tokens
extern const Handler kSpend;  ///< a tokens are read
extern const Handler kBegin;  ///< what is drawn from here on may be set back
extern const Handler kSet;    ///< jumps unless slot a means something (`#ifdef`); b: the other way round
extern const Handler kCall;   ///< a: which call
extern const Handler kReturn;
extern const Handler kCallValue;  ///< a: which call; the value goes to the registers from `to` on
extern const Handler kGive;       ///< the value of a macro: b components in registers from a on
extern const Handler kConstants;  ///< constants of ready statement a to its registers
extern const Handler kReady;      ///< ready statement a
extern const Handler kRead;       ///< numbers from a file: read site a
extern const Handler kWrite;      ///< text a to the file whose name is b
extern const Handler kForBegin;   ///< slot a; registers b: first value, limit, step; jumps if there is no pass
extern const Handler kForNext;    ///< slot a; registers b: limit, step; jumps if there is one more pass
extern const Handler kCase;       ///< jumps if register a equals register b (`#case`)
extern const Handler kRange;      ///< jumps if register a is in the range that registers b, b + 1 hold

}  // namespace parser::blocks
