#include "csg/solids/shared/outline_crossings.h"

#include <algorithm>
#include <cmath>

namespace csg {

OutlineShape::OutlineShape(std::vector<OutlinePiece> pieces) : pieces_(std::move(pieces))
{
    if (pieces_.empty()) return;
    lower_ = glm::dvec2(kInfinity);
    upper_ = glm::dvec2(-kInfinity);
    std::vector<glm::dvec2> lowers, uppers;
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
        lowers.push_back(lower);
        uppers.push_back(upper);
        most_ += piece.a != glm::dvec2(0.0) ? 3 : piece.b != glm::dvec2(0.0) ? 2 : 1;
    }
    add_blocks(lowers, uppers);
}

void OutlineShape::add_blocks(const std::vector<glm::dvec2>& lower, const std::vector<glm::dvec2>& upper)
{
    constexpr std::size_t kEight = Block::kPieces, kFewBlocks = 3;
    // `into` is told of a box that holds those from `first` to `last`, larger by more than the roundings of what is
    // compared with it.
    const auto box = [&](auto& into, std::size_t lane, std::size_t first, std::size_t last) {
        glm::dvec2 low = lower[first], high = upper[first];
        for (std::size_t i = first + 1; i < last; ++i) low = glm::min(low, lower[i]), high = glm::max(high, upper[i]);
        const glm::dvec2 size = glm::max(glm::abs(low), glm::abs(high));
        const double margin = 1e-12 * (size.x + size.y);
        for (int k = 0; k < 2; ++k) {
            into.middle[k][lane] = 0.5 * (low[k] + high[k]);
            into.half[k][lane] = 0.5 * (high[k] - low[k]) + margin;
        }
    };
    blocks_.assign((pieces_.size() + kEight - 1) / kEight, Block{});
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        Block& block = blocks_[i / kEight];
        const std::size_t lane = i % kEight;
        const OutlinePiece& piece = pieces_[i];
        for (int k = 0; k < 2; ++k) {
            block.start[k][lane] = piece.start[k];
            block.end[k][lane] = piece.end[k];
        }
        box(block, lane, i, i + 1);
        if (!piece.straight()) block.curved |= 1u << lane;
    }
    if (blocks_.size() < kFewBlocks) return;
    boxes_.assign((blocks_.size() + kEight - 1) / kEight, Boxes{});
    for (std::size_t b = 0; b < blocks_.size(); ++b)
        box(boxes_[b / kEight], b % kEight, b * kEight, std::min((b + 1) * kEight, pieces_.size()));
}

/// By what crosses the row of the point on its left: nothing is asked but of pieces whose box holds the point's column.
bool OutlineShape::contains(const glm::dvec2& p) const
{
    if (!(p.x >= lower_.x && p.x <= upper_.x && p.y >= lower_.y && p.y <= upper_.y)) return false;
    OutlineLine row{{0.0, 1.0}, p.y, {1.0, 0.0}, p.x, p.x};
    bool inside = false;
    const bool before = outline_crossings(*this, row, [&](double w, std::uint32_t piece) {
        if (pieces_[piece].at(w).x < p.x) inside = !inside;
    });
    return inside != before;
}

double OutlineShape::parameter(std::uint32_t index, const glm::dvec2& p) const
{
    const OutlinePiece& piece = pieces_[index];
    const glm::dvec2 along = piece.end - piece.start;
    if (piece.straight()) return glm::dot(p - piece.start, along) / glm::dot(along, along);
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
        const double step = glm::dot(((piece.a * best + piece.b) * best + piece.c) * best + piece.d - p, slope) /
                            square;
        best = glm::clamp(best - step, 0.0, 1.0);
        if (std::abs(step) < 1e-15) break;
    }
    return best;
}

}  // namespace csg
