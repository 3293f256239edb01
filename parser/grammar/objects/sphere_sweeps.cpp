#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

#include <fmt/format.h>

namespace parser {

using Swept = scene::SphereSweep::SweptSphere;
static void read_value(TokenStream& in, Swept& sphere) { read_values(in, sphere.center, sphere.radius); }
template <>
struct forms::value<Swept> {
    static Form form() { return form_of<seq<a_vector, opt_comma, a_number>>(); }
};

namespace {

using Spline = scene::SphereSweep::Spline;

using scene::SphereSweep;
struct sweep_spline : pegtl::sor<chosen<Kind::LinearSpline, &SphereSweep::spline, Spline::Linear>,
                                 chosen<Kind::CubicSpline, &SphereSweep::spline, Spline::Cubic>,
                                 chosen<Kind::BSpline, &SphereSweep::spline, Spline::B>> {};
void need_spheres(ParameterState<SphereSweep>& s, int count)
{
    const int least = s.solid.spline == Spline::Linear ? 2 : 4;
    if (count < least) s.fail(fmt::format("this sphere_sweep needs at least {} spheres", least));
}
using sweep_rule = seq<must<sweep_spline>, opt_comma, counted<&SphereSweep::spheres, need_spheres>,
                       opt<member<Kind::Tolerance, &SphereSweep::tolerance>>>;

}  // namespace

template <>
inline constexpr auto expected<sweep_spline> = "linear_spline, cubic_spline or b_spline";

Form parameters_form(const SolidReader*, const SphereSweep*, Kind) { return form_of<sweep_rule>(); }

bool read_parameters(SolidReader& s, SphereSweep& sweep)
{
    read_solid<sweep_rule>(s, sweep);
    std::vector<csg::SphereSweep::SweptSphere> spheres;
    for (const auto& sphere : sweep.spheres) spheres.push_back({sphere.center, sphere.radius});
    static constexpr csg::SphereSweep::Spline kSplines[] = {
        csg::SphereSweep::Spline::Linear, csg::SphereSweep::Spline::Cubic, csg::SphereSweep::Spline::B};
    s.object().shape = scene::Freeform{csg::make_freeform<csg::SphereSweep>(
        kSplines[static_cast<std::size_t>(sweep.spline)], std::span<const csg::SphereSweep::SweptSphere>(spheres))};
    return true;
}

}  // namespace parser
