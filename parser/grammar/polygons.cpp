#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"
#include "parser/grammar/statement.h"

namespace parser {
bool make_polygon(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    std::vector<glm::dvec3> corners;
    std::size_t first = 0;
    for (const auto& operand : item_of(statement, "points")->operands) {
        corners.push_back(std::get<glm::dvec3>(operand));
        const glm::dvec3 apart = glm::abs(corners.back() - corners[first]);
        if (corners.size() - 1 == first || glm::max(apart.x, glm::max(apart.y, apart.z)) >= kSamePoint) continue;
        corners.back() = corners[first];  // closed: the next corner begins another loop
        first = corners.size();
    }
    if (first < corners.size()) corners.push_back(corners[first]);
    object.shape = scene::Freeform{csg::make_freeform<csg::Polygon>(std::move(corners))};
    return true;
}

}  // namespace parser
