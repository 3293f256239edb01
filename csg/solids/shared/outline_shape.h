#pragma once

#include "csg/base/types.h"

#include <cstdint>
#include <vector>

namespace csg {

/// A piece of an outline: a w^3 + b w^2 + c w + d for w from 0 to 1, from `start` to `end`. Pieces that meet share the
/// point itself, so that a ray passes between them on one side or the other.
struct OutlinePiece {
    glm::dvec2 a{0.0}, b{0.0}, c{0.0}, d{0.0};
    glm::dvec2 start{0.0}, end{0.0};

    static OutlinePiece line(const glm::dvec2& from, const glm::dvec2& to)
    {
        return {{}, {}, to - from, from, from, to};
    }
    /// Bezier curves of degree 2 and 3.
    static OutlinePiece quadratic(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2)
    {
        return {{}, p0 - 2.0 * p1 + p2, 2.0 * (p1 - p0), p0, p0, p2};
    }
    bool straight() const { return a == glm::dvec2(0.0) && b == glm::dvec2(0.0); }
    glm::dvec2 at(double w) const { return w <= 0.0 ? start : w >= 1.0 ? end : ((a * w + b) * w + c) * w + d; }
    glm::dvec2 slope(double w) const { return (3.0 * a * w + 2.0 * b) * w + c; }
};

/// A plane region between closed outlines, by the even-odd rule. Immutable; shared by all instances.
class OutlineShape {
public:
    /// Every outline is closed: the pieces' ends and starts pair off.
    explicit OutlineShape(std::vector<OutlinePiece> pieces);

    bool empty() const { return pieces_.empty(); }
    const std::vector<OutlinePiece>& pieces() const { return pieces_; }
    const glm::dvec2& lower() const { return lower_; }
    const glm::dvec2& upper() const { return upper_; }
    bool contains(const glm::dvec2& p) const;
    /// No line crosses the outlines more often.
    std::uint32_t most_crossings() const { return most_; }
    /// The parameter of a point on a piece.
    double parameter(std::uint32_t piece, const glm::dvec2& p) const;

    /// Eight pieces in a row, a lane each; the last block is filled up with some that no line crosses.
    struct alignas(64) Block {
        static constexpr std::size_t kPieces = 8;
        double start[2][kPieces], end[2][kPieces];    ///< x, then y
        double middle[2][kPieces], half[2][kPieces];  ///< of a box, a little larger than the piece
        std::uint32_t curved;                         ///< a bit a piece: it may cross a line with both ends on one side
    };
    const std::vector<Block>& blocks() const { return blocks_; }
    /// The box of every block, eight boxes an element; empty where there are too few to be worth it.
    struct alignas(64) Boxes {
        double middle[2][Block::kPieces], half[2][Block::kPieces];
    };
    const std::vector<Boxes>& boxes() const { return boxes_; }

private:
    void add_blocks(const std::vector<glm::dvec2>& lower, const std::vector<glm::dvec2>& upper);

    std::vector<OutlinePiece> pieces_;
    std::vector<Block> blocks_;
    std::vector<Boxes> boxes_;
    glm::dvec2 lower_{0.0}, upper_{0.0};
    std::uint32_t most_ = 0;
};

/// Roots of a quadratic inside (0, 1), in order.
inline int inner_roots(double a, double b, double c, double (&out)[2])
{
    int n = 0;
    const auto keep = [&](double w) {
        if (w > 0.0 && w < 1.0) out[n++] = w;
    };
    if (a == 0.0) {
        if (b != 0.0) keep(-c / b);
        return n;
    }
    const double discriminant = b * b - 4.0 * a * c;
    if (!(discriminant > 0.0)) return 0;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    const double r0 = q / a, r1 = q != 0.0 ? c / q : 0.0;
    keep(glm::min(r0, r1));
    keep(glm::max(r0, r1));
    return n;
}

}  // namespace csg
