#pragma once

#include "csg/solids/shared/outline_shape.h"
#include "parser/grammar/core/solid_reader.h"

/// Splines of prisms and lathes (spec 5b, 6.1): their words, and the pieces that they are made of.
namespace parser {

using Points = std::vector<glm::dvec2>;
using Pieces = std::vector<csg::OutlinePiece>;

/// The words; of several the last one counts.
template <auto Member>
using curve_word = pegtl::sor<chosen<Kind::LinearSpline, Member, scene::Curve::Linear>,
                              chosen<Kind::QuadraticSpline, Member, scene::Curve::Quadratic>,
                              chosen<Kind::CubicSpline, Member, scene::Curve::Cubic>,
                              chosen<Kind::BezierSpline, Member, scene::Curve::Bezier>>;
/// Fails if a spline of `count` points is too short for `what`; least: of a linear, a quadratic, a cubic one.
void need_points(BlockState& s, const char* what, scene::Curve curve, int count, const int (&least)[3]);
/// From p1 to p2, leaving p1 in the direction of p2 - p0.
csg::OutlinePiece quadratic_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2);
/// From p1 to p2, a Catmull-Rom spline.
csg::OutlinePiece cubic_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2, const glm::dvec2& p3);
/// From p0 to p3.
csg::OutlinePiece bezier_piece(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2, const glm::dvec2& p3);

}  // namespace parser
