#include "csg/outline_shape.h"

#include <algorithm>
#include <cmath>

namespace csg {

OutlinePiece OutlinePiece::quadratic(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2)
{
    return {{}, p0 - 2.0 * p1 + p2, 2.0 * (p1 - p0), p0, p0, p2};
}

OutlineShape::OutlineShape(std::vector<OutlinePiece> pieces) : pieces_(std::move(pieces))
{
    if (pieces_.empty()) return;
    lower_ = glm::dvec2(kInfinity);
    upper_ = glm::dvec2(-kInfinity);
    for (const OutlinePiece& piece : pieces_) {
        glm::dvec2 lower = glm::min(piece.start, piece.end), upper = glm::max(piece.start, piece.end);
        for (int k = 0; k < 2; ++k) {
            double turns[2];
            const int n = inner_roots(3.0 * piece.a[k], 2.0 * piece.b[k], piece.c[k], turns);
            for (int i = 0; i < n; ++i) {
                lower[k] = std::min(lower[k], piece.at(turns[i])[k]);
                upper[k] = std::max(upper[k], piece.at(turns[i])[k]);
            }
        }
        lower_ = glm::min(lower_, lower);
        upper_ = glm::max(upper_, upper);
        // More than the roundings of what is compared with it.
        const glm::dvec2 size = glm::max(glm::abs(lower), glm::abs(upper));
        const double margin = 1e-12 * (size.x + size.y);
        reach_.push_back({0.5 * (lower + upper), 0.5 * (upper - lower) + margin});
        most_ += piece.a != glm::dvec2(0.0) ? 3 : piece.b != glm::dvec2(0.0) ? 2 : 1;
    }
}

bool OutlineShape::contains(const glm::dvec2& p) const
{
    if (!(p.x >= lower_.x && p.x <= upper_.x && p.y >= lower_.y && p.y <= upper_.y)) return false;
    bool inside = false;
    crossings({0.0, 1.0}, p.y, [&](double w, std::uint32_t piece) {
        if (pieces_[piece].at(w).x >= p.x) inside = !inside;
    });
    return inside;
}

double OutlineShape::parameter(std::uint32_t index, const glm::dvec2& p) const
{
    const OutlinePiece& piece = pieces_[index];
    const glm::dvec2 along = piece.end - piece.start;
    if (piece.a == glm::dvec2(0.0) && piece.b == glm::dvec2(0.0)) return glm::dot(p - piece.start, along) / glm::dot(along, along);
    // Nearest of a few points, then the foot of the perpendicular.
    constexpr int kSteps = 16;
    double best = 0.0, least = kInfinity;
    for (int i = 0; i <= kSteps; ++i) {
        const double w = static_cast<double>(i) / kSteps;
        const glm::dvec2 off = piece.at(w) - p;
        if (glm::dot(off, off) < least) least = glm::dot(off, off), best = w;
    }
    for (int i = 0; i < 8; ++i) {
        const glm::dvec2 slope = piece.slope(best);
        const double square = glm::dot(slope, slope);
        if (!(square > 0.0)) break;
        const double step = glm::dot(((piece.a * best + piece.b) * best + piece.c) * best + piece.d - p, slope) / square;
        best = glm::clamp(best - step, 0.0, 1.0);
        if (std::abs(step) < 1e-15) break;
    }
    return best;
}

}  // namespace csg
