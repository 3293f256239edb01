#pragma once

#include "csg/outline_shape.h"
#include "parser/grammar/statement.h"

/// Pieces of the splines of prisms and lathes (spec 5b, 6.1).
namespace parser {

using Points = std::vector<glm::dvec2>;
using Pieces = std::vector<csg::OutlinePiece>;

/// The statement's points.
Points points_of(const scene::Statement& statement);
/// From p1 to p2, leaving p1 in the direction of p2 - p0.
csg::OutlinePiece quadratic_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2);
/// From p1 to p2, a Catmull-Rom spline.
csg::OutlinePiece cubic_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2, const glm::dvec2& p3);
/// From p0 to p3.
csg::OutlinePiece bezier_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2, const glm::dvec2& p3);

}  // namespace parser
