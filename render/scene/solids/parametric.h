#pragma once

#include "function/program.h"
#include "render/scene/solids/container.h"

#include <array>
#include <string>

namespace scene {

/// A surface given by three functions of two parameters (reference manual: Parametric).
struct Parametric {
    static constexpr std::string_view kKeywords[] = {"parametric"};

    std::array<function::FunctionPtr, 3> function;   ///< x, y and z of u and v
    glm::dvec2 range[2] = {{0.0, 0.0}, {1.0, 1.0}};  ///< corners of the parameters' rectangle, as written
    Container container;
    double accuracy = 0.001;  ///< scene units; what is not above 0 was told and is the default
    double max_gradient = 1.0;
    int precompute = 0;       ///< levels, 1 to 20; 0: nothing is computed beforehand
    std::string precomputed;  ///< letters of the coordinates

    void dump(DumpWriter& out) const
    {
        const Parametric usual;
        for (const function::FunctionPtr& one : function) out.steps("function", one);
        out.words("range", range[0], range[1]);
        container.dump(out);
        out.changed("accuracy", accuracy, usual.accuracy);
        out.changed("max_gradient", max_gradient, usual.max_gradient);
        if (precompute == 0) return;
        std::string axes = std::to_string(precompute);
        for (const char axis : precomputed) axes.append(" \"").append(1, axis).append("\"");
        out.line("precompute", axes);
    }
};

}  // namespace scene
