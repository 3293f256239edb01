#pragma once

#include "function/arithmetic.h"

#include <memory>

/// The interpreter, for any kind of value V. `Rules<V>` says what the operators, branches and loops of V are.
namespace function {

template <class V>
struct Rules;

/// A frame of registers: on the stack while small.
template <class V>
class Frame {
public:
    explicit Frame(const Function& f) : large_(f.registers > kSmall ? new V[f.registers] : nullptr)
    {
        V* r = registers();
        for (std::size_t i = 0; i < f.constants.size(); ++i) r[i] = Rules<V>::constant(f.constants[i]);
    }
    V* registers() { return large_ ? large_.get() : small_; }

private:
    static constexpr std::uint32_t kSmall = 64;
    std::unique_ptr<V[]> large_;
    V small_[kSmall];
};

template <class V>
V run_function(const Function& f, const V* arguments, const Host& host);

template <class V>
class Machine {
public:
    Machine(const Function& f, V* registers, const Host& host) : f_(f), r_(registers), host_(host) {}

    void run(std::uint32_t begin, std::uint32_t end)
    {
        for (std::uint32_t pc = begin; pc < end;) {
            const Instruction& in = f_.code[pc++];
            switch (in.op) {
            case Op::Add: r_[in.dst] = Rules<V>::template binary<Op::Add>(r_[in.a], r_[in.b]); break;
            case Op::Subtract: r_[in.dst] = Rules<V>::template binary<Op::Subtract>(r_[in.a], r_[in.b]); break;
            case Op::Multiply: r_[in.dst] = Rules<V>::template binary<Op::Multiply>(r_[in.a], r_[in.b]); break;
            case Op::Select: {
                const Branching& b = f_.branchings[in.a];
                Rules<V>::select(*this, b, in.dst);
                pc = b.end[b.count - 1];
                break;
            }
            case Op::Loop:
                Rules<V>::loop(*this, f_.loops[in.a], in.dst);
                pc = f_.loops[in.a].end;
                break;
            case Op::Call:
            case Op::Internal:
            case Op::SceneReference: outward(in); break;
            default:
                if (is_binary(in.op))
                    with_binary(in.op, [&]<Op o>() { r_[in.dst] = Rules<V>::template binary<o>(r_[in.a], r_[in.b]); });
                else with_unary(in.op, [&]<Op o>() { r_[in.dst] = Rules<V>::template unary<o>(r_[in.a]); });
            }
        }
    }

    V& reg(std::uint32_t i) { return r_[i]; }

private:
    static constexpr std::size_t kMostArguments = 64;  // the language allows 56

    void outward(const Instruction& in)
    {
        V arguments[kMostArguments];
        for (std::uint32_t i = 0; i < in.b; ++i) arguments[i] = r_[f_.arguments[in.a + i]];
        const SceneReference& what = f_.outer[in.c];
        if (in.op == Op::Call) r_[in.dst] = run_function<V>(*std::get<FunctionPtr>(what), arguments, host_);
        else if (in.op == Op::Internal)
            r_[in.dst] =
                Rules<V>::internal(std::get<std::uint32_t>(what), in.b, arguments, host_,
                                   in.weights == Instruction::kNone ? nullptr : f_.octave_weights[in.weights].data());
        else Rules<V>::outer(what, arguments, host_, r_ + in.dst);
    }

    const Function& f_;
    V* r_;
    const Host& host_;
};

template <class V>
V run_function(const Function& f, const V* arguments, const Host& host)
{
    Frame<V> frame(f);
    V* r = frame.registers();
    for (std::uint32_t i = 0; i < f.parameters; ++i) r[f.first_parameter() + i] = arguments[i];
    Machine<V>(f, r, host).run(0, static_cast<std::uint32_t>(f.code.size()));
    return r[f.result];
}

}  // namespace function
