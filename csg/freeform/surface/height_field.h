#pragma once

#include "csg/freeform/intersection_list.h"

#include <array>
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
    bool contains(const glm::dvec3& p) const;
    glm::dvec3 gradient(const glm::dvec3&, std::uint32_t face) const;
    /// In the world, not normalised: blended there between the corners' if smooth.
    glm::dvec3 world_gradient(const Transform& frame, const glm::dvec3& p, std::uint32_t face) const;
    /// Without a lower end: no finite box holds the solid.
    Aabb bounds() const { return empty() ? Aabb{} : Aabb::everything(); }
    Aabb drawn_bounds() const { return extent(); }
    Aabb extent() const;
    std::size_t bytes() const;
    bool blends_normals() const { return grid_.smooth; }

    static constexpr bool kSurface = false, kClosed = false, kInverseClosed = true;

private:
    friend class TerrainWalk;
    struct Range {
        std::uint16_t lowest = 0xffff, highest = 0;
    };
    /// Lowest and highest point of blocks of cells, each level's blocks four times as wide as those below it.
    struct Blocks {
        std::uint32_t columns = 0, rows = 0;
        std::vector<Range> ranges;
    };

    bool empty() const { return grid_.columns < 2 || grid_.rows < 2; }
    double level(std::uint32_t i, std::uint32_t k) const { return grid_.levels[std::size_t{k} * grid_.columns + i]; }
    /// Levels of a cell's corners: (i, k), (i + 1, k), (i, k + 1), (i + 1, k + 1).
    std::array<double, 4> corners(std::uint32_t i, std::uint32_t k) const
    {
        const std::uint16_t* at = &grid_.levels[std::size_t{k} * grid_.columns + i];
        return {double(at[0]), double(at[1]), double(at[grid_.columns]), double(at[grid_.columns + 1])};
    }
    glm::dvec3 point_normal(std::uint32_t i, std::uint32_t k) const;
    void build_blocks();

    Grid grid_;
    glm::dvec3 scale_{1.0};           ///< from the unit box to points and levels
    double floor_ = 0.0, top_ = 0.0;  ///< drawn between these, in levels
    bool hole_ = false;               ///< some terrain lies below the water
    std::vector<Blocks> blocks_;      ///< the finest first
};

}  // namespace csg
