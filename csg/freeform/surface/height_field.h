#pragma once

#include "csg/freeform/shared/intersection_list.h"

#include <array>
#include <span>
#include <vector>

namespace csg {

/// Terrain over the unit square of x and z: levels of a grid of points, two triangles a cell, y = level / 65536 (spec
/// 5b, 10; manual: Height Field). The solid is everything below, down without end; drawn is the terrain alone, and not
/// where it lies below the water level: there is a hole. Its boundary is outside.
class HeightField {
public:
    struct Grid {
        std::uint32_t columns = 0, rows = 0;  ///< points along x and z
        std::vector<std::uint16_t> levels;    ///< rows of columns, x rising, first row at z = 0
        double water = 0.0;                   ///< a level
        bool smooth = false;
    };
    /// More cells could not be told apart by face.
    static constexpr std::uint64_t kMostPoints = 1u << 30;

    /// A grid that is one point wide is never met.
    explicit HeightField(Grid grid);

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool intersects_many() const { return !empty(); }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
    bool contains(const glm::dvec3& p) const;
    glm::dvec3 gradient(const glm::dvec3&, std::uint32_t face) const;
    /// In the world, not normalised: blended there between the corners' if smooth.
    glm::dvec3 world_gradient(const Transform& frame, const glm::dvec3& p, std::uint32_t face) const;
    /// Of many points: those of one cell share its corners.
    void world_gradients(const Transform& frame, std::span<const glm::dvec3> points,
                         std::span<const std::uint32_t> faces, glm::dvec3* out) const;
    /// Without a lower end: no finite box holds the solid.
    Aabb bounds() const { return empty() ? Aabb{} : Aabb::everything(); }
    Aabb drawn_bounds() const { return extent(); }
    Aabb space() const;  ///< has no lower end
    Aabb extent() const;
    std::size_t bytes() const;
    /// Sides of a cell along x and z.
    glm::dvec2 cell() const
    {
        return empty() ? glm::dvec2(1.0) : glm::dvec2(1.0 / (grid_.columns - 1), 1.0 / (grid_.rows - 1));
    }
    bool blends_normals() const { return grid_.smooth; }

    static constexpr bool kSurface = false, kClosed = false, kInverseClosed = true;

private:
    friend class TerrainWalk;
    friend class TerrainLanes;
    struct Range {
        std::uint16_t lowest = 0xffff, highest = 0;
    };
    /// Cells, or blocks of them, each level's four times as wide as those below it.
    struct Level {
        std::int32_t columns = 0, rows = 0;
        std::uint32_t first = 0;  ///< row in ranges_; of blocks alone
        double size = 1.0;        ///< of a side, in cells
    };

    /// The box of what is drawn is this much higher and lower than the points, in levels (spec 5b, 10.2).
    static constexpr double kMargin = 0.001;

    bool empty() const { return grid_.columns < 2 || grid_.rows < 2; }
    double level(std::uint32_t i, std::uint32_t k) const { return grid_.levels[std::size_t{k} * grid_.columns + i]; }
    /// Levels of a cell's corners: (i, k), (i + 1, k), (i, k + 1), (i + 1, k + 1).
    std::array<double, 4> corners(std::uint32_t i, std::uint32_t k) const
    {
        const std::uint16_t* at = &grid_.levels[std::size_t{k} * grid_.columns + i];
        return {double(at[0]), double(at[1]), double(at[grid_.columns]), double(at[grid_.columns + 1])};
    }
    /// Rows of all levels of blocks lie one after the other, as long as those of the finest.
    std::size_t at(const Level& level, std::int32_t i, std::int32_t k) const
    {
        return (level.first + static_cast<std::size_t>(k)) * static_cast<std::size_t>(levels_[1].columns) +
               static_cast<std::size_t>(i);
    }
    Range block_range(const Level& level, std::int32_t i, std::int32_t k) const { return ranges_[at(level, i, k)]; }
    Range cell_range(std::int32_t i, std::int32_t k) const
    {
        return range_of(grid_, static_cast<std::size_t>(k) * grid_.columns + static_cast<std::size_t>(i));
    }
    /// Of the cell that the point is the first of.
    static Range range_of(const Grid& grid, std::size_t point)
    {
        const std::uint16_t *low = &grid.levels[point], *high = low + grid.columns;
        return {std::min(std::min(low[0], low[1]), std::min(high[0], high[1])),
                std::max(std::max(low[0], low[1]), std::max(high[0], high[1]))};
    }
    using Corners = std::array<glm::dvec3, 4>;
    Corners corner_normals(std::uint32_t i, std::uint32_t k) const;
    Corners world_corners(const Transform& frame, std::uint32_t cell) const;
    glm::dvec3 blended(const Corners& n, const glm::dvec3& p, std::uint32_t cell) const;
    void build_blocks();

    Grid grid_;
    glm::dvec3 scale_{1.0};           ///< from the unit box to points and levels
    double floor_ = 0.0, top_ = 0.0;  ///< drawn between these, in levels
    bool hole_ = false;               ///< some terrain lies below the water
    std::vector<Level> levels_;       ///< the cells first
    std::vector<Range> ranges_;       ///< lowest and highest point of blocks
};

}  // namespace csg
