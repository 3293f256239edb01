#include "csg/freeform/freeform.h"
#include "parser/grammar/objects/spline_pieces.h"

#include <algorithm>

/// Regions between splines, swept (reference manual: Prism).
namespace parser {
namespace {

using scene::Curve;

bool same(const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) < kSamePoint; }

/// Loops of straight pieces, each closed by its start (spec 5b, 6.2).
Pieces straight(const Points& p)
{
    Pieces pieces;
    for (std::size_t first = 0; first < p.size();) {
        std::size_t last = first + 1;
        for (; last < p.size() && !same(p[first], p[last]); ++last)
            pieces.push_back(csg::OutlinePiece::line(p[last - 1], p[last]));
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
            pieces.push_back(cubic ? cubic_piece(p[i - 1], p[i], p[i + 1], p[i + 2])
                                   : quadratic_piece(p[i - 1], p[i], p[i + 1]));
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

/// Outlines of a linear prism close themselves; of the curved ones each begins with a control point and ends with one.
void check_outlines(ParameterState<scene::Prism>& s, Curve curve, const Points& p)
{
    if (curve == Curve::Linear) {
        for (std::size_t first = 0; first < p.size();) {
            std::size_t last = first + 1;
            while (last < p.size() && !same(p[first], p[last])) ++last;
            if (last >= p.size() && first + 1 < p.size())
                s.stream().warn_when_closed(s.reader.source(),
                                            "the outline of this prism is not closed: it is closed now");
            first = last + 1;
        }
    } else if (curve != Curve::Bezier) {
        const std::size_t after = curve == Curve::Cubic ? 1 : 0;  // control points behind an outline
        for (std::size_t first = 1; first < p.size();) {
            std::size_t last = first + 1;
            while (last < p.size() && !same(p[first], p[last])) ++last;
            if (last + after >= p.size()) s.fail("an outline of this prism is not closed, or lacks its control points");
            first = last + after + 2;
        }
    }
}

Pieces outline_of(const scene::Prism& prism)
{
    switch (prism.curve) {
    case Curve::Linear: return straight(prism.points);
    case Curve::Bezier: return bezier(prism.points);
    default: return curved(prism.points, prism.curve == Curve::Cubic);
    }
}

/// `pieces`: of the outline.
void make_shape(const scene::Prism& prism, Pieces pieces, scene::Object& object)
{
    const bool by_bezier = prism.curve == Curve::Bezier;
    const double low = std::min(prism.low, prism.high), high = std::max(prism.low, prism.high);
    const auto outline = std::make_shared<csg::OutlineShape>(std::move(pieces));
    if (prism.conic) {
        glm::dvec2 reach[2] = {outline->lower(), outline->upper()};
        for (const glm::dvec2& p : prism.points) {  // of Bezier curves POV-Ray takes the control points (spec 5b, 6.6)
            if (!by_bezier) break;
            reach[0] = glm::min(reach[0], p);
            reach[1] = glm::max(reach[1], p);
        }
        object.shape = scene::Freeform{csg::make_freeform<csg::ConicPrism>(outline, low, high, prism.open, reach)};
        return;
    }
    object.shape = scene::Extrusion{outline, low, high, prism.open, true, by_bezier};
    // Its points are (x, z), its heights y.
    csg::Transform& turn = object.transform.edit();
    turn.linear = turn.inverse_linear = glm::dmat3({1, 0, 0}, {0, 0, 1}, {0, 1, 0});
}

using scene::Prism;
void need_prism_points(ParameterState<Prism>& s, int count)
{
    need_points(s, "prism", s.solid.curve, count, {3, 5, 6});
}
struct outline : counted<&Prism::points, need_prism_points>, item_base {
    static void act(ParameterState<Prism>& s) { check_outlines(s, s.solid.curve, s.solid.points); }
};
using prism_rule =
    seq<pegtl::star<pegtl::sor<chosen<Kind::LinearSweep, &Prism::conic, false>,
                               chosen<Kind::ConicSweep, &Prism::conic, true>, curve_word<&Prism::curve>>>,
        values<&Prism::low, &Prism::high>, opt_comma, outline, open_and_sturm<&Prism::open>>;

}  // namespace

Form parameters_form(const SolidReader*, const Prism*, Kind) { return form_of<prism_rule>(); }

bool read_parameters(SolidReader& s, Prism& prism)
{
    read_solid<prism_rule>(s, prism);
    Pieces pieces = outline_of(prism);
    if (prism.curve == Curve::Bezier && pieces.empty())
        s.in().warn_when_closed(s.source(), "an outline of this prism is not closed: it is not drawn");
    make_shape(prism, std::move(pieces), s.object());
    return true;
}

}  // namespace parser
