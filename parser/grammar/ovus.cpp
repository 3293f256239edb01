#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"

namespace parser {

bool make_ovus(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    const auto& radii = item_of(statement, "")->operands;
    const double bottom = number_of(radii[0]), top = number_of(radii[1]);
    // Without room for an arc between its balls it is the upper one alone (spec 5a, 5.12).
    if (top >= 2.0 * bottom) object.shape = scene::Sphere{{0.0, bottom, 0.0}, top};
    else object.shape = scene::Freeform{csg::make_freeform<csg::Ovus>(bottom, top)};
    return true;
}

}  // namespace parser
