#include "csg/freeform/freeform.h"
#include "parser/grammar/core/solid_reader.h"

#include <fmt/format.h>

namespace parser {
namespace {

using Spline = scene::SphereSweep::Spline;

Spline read_spline(SolidReader& s)
{
    if (s.accept(Kind::LinearSpline)) return Spline::Linear;
    if (s.accept(Kind::CubicSpline)) return Spline::Cubic;
    if (s.accept(Kind::BSpline)) return Spline::B;
    s.in().fail_expected("linear_spline, cubic_spline or b_spline");
}

}  // namespace

bool read_parameters(SolidReader& s, scene::SphereSweep& sweep)
{
    sweep.spline = read_spline(s);
    s.in().accept_comma();
    const int least = sweep.spline == Spline::Linear ? 2 : 4, count = read_count(s);
    if (count < least) s.fail(fmt::format("this sphere_sweep needs at least {} spheres", least));
    for (int i = 0; i < count; ++i) {
        s.in().accept_comma();
        auto& sphere = sweep.spheres.emplace_back();
        read_values(s.in(), sphere.center, sphere.radius);
    }
    read_one(s, sweep, std::tuple(field(Kind::Tolerance, &scene::SphereSweep::tolerance)));

    std::vector<csg::SphereSweep::SweptSphere> spheres;
    for (const auto& sphere : sweep.spheres) spheres.push_back({sphere.center, sphere.radius});
    static constexpr csg::SphereSweep::Spline kSplines[] = {
        csg::SphereSweep::Spline::Linear, csg::SphereSweep::Spline::Cubic, csg::SphereSweep::Spline::B};
    s.object().shape = scene::Freeform{csg::make_freeform<csg::SphereSweep>(
        kSplines[static_cast<std::size_t>(sweep.spline)], std::span<const csg::SphereSweep::SweptSphere>(spheres))};
    return true;
}

}  // namespace parser
