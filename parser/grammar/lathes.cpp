#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"
#include "parser/grammar/spline_pieces.h"

#include <algorithm>

/// Curves turned about an axis (reference manual: Lathe, Surface of Revolution).
namespace parser {
namespace {

/// One piece after the other, without loops (spec 5b, 7).
Pieces profile(const scene::Statement& statement, const Points& p)
{
    Pieces pieces;
    if (item_of(statement, "linear_spline"))
        for (std::size_t i = 0; i + 1 < p.size(); ++i) pieces.push_back(csg::OutlinePiece::line(p[i], p[i + 1]));
    else if (item_of(statement, "quadratic_spline"))
        for (std::size_t i = 0; i + 2 < p.size(); ++i) pieces.push_back(quadratic_piece(p[i], p[i + 1], p[i + 2]));
    else if (item_of(statement, "cubic_spline"))
        for (std::size_t i = 0; i + 3 < p.size(); ++i) pieces.push_back(cubic_piece(p[i], p[i + 1], p[i + 2], p[i + 3]));
    else
        for (std::size_t i = 0; i + 3 < p.size(); i += 4) pieces.push_back(bezier_piece(p[i], p[i + 1], p[i + 2], p[i + 3]));
    return pieces;
}

}  // namespace

bool make_lathe(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    const Points points = points_of(statement);
    const Pieces pieces = profile(statement, points);
    // What POV-Ray takes for the curve's extremes: of a bezier spline those of its control points (spec 5b, 7.4).
    glm::dvec2 lower(csg::kInfinity), upper(-csg::kInfinity);
    const auto include = [&](const glm::dvec2& p) {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    };
    if (item_of(statement, "bezier_spline")) {
        for (const glm::dvec2& p : points) include(p);
    } else {
        const csg::OutlineShape curve(pieces);
        include(curve.lower());
        include(curve.upper());
    }
    const csg::Aabb extent{{-upper.x, lower.y, -upper.x}, {upper.x, upper.y, upper.x}};
    object.shape = scene::Freeform{csg::make_freeform<csg::Lathe>(pieces, extent, lower.x)};
    return true;
}

bool make_sor(SceneBuilder&, const scene::Statement& statement, scene::Object& object)
{
    object.shape = scene::Freeform{csg::make_freeform<csg::Sor>(points_of(statement), item_of(statement, "open") != nullptr)};
    return true;
}

}  // namespace parser
