#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"
#include "parser/grammar/spline_pieces.h"

#include <algorithm>

/// Regions between splines, swept (reference manual: Prism).
namespace parser {
namespace {

using scene::StatementItem;

bool same(const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) < kSamePoint; }

/// Loops of straight pieces, each closed by its start (spec 5b, 6.2).
Pieces straight(const Points& p)
{
    Pieces pieces;
    for (std::size_t first = 0; first < p.size();) {
        std::size_t last = first + 1;
        for (; last < p.size() && !same(p[first], p[last]); ++last) pieces.push_back(csg::OutlinePiece::line(p[last - 1], p[last]));
        if (last > first + 1) pieces.push_back(csg::OutlinePiece::line(p[last - 1], p[first]));
        first = last + 1;
    }
    return pieces;
}

/// Quadratic and cubic loops: a control point before, for cubic ones another behind (spec 5b, 6.1).
Pieces curved(const Points& p, bool cubic)
{
    Pieces pieces;
    const std::size_t behind = cubic ? 1 : 0;
    for (std::size_t first = 1; first + 1 < p.size();) {
        const std::size_t begin = pieces.size();
        std::size_t i = first;
        for (; i + 1 + behind < p.size(); ++i) {
            pieces.push_back(cubic ? cubic_piece(p[i - 1], p[i], p[i + 1], p[i + 2]) : quadratic_piece(p[i - 1], p[i], p[i + 1]));
            if (same(p[i + 1], p[first])) {
                pieces.back().end = pieces[begin].start;
                break;
            }
        }
        first = i + 2 + behind + 1;
    }
    return pieces;
}

/// Groups of four; each runs from its last point to its first (spec 5b, 6.1). Empty where a loop is not closed.
Pieces bezier(const Points& p)
{
    Pieces pieces;
    std::size_t loop = 0;
    for (std::size_t i = 0; i + 3 < p.size(); i += 4) {
        pieces.push_back(bezier_piece(p[i + 3], p[i + 2], p[i + 1], p[i]));
        const bool joined = i > loop && same(p[i - 1], p[i]);
        if (i > loop && !joined) return {};
        if (joined) pieces[pieces.size() - 2].start = pieces.back().end;
        if (!same(p[i + 3], p[loop])) continue;
        pieces.back().start = pieces[loop / 4].end;
        loop = i + 4;
    }
    return loop == p.size() ? pieces : Pieces();
}

}  // namespace

bool make_prism(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    bool conic = false;
    for (const StatementItem& one : statement.items) conic = one.name == "conic_sweep" || (conic && one.name != "linear_sweep");
    const Points points = points_of(statement);
    const bool by_bezier = item_of(statement, "bezier_spline") != nullptr, open = item_of(statement, "open") != nullptr;
    Pieces pieces = item_of(statement, "linear_spline") ? straight(points)
                    : by_bezier                      ? bezier(points)
                                                     : curved(points, item_of(statement, "cubic_spline") != nullptr);
    if (by_bezier && pieces.empty()) build.stream().warn(statement.source, "an outline of this prism is not closed: it is not drawn");
    const auto& heights = item_of(statement, "height")->operands;
    const double a = number_of(heights[0]), b = number_of(heights[1]), low = std::min(a, b), high = std::max(a, b);
    const auto outline = std::make_shared<csg::OutlineShape>(std::move(pieces));
    if (conic) {
        glm::dvec2 reach[2] = {outline->lower(), outline->upper()};
        for (const glm::dvec2& p : points) {  // of Bezier curves POV-Ray takes the control points (spec 5b, 6.6)
            if (!by_bezier) break;
            reach[0] = glm::min(reach[0], p);
            reach[1] = glm::max(reach[1], p);
        }
        object.shape = scene::Freeform{csg::make_freeform<csg::ConicPrism>(outline, low, high, open, reach)};
        return true;
    }
    object.shape = scene::Extrusion{outline, low, high, open, true, by_bezier};
    // Its points are (x, z), its heights y.
    csg::Transform& turn = object.transform;
    turn.linear = turn.inverse_linear = glm::dmat3({1, 0, 0}, {0, 0, 1}, {0, 1, 0});
    return true;
}

}  // namespace parser
