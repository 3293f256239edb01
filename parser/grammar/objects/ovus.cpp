#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

namespace parser {
namespace {

using ovus_rule = seq<values<&scene::Ovus::bottom, &scene::Ovus::top>, sturms>;

}  // namespace

Form parameters_form(const SolidReader*, const scene::Ovus*, Kind) { return form_of<ovus_rule>(); }

bool read_parameters(SolidReader& s, scene::Ovus& ovus)
{
    read_solid<ovus_rule>(s, ovus);
    if (ovus.bottom < 0.0 || ovus.top < 0.0) s.fail("the radii of an ovus must not be negative");
    if (ovus.is_sphere())
        s.in().warn(s.source(), "the second radius of this ovus is not below twice the first: it is a sphere");
    if (ovus.is_sphere()) s.object().shape = scene::Sphere{{0.0, ovus.bottom, 0.0}, ovus.top};
    else s.object().shape = scene::Freeform{csg::make_freeform<csg::Ovus>(ovus.bottom, ovus.top)};
    return true;
}

}  // namespace parser
