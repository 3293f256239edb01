#include "parser/grammar/statement.h"

#include <fmt/format.h>

/// Solids made of points along a curve (reference manual: prism, lathe, sor, sphere_sweep, polygon, ovus, superellipsoid).
namespace parser {
namespace {

enum class Curve { Linear, Quadratic, Cubic, Bezier };

bool accept_curve(StatementReader& s, Curve& curve)
{
    if (s.accept(Kind::LinearSpline)) curve = Curve::Linear;
    else if (s.accept(Kind::QuadraticSpline)) curve = Curve::Quadratic;
    else if (s.accept(Kind::CubicSpline)) curve = Curve::Cubic;
    else if (s.accept(Kind::BezierSpline)) curve = Curve::Bezier;
    else return false;
    return true;
}

/// The last word counts; those of a sweep may stand between if `sweeps`.
Curve read_curve(StatementReader& s, bool sweeps = false)
{
    Curve curve = Curve::Linear;
    for (;;) {
        if (sweeps && s.accept(Kind::LinearSweep)) s.add("linear_sweep");
        else if (sweeps && s.accept(Kind::ConicSweep)) s.add("conic_sweep");
        else if (!accept_curve(s, curve)) break;
    }
    static constexpr const char* kNames[] = {"linear_spline", "quadratic_spline", "cubic_spline", "bezier_spline"};
    s.add(kNames[static_cast<int>(curve)]);
    return curve;
}

int read_count(StatementReader& s)
{
    constexpr double kMost = 10'000'000;
    const double count = float_expr(s.in());
    if (!(count < kMost)) s.fail("this is too many points");
    return static_cast<int>(count);
}

/// A list of pairs or vectors, by what reads one.
template <class Point> std::vector<Point> read_points(StatementReader& s, int count, Point (*read)(TokenStream&, Level))
{
    std::vector<Point> points;
    std::vector<StatementReader::Operand> operands;
    for (int i = 0; i < count; ++i) {
        s.in().accept_comma();
        points.push_back(read(s.in(), Level::Sum));
        operands.emplace_back(points.back());
    }
    s.add("points", std::move(operands));
    return points;
}

void need_points(StatementReader& s, const char* what, Curve curve, int count, const int (&least)[3])
{
    static constexpr const char* kNames[] = {"a linear", "a quadratic", "a cubic"};
    if (curve == Curve::Bezier) {
        if (count < 4 || count % 4 != 0) s.fail(fmt::format("a {} with a bezier_spline needs four points for each segment", what));
        return;
    }
    const int wanted = least[static_cast<int>(curve)];
    if (count < wanted) s.fail(fmt::format("a {} with {} spline needs at least {} points", what, kNames[static_cast<int>(curve)], wanted));
}

void open_and_sturm(StatementReader& s, bool open)
{
    while (true) {
        if (open && s.accept(Kind::Open)) s.add("open");
        else if (s.accept(Kind::Sturm)) s.add("sturm", {optional_flag(s.in()) ? 1.0 : 0.0});
        else return;
    }
}

/// Outlines of a linear prism close themselves; of the curved ones each begins with a control point and ends with one.
void check_outlines(StatementReader& s, Curve curve, const std::vector<glm::dvec2>& p)
{
    const auto same = [&](std::size_t a, std::size_t b) { return glm::distance(p[a], p[b]) < kSamePoint; };
    if (curve == Curve::Linear) {
        for (std::size_t first = 0; first < p.size();) {
            std::size_t last = first + 1;
            while (last < p.size() && !same(first, last)) ++last;
            if (last >= p.size() && first + 1 < p.size()) s.in().warn(s.statement().source, "the outline of this prism is not closed: it is closed now");
            first = last + 1;
        }
    } else if (curve != Curve::Bezier) {
        const std::size_t after = curve == Curve::Cubic ? 1 : 0;  // control points behind an outline
        for (std::size_t first = 1; first < p.size();) {
            std::size_t last = first + 1;
            while (last < p.size() && !same(first, last)) ++last;
            if (last + after >= p.size()) s.fail("an outline of this prism is not closed, or lacks its control points");
            first = last + after + 2;
        }
    }
}

void prism(StatementReader& s)
{
    const Curve curve = read_curve(s, true);
    s.read("height", "ff");
    s.in().accept_comma();
    const int count = read_count(s);
    need_points(s, "prism", curve, count, {3, 5, 6});
    check_outlines(s, curve, read_points(s, count, vector2_expr));
    open_and_sturm(s, true);
}

void lathe(StatementReader& s)
{
    const Curve curve = read_curve(s);
    const int count = read_count(s);
    need_points(s, "lathe", curve, count, {2, 3, 4});
    const std::vector<glm::dvec2> points = read_points(s, count, vector2_expr);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)  // the first and the last may, of every spline
        if (points[i].x < 0.0) s.fail("a point of a lathe lies at a negative distance from the axis");
    open_and_sturm(s, false);
}

void sor(StatementReader& s)
{
    const int count = read_count(s);
    if (count < 4) s.fail("a surface of revolution needs at least four points");
    const std::vector<glm::dvec2> points = read_points(s, count, vector2_expr);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool between = i >= 2 && i + 1 < points.size();  // the first and the last are control points
        const bool level = i >= 2 && points[i].y == points[i - 2].y;
        if (points[i].x < 0.0 || level || (between && points[i].y <= points[i - 1].y))
            s.fail("the points of a surface of revolution must rise, none at a negative distance from the axis");
    }
    open_and_sturm(s, true);
}

void sphere_sweep(StatementReader& s)
{
    int least = 4;
    if (s.accept(Kind::LinearSpline)) s.add("linear_spline"), least = 2;
    else if (s.accept(Kind::CubicSpline)) s.add("cubic_spline");
    else if (s.accept(Kind::BSpline)) s.add("b_spline");
    else s.in().fail_expected("linear_spline, cubic_spline or b_spline");
    s.in().accept_comma();
    const int count = read_count(s);
    if (count < least) s.fail(fmt::format("this sphere_sweep needs at least {} spheres", least));
    for (int i = 0; i < count; ++i) {
        s.in().accept_comma();
        s.read("sphere", "vf");
    }
    static constexpr Form kForms[] = {{Kind::Tolerance, "f"}};
    s.read_one(kForms);
}

void polygon(StatementReader& s)
{
    const int count = read_count(s);
    if (count < 3) s.fail("a polygon needs at least three points");
    const std::vector<glm::dvec3> corners = read_points(s, count, vector_expr);
    bool closed = true;
    for (std::size_t first = 0; first < corners.size();) {
        std::size_t last = first + 1;
        while (last < corners.size() && glm::distance(corners[first], corners[last]) >= kSamePoint) ++last;
        closed = last < corners.size();
        first = last + 1;
    }
    if (!closed) s.in().warn(s.statement().source, "this polygon is not closed: it is closed now");
}

void ovus(StatementReader& s)
{
    auto radii = s.operands("ff");
    const double bottom = number_of(radii[0]), top = number_of(radii[1]);
    if (bottom < 0.0 || top < 0.0) s.fail("the radii of an ovus must not be negative");
    if (top >= 2.0 * bottom) s.in().warn(s.statement().source, "the second radius of this ovus is not below twice the first: it is a sphere");
    s.add("", std::move(radii));
    open_and_sturm(s, false);
}

void superellipsoid(StatementReader& s)
{
    s.read("", "p");
}

}  // namespace

HeadReader curve_head(Kind keyword)
{
    switch (keyword) {
    case Kind::Prism: return prism;
    case Kind::Lathe: return lathe;
    case Kind::Sor: return sor;
    case Kind::SphereSweep: return sphere_sweep;
    case Kind::Polygon: return polygon;
    case Kind::Ovus: return ovus;
    case Kind::Superellipsoid: return superellipsoid;
    default: return nullptr;
    }
}

}  // namespace parser
