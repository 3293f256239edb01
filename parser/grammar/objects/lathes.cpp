#include "csg/freeform/freeform.h"
#include "parser/grammar/objects/spline_pieces.h"

#include <algorithm>

/// Curves turned about an axis (reference manual: Lathe, Surface of Revolution).
namespace parser {
namespace {

using scene::Curve;

/// One piece after the other, without loops (spec 5b, 7).
Pieces profile(Curve curve, const Points& p)
{
    Pieces pieces;
    if (curve == Curve::Linear)
        for (std::size_t i = 0; i + 1 < p.size(); ++i) pieces.push_back(csg::OutlinePiece::line(p[i], p[i + 1]));
    else if (curve == Curve::Quadratic)
        for (std::size_t i = 0; i + 2 < p.size(); ++i) pieces.push_back(quadratic_piece(p[i], p[i + 1], p[i + 2]));
    else if (curve == Curve::Cubic)
        for (std::size_t i = 0; i + 3 < p.size(); ++i)
            pieces.push_back(cubic_piece(p[i], p[i + 1], p[i + 2], p[i + 3]));
    else
        for (std::size_t i = 0; i + 3 < p.size(); i += 4)
            pieces.push_back(bezier_piece(p[i], p[i + 1], p[i + 2], p[i + 3]));
    return pieces;
}

scene::Freeform shape_of(const scene::Lathe& lathe)
{
    const Pieces pieces = profile(lathe.curve, lathe.points);
    // What POV-Ray takes for the curve's extremes: of a bezier spline those of its control points (spec 5b, 7.4).
    glm::dvec2 lower(numbers::kInfinity), upper(-numbers::kInfinity);
    const auto include = [&](const glm::dvec2& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    };
    if (lathe.curve == Curve::Bezier) {
        for (const glm::dvec2& p : lathe.points) include(p);
    } else {
        const csg::OutlineShape curve(pieces);
        include(curve.lower());
        include(curve.upper());
    }
    const csg::Aabb extent{{-upper.x, lower.y, -upper.x}, {upper.x, upper.y, upper.x}};
    return {csg::make_freeform<csg::Lathe>(pieces, extent, lower.x)};
}

void need_lathe_points(ParameterState<scene::Lathe>& s, int count)
{
    need_points(s, "lathe", s.solid.curve, count, {2, 3, 4});
}
using lathe_rule =
    seq<pegtl::star<curve_word<&scene::Lathe::curve>>, counted<&scene::Lathe::points, need_lathe_points>, sturms>;

void need_sor_points(BlockState& s, int count)
{
    if (count < 4) s.fail("a surface of revolution needs at least four points");
}
struct sor_points : counted<&scene::Sor::points, need_sor_points>, item_base {
    static void act(ParameterState<scene::Sor>& s)
    {
        const Points& points = s.solid.points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool between = i >= 2 && i + 1 < points.size();  // the first and the last are control points
            const bool level = i >= 2 && points[i].y == points[i - 2].y;
            if (points[i].x < 0.0 || level || (between && points[i].y <= points[i - 1].y))
                s.fail("the points of a surface of revolution must rise, none at a negative distance from the axis");
        }
    }
};
using sor_rule = seq<sor_points, open_and_sturm<&scene::Sor::open>>;

}  // namespace

Form parameters_form(const SolidReader*, const scene::Lathe*, Kind) { return form_of<lathe_rule>(); }
Form parameters_form(const SolidReader*, const scene::Sor*, Kind) { return form_of<sor_rule>(); }

bool read_parameters(SolidReader& s, scene::Lathe& lathe)
{
    read_solid<lathe_rule>(s, lathe);
    for (std::size_t i = 1; i + 1 < lathe.points.size(); ++i)  // the first and the last may, of every spline
        if (lathe.points[i].x < 0.0) s.fail("a point of a lathe lies at a negative distance from the axis");
    s.object().shape = shape_of(lathe);
    return true;
}

bool read_parameters(SolidReader& s, scene::Sor& sor)
{
    read_solid<sor_rule>(s, sor);
    s.object().shape = scene::Freeform{csg::make_freeform<csg::Sor>(sor.points, sor.open)};
    return true;
}

}  // namespace parser
