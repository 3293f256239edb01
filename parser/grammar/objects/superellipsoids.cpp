#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

namespace parser {

bool read_parameters(SolidReader& s, scene::Superellipsoid& solid)
{
    read_value(s.in(), solid.powers);
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Superellipsoid>(solid.powers.x, solid.powers.y)};
    return true;
}

}  // namespace parser
