#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"

namespace parser {

bool make_superellipsoid(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    const glm::dvec2 powers = std::get<glm::dvec2>(statement.items.front().operands.front());
    object.shape = scene::Freeform{csg::make_freeform<csg::Superellipsoid>(powers.x, powers.y)};
    return true;
}

}  // namespace parser
