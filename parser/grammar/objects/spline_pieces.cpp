#include "parser/grammar/objects/spline_pieces.h"

#include <fmt/format.h>

namespace parser {

void need_points(BlockState& s, const char* what, scene::Curve curve, int count, const int (&least)[3])
{
    static constexpr const char* kNames[] = {"a linear", "a quadratic", "a cubic"};
    if (curve == scene::Curve::Bezier) {
        if (count < 4 || count % 4 != 0)
            s.fail(fmt::format("a {} with a bezier_spline needs four points for each segment", what));
        return;
    }
    const auto kind = static_cast<std::size_t>(curve);
    if (count < least[kind])
        s.fail(fmt::format("a {} with {} spline needs at least {} points", what, kNames[kind], least[kind]));
}

csg::OutlinePiece quadratic_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2)
{
    return {glm::dvec2(0.0), 0.5 * p0 - p1 + 0.5 * p2, 0.5 * (p2 - p0), p1, p1, p2};
}

csg::OutlinePiece cubic_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2, const glm::dvec2& p3)
{
    return {
        -0.5 * p0 + 1.5 * p1 - 1.5 * p2 + 0.5 * p3, p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3, 0.5 * (p2 - p0), p1, p1, p2};
}

csg::OutlinePiece bezier_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2, const glm::dvec2& p3)
{
    return {p3 - 3.0 * p2 + 3.0 * p1 - p0, 3.0 * p2 - 6.0 * p1 + 3.0 * p0, 3.0 * p1 - 3.0 * p0, p0, p0, p3};
}

}  // namespace parser
