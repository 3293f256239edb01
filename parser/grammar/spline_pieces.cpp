#include "parser/grammar/spline_pieces.h"

namespace parser {

Points points_of(const scene::Statement& statement)
{
    Points points;
    for (const auto& p : item_of(statement, "points")->operands) points.push_back(std::get<glm::dvec2>(p));
    return points;
}

csg::OutlinePiece quadratic_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2)
{
    return {glm::dvec2(0.0), 0.5 * p0 - p1 + 0.5 * p2, 0.5 * (p2 - p0), p1, p1, p2};
}

csg::OutlinePiece cubic_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2, const glm::dvec2& p3)
{
    return {-0.5 * p0 + 1.5 * p1 - 1.5 * p2 + 0.5 * p3, p0 - 2.5 * p1 + 2.0 * p2 - 0.5 * p3, 0.5 * (p2 - p0), p1, p1, p2};
}

csg::OutlinePiece bezier_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2, const glm::dvec2& p3)
{
    return {p3 - 3.0 * p2 + 3.0 * p1 - p0, 3.0 * p2 - 6.0 * p1 + 3.0 * p0, 3.0 * p1 - 3.0 * p0, p0, p0, p3};
}

}  // namespace parser
