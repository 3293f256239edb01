#pragma once

#include "function/program.h"

#include <optional>

namespace function {

/// A function that is one call of the library on its own parameters and constants, as f_sphere(x, y, z, 2) is: answered
/// without a frame of registers.
class LoneInternal {
public:
    explicit LoneInternal(const Function& f) : f_(f), is_(f.code.size() == 1 && f.code[0].op == Op::Internal) {}

    explicit operator bool() const { return is_; }
    std::uint32_t number() const { return *std::get_if<std::uint32_t>(&f_.outer[f_.code[0].c]); }
    std::uint32_t count() const { return f_.code[0].b; }
    const double* weights() const
    {
        const std::uint32_t at = f_.code[0].weights;
        return at == Instruction::kNone ? nullptr : f_.octave_weights[at].data();
    }

    /// Its argument i: parameter(which of the function's), or a constant.
    template <class V, class Parameter>
    V argument(std::uint32_t i, Parameter&& parameter) const
    {
        const std::uint32_t place = f_.arguments[f_.code[0].a + i], constants = f_.first_parameter();
        return place < constants ? V(f_.constants[place]) : parameter(place - constants);
    }

    /// Its argument i, if that is known.
    std::optional<double> constant(std::uint32_t i) const
    {
        const std::uint32_t place = f_.arguments[f_.code[0].a + i];
        if (place < f_.first_parameter()) return f_.constants[place];
        return {};
    }

    static constexpr std::size_t kMostArguments = 16;

private:
    const Function& f_;
    bool is_;
};

}  // namespace function
