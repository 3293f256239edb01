#pragma once

#include "csg/base/types.h"
#include "function/spline.h"

#include <array>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace function {

enum class Op : std::uint8_t {
    // two operands
    Add,
    Subtract,
    Multiply,
    Divide,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Min,
    Max,
    Atan2,
    IntDivide,
    Modulo,
    Power,
    // one operand
    Negate,
    Abs,
    Acos,
    Acosh,
    Asin,
    Asinh,
    Atan,
    Atanh,
    Ceil,
    Cos,
    Cosh,
    Degrees,
    Exp,
    Floor,
    Int,
    Ln,
    Log,
    Radians,
    Sin,
    Sinh,
    Sqrt,
    Tan,
    Tanh,
    // structured and outward
    Select,
    Loop,
    Call,
    Internal,
    SceneReference,
    // known before the program runs
    Constant,
    Parameter,
    Counter,
    Component,
    BeginBranch,
    EndBranch,
    BeginLoop
};

constexpr bool is_binary(Op op) { return op <= Op::Power; }
constexpr bool is_unary(Op op) { return op > Op::Power && op <= Op::Tanh; }

class Function;
using FunctionPtr = std::shared_ptr<const Function>;

/// Something of the scene that a function evaluates: who knows it derives from this.
struct External {
    virtual ~External() = default;
};

/// What a function asks of the scene. `slot` is what link() made of an External.
class Host {
public:
    virtual ~Host() = default;
    /// Solid noise in [0, 1]; generator 1 to 3, 0 the scene's.
    virtual double noise(const glm::dvec3& p, int generator) const = 0;
    virtual double pattern(std::uint32_t slot, const glm::dvec3& p) const = 0;
    /// red, green, blue, filter, transmit
    virtual std::array<double, 5> pigment(std::uint32_t slot, const glm::dvec3& p) const = 0;
    /// noise() of eight points, with the same bits; coordinates and results are aligned to 64 bytes.
    virtual void noises(const double* x, const double* y, const double* z, int generator, double* out) const
    {
        for (int i = 0; i < 8; ++i) out[i] = noise({x[i], y[i], z[i]}, generator);
    }
    /// pattern() of eight points or up to eight times as many, with the same bits.
    virtual void patterns(std::uint32_t slot, const double* x, const double* y, const double* z, std::size_t count,
                          double* out) const
    {
        for (std::size_t i = 0; i < count; ++i) out[i] = pattern(slot, {x[i], y[i], z[i]});
    }
    /// pigment() of as many; component k of all goes to out[k].
    virtual void pigments(std::uint32_t slot, const double* x, const double* y, const double* z, std::size_t count,
                          const std::array<double*, 5>& out) const
    {
        for (std::size_t i = 0; i < count; ++i) {
            const std::array<double, 5> c = pigment(slot, {x[i], y[i], z[i]});
            for (std::size_t k = 0; k < c.size(); ++k) out[k][i] = c[k];
        }
    }
    /// The texture set behind the answers, null: none. A kernel module asks it by its own build of render/texture,
    /// which knows the processor better than the program's.
    virtual const void* texture_set() const { return nullptr; }
};

/// A `pattern { }` or `pigment { }` in a function.
struct SceneUse {
    enum class Kind : std::uint8_t { Pattern, Pigment } kind = Kind::Pattern;
    std::shared_ptr<const External> external;
    std::uint32_t slot = 0xffffffffu;  ///< set by link()
};

/// What the instructions Call, Internal and SceneReference name.
/// (Internal: the number n).
using SceneReference =
    std::variant<csg::Transform, std::shared_ptr<const Spline>, SceneUse, FunctionPtr, std::uint32_t>;

/// `dst` and the operands are registers. Call, Internal, SceneReference: `a` is the first of `b` places in
/// Function::arguments, `c` the place in Function::outer; SceneReference writes up to five registers from dst. Select
/// and Loop: `a` is a place in branchings or loops, whose code follows.
struct Instruction {
    Op op = Op::Add;
    std::uint32_t dst = 0, a = 0, b = 0, c = 0;
    std::uint32_t weights = kNone;  ///< Internal: a place in Function::octave_weights, where they are known
    static constexpr std::uint32_t kNone = 0xffffffffu;
};

/// select(): branch k is code [begin[k], end[k]) with its value in result[k]; negative, zero (if three), the rest.
struct Branching {
    std::uint32_t condition = 0, count = 2;
    std::array<std::uint32_t, 3> begin{}, end{}, result{};
};

/// sum() and prod(): the counter goes from `from` by 1 while it is <= `to`.
struct Loop {
    std::uint32_t from = 0, to = 0, counter = 0, begin = 0, end = 0, result = 0;
    bool product = false;
};

/// A node of the body as it was read, kept so that callers can take it in.
struct Node {
    Op op = Op::Constant;
    std::uint32_t a = 0, b = 0, c = 0;  ///< operands, or small numbers
    double number = 0;
    std::vector<std::uint32_t> operands;
};

/// A compiled function: registers are constants, then parameters, then the rest. Immutable, shared by all threads.
class Function {
public:
    std::uint32_t parameters = 3;
    std::uint32_t components = 1;  ///< of the result
    std::vector<double> constants;
    std::uint32_t registers = 0;
    std::uint32_t result = 0;  ///< first register of the result
    std::vector<Instruction> code;
    std::vector<std::uint32_t> arguments;
    std::vector<SceneReference> outer;
    std::vector<Branching> branchings;
    std::vector<Loop> loops;
    std::vector<std::vector<double>> octave_weights;  ///< of calls of f_ridged_mf whose parameters are constants
    std::uint32_t depth = 1;                          ///< calls below it, itself included
    bool asks_scene = false;                          ///< noise, patterns or pigments, here or below

    std::vector<Node> nodes;  ///< what the code was made of
    std::uint32_t value = 0;  ///< node of the result

    /// The frame begins with parameter i in register constants.size() + i.
    std::uint32_t first_parameter() const { return static_cast<std::uint32_t>(constants.size()); }
};

}  // namespace function
