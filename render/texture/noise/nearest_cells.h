#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

/// The scattered points behind crackle and facets, one per unit cell (spec 4, 5.4).
namespace texture {

/// After how many cells along each axis the points come again; 0: never (crackle's `repeat`).
inline constexpr glm::ivec3 kNoRepeat{0};

/// Points of the 81 cells about a base cell that POV-Ray looks at: first the 27 that touch it, then those one further.
class CellPoints {
public:
    static constexpr std::size_t kNear = 27, kAll = 81, kRoom = 88;  ///< room: whole vectors

    constexpr CellPoints() = default;  ///< of no cell
    explicit CellPoints(const glm::dvec3& base_cell, const glm::ivec3& repeat = kNoRepeat)
    {
        move_to(base_cell, repeat);
    }

    void move_to(const glm::dvec3& base_cell, const glm::ivec3& repeat);
    bool are_of(const glm::dvec3& base_cell, const glm::ivec3& repeat) const
    {
        return count_ != 0 && base_ == base_cell && repeat_ == repeat;
    }

    /// The points of the outer cells too. Everything else is there at once.
    void complete();
    bool completed() const { return count_ == kAll; }
    std::size_t count() const { return count_; }

    alignas(64) std::array<double, kRoom> x{}, y{}, z{};  ///< infinite behind the last

private:
    glm::dvec3 base_{0.0};
    glm::ivec3 repeat_{0};
    std::size_t count_ = 0;
};

/// Those of a cell, until the thread asks for another. Neighbouring points mostly ask for the same few cells, so each
/// thread keeps some.
CellPoints& cell_points(const glm::dvec3& base_cell, const glm::ivec3& repeat = kNoRepeat);

/// The points of outer cells are no nearer than this, as powered distances of any metric: what is found below it stays.
inline constexpr double kOuterCells = 0.999;

struct NearestCells {
    std::array<double, 3> powered;  ///< sum of |delta|^metric, ascending; only the first `wanted` count
    glm::dvec3 point;               ///< the nearest; of equal ones the first by cell, x before y before z
};

/// The nearest `wanted` points (1 to 3). `signed_sum`: metric 1 adds signed deltas (facets' defect).
NearestCells nearest_cells(const glm::dvec3& p, CellPoints& cells, double metric, bool signed_sum, int wanted);

/// Its distances alone.
std::array<double, 3> nearest_distances(const glm::dvec3& p, CellPoints& cells, double metric, int wanted);

}  // namespace texture
