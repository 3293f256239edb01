#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

#include <cmath>

namespace parser {
namespace {

using scene::Ovus;
using ovus_rule =
    seq<values<&Ovus::bottom, &Ovus::top>,
        pegtl::star<pegtl::sor<member<Kind::Radius, &Ovus::radius>, member<Kind::Distance, &Ovus::distance>,
                               member<Kind::Precision, &Ovus::precision>>>,
        sturms>;

scene::Shape sphere_at(double height, double radius) { return scene::Sphere{{0.0, height, 0.0}, radius}; }

/// As POV-Ray 3.8 draws it (spec 7c, 2): the spheres' distance and the arc's radius are free.
void make_egg(SolidReader& s, const Ovus& ovus)
{
    const double b = ovus.bottom, t = ovus.top, apart = ovus.used_distance(), arc = ovus.used_radius();
    if (!(b > 0.0)) s.fail("the first radius of an ovus must be above 0");
    if (apart < b) s.fail("the distance of an ovus must not be below its first radius");
    const double least = 0.5 * (b + t + apart);
    if (arc < least) s.fail("the radius of an ovus must be at least half of the sum of its other three lengths");
    if (t > apart + b) {
        s.in().warn(
            s.source(),
            "the second sphere of this ovus holds the first: POV-Ray 3.8 draws nothing of it, here it is a sphere");
        s.object().shape = sphere_at(apart, t);
        return;
    }
    const double from_bottom = arc - b, from_top = arc - t;
    const double height = 0.5 * ((from_bottom - from_top) * (from_bottom + from_top) / apart + apart);
    if (from_bottom <= std::abs(height)) {
        s.in().warn(s.source(), "the arc of this ovus is a half circle about its axis: it is a sphere");
        s.object().shape = sphere_at(height, arc);
        return;
    }
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Ovus>(b, t, apart, arc)};
}

}  // namespace

Form parameters_form(const SolidReader*, const Ovus*, Kind) { return form_of<ovus_rule>(); }

bool read_parameters(SolidReader& s, Ovus& ovus)
{
    read_solid<ovus_rule>(s, ovus);
    if (ovus.bottom < 0.0 || ovus.top < 0.0) s.fail("the radii of an ovus must not be negative");
    if (s.in().povray() == scene::PovRay::V38 || ovus.radius || ovus.distance) {
        make_egg(s, ovus);
        return true;
    }
    if (ovus.is_sphere())
        s.in().warn(s.source(), "the second radius of this ovus is not below twice the first: it is a sphere");
    if (ovus.is_sphere()) s.object().shape = sphere_at(ovus.bottom, ovus.top);
    else s.object().shape = scene::Freeform{csg::make_freeform<csg::Ovus>(ovus.bottom, ovus.top)};
    return true;
}

}  // namespace parser
