#pragma once

#include "render/scene/base/dump_writer.h"

#include <cstdint>
#include <optional>

namespace scene {

/// A slice of a four-dimensional Julia set (reference manual: Julia Fractal).
struct JuliaFractal {
    static constexpr std::string_view kKeywords[] = {"julia_fractal"};
    static constexpr bool kForgetsInverse =
        true;  ///< in 3.7 at the end of its block and wherever it is moved (spec 5b, 12.4)

    enum class Function : std::uint8_t {
        Sqr,
        Cube,
        Reciprocal,
        Exp,
        Ln,
        Sin,
        Asin,
        Cos,
        Acos,
        Tan,
        Atan,
        Sinh,
        Asinh,
        Cosh,
        Acosh,
        Tanh,
        Atanh,
        Pwr
    };
    static constexpr std::string_view kFunctions[] = {"sqr",   "cube", "reciprocal", "exp",  "ln",    "sin",
                                                      "asin",  "cos",  "acos",       "tan",  "atan",  "sinh",
                                                      "asinh", "cosh", "acosh",      "tanh", "atanh", "pwr"};

    glm::dvec4 constant{0.0};
    bool hypercomplex = false;  ///< else quaternions, which have sqr and cube alone
    Function function = Function::Sqr;
    glm::dvec2 exponent{0.0};         ///< of Pwr
    int max_iteration = 20;           ///< above 0
    double precision = 20.0;          ///< at least 1
    std::optional<glm::dvec4> slice;  ///< normal, its fourth component not 0; unwritten: <0, 0, 0, 1>
    double slice_distance = 0.0;

    void dump(DumpWriter& out) const
    {
        const JuliaFractal usual;
        const std::string_view name = kFunctions[static_cast<std::size_t>(function)];
        out.words("-", constant);
        out.word(hypercomplex ? "hypercomplex" : "quaternion");
        if (function == Function::Pwr) out.words(name, exponent.x, exponent.y);
        else out.word(name);
        out.changed("max_iteration", max_iteration, usual.max_iteration);
        out.changed("precision", precision, usual.precision);
        if (slice) out.words("slice", *slice, slice_distance);
    }
};

}  // namespace scene
