#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

#include <fmt/format.h>

namespace parser {

using scene::Lemon;
using lemon_rule = seq<values<&Lemon::base, &Lemon::base_radius, &Lemon::cap, &Lemon::cap_radius, &Lemon::arc_radius>,
                       open_and_sturm<&Lemon::open>>;

Form parameters_form(const SolidReader*, const Lemon*, Kind) { return form_of<lemon_rule>(); }

bool read_parameters(SolidReader& s, Lemon& lemon)
{
    constexpr double kDegenerate = 1e-10;  // as of a cone
    read_solid<lemon_rule>(s, lemon);
    if (lemon.base_radius < 0.0 || lemon.cap_radius < 0.0 || lemon.arc_radius < 0.0)
        s.fail("the radii of a lemon must not be negative");
    const double height = glm::distance(lemon.base, lemon.cap);
    if (height < kDegenerate) s.fail("this lemon's ends are the same point");
    const double least = csg::Lemon::least_arc(lemon.base_radius, lemon.cap_radius, height);
    if (lemon.arc_radius < least) {
        s.in().warn(s.source(), fmt::format("this lemon's last radius is too small: it is {:.6g} now", least));
        lemon.arc_radius = least;
    }
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Lemon>(lemon.base, lemon.base_radius, lemon.cap,
                                                                      lemon.cap_radius, lemon.arc_radius, lemon.open)};
    return true;
}

}  // namespace parser
