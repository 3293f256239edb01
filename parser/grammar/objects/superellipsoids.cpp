#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

namespace parser {

using superellipsoid_rule = values<&scene::Superellipsoid::powers>;

Form parameters_form(const SolidReader*, const scene::Superellipsoid*, Kind) { return form_of<superellipsoid_rule>(); }

bool read_parameters(SolidReader& s, scene::Superellipsoid& solid)
{
    read_solid<superellipsoid_rule>(s, solid);
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Superellipsoid>(solid.powers.x, solid.powers.y)};
    return true;
}

}  // namespace parser
