#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"

#include <algorithm>

namespace parser {

/// reference manual: bicubic_patch; spec 5b, 5. Types 0 and 1 draw the same.
bool make_bicubic_patch(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    csg::BicubicPatch::Input input;
    const auto number = [&](const char* name) {
        const scene::StatementItem* item = item_of(statement, name);
        return item ? number_of(item->operands[0]) : 0.0;
    };
    const auto steps = [&](const char* name) { return number(name) > 0.0 ? static_cast<int>(std::min<double>(number(name), csg::BicubicPatch::kMostSteps)) : 0; };
    input.flatness = number("flatness");
    input.u_steps = steps("u_steps");
    input.v_steps = steps("v_steps");
    if (const scene::StatementItem* uv = item_of(statement, "uv_vectors"))
        for (std::size_t k = 0; k < 4; ++k) input.uv[k] = std::get<glm::dvec2>(uv->operands[k]);
    const auto& points = item_of(statement, "points")->operands;
    for (std::size_t k = 0; k < 16; ++k) input.points[k / 4][k % 4] = std::get<glm::dvec3>(points[k]);
    object.shape = scene::Freeform{csg::make_freeform<csg::BicubicPatch>(input, csg::BicubicPatch::Later::Divide)};
    return true;
}

}  // namespace parser
