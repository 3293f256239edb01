#include "render/solid/mesh/qef.h"

#include <cmath>

namespace solid {
namespace {

constexpr double kFree = 0.02;  // of the largest eigenvalue: planes at less than 16 degrees count as one

/// Eigenvectors as columns of `vectors`, eigenvalues on the diagonal of `m`, by Jacobi's rotations.
void diagonalise(glm::dmat3& m, glm::dmat3& vectors)
{
    vectors = glm::dmat3(1.0);
    for (int sweep = 0; sweep < 12; ++sweep)
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (std::abs(m[p][q]) < 1e-15) continue;
                const double theta = 0.5 * (m[q][q] - m[p][p]) / m[p][q];
                const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
                const double c = 1.0 / std::sqrt(t * t + 1.0), s = t * c;
                glm::dmat3 turn(1.0);
                turn[p][p] = turn[q][q] = c;
                turn[q][p] = s;
                turn[p][q] = -s;
                m = glm::transpose(turn) * m * turn;
                vectors = vectors * turn;
            }
}

}  // namespace

glm::dvec3 meeting_point(std::span<const SurfacePoint> tangents, const glm::dvec3& start)
{
    glm::dmat3 squares(0.0);
    glm::dvec3 right(0.0);
    for (const SurfacePoint& s : tangents) {
        squares += glm::outerProduct(s.normal, s.normal);
        right += s.normal * glm::dot(s.normal, s.point - start);
    }
    glm::dmat3 vectors;
    diagonalise(squares, vectors);
    const double largest = glm::max(squares[0][0], glm::max(squares[1][1], squares[2][2]));
    glm::dvec3 moved(0.0);
    for (int i = 0; i < 3; ++i)
        if (squares[i][i] > kFree * largest && squares[i][i] > 0.0)
            moved += vectors[i] * (glm::dot(vectors[i], right) / squares[i][i]);
    return start + moved;
}

}  // namespace solid
