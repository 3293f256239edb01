#pragma once

#include "function/program.h"
#include "render/scene/solids/container.h"

#include <optional>

namespace scene {

/// Where a function is not above a threshold, inside of a container (reference manual: Isosurface).
struct Isosurface {
    static constexpr std::string_view kKeywords[] = {"isosurface"};

    static constexpr int kMostTraced = 10;
    function::FunctionPtr function;  ///< of x, y and z
    Container container;
    double threshold = 0.0;
    double accuracy = 0.001;             ///< scene units; what is not above 0 was told and is the default
    double max_gradient = 1.1;           ///< the like
    std::optional<glm::dvec3> evaluate;  ///< how max_gradient grows: least, factor, share kept
    int max_trace = 1;                   ///< crossings drawn on one ray, 1 to kMostTraced
    bool all_intersections = false;      ///< written so: kMostTraced of them
    bool open = false;                   ///< the container's wall is not drawn
    double polarity = 0.0;               ///< above 0: inside is where the function is not below the threshold

    void dump(DumpWriter& out) const
    {
        const Isosurface usual;
        out.steps("function", function);
        container.dump(out);
        out.changed("threshold", threshold, usual.threshold);
        out.changed("accuracy", accuracy, usual.accuracy);
        out.changed("max_gradient", max_gradient, usual.max_gradient);
        if (evaluate) out.words("evaluate", evaluate->x, evaluate->y, evaluate->z);
        if (all_intersections) out.word("all_intersections");
        else out.changed("max_trace", max_trace, usual.max_trace);
        if (open) out.word("open");
        out.changed("polarity", polarity, usual.polarity);
    }
};

}  // namespace scene
