#pragma once

#include "csg/freeform/surface/height_field.h"
#include "csg/solids/shared/common.h"

namespace csg {

/// Height of the two triangles between four levels, parted from (1, 0) to (0, 1); x and z within the cell.
inline double terrain_level(const std::array<double, 4>& h, double x, double z)
{
    return x + z <= 1.0 ? h[0] + (h[1] - h[0]) * x + (h[2] - h[0]) * z
                        : h[3] + (h[2] - h[3]) * (1.0 - x) + (h[1] - h[3]) * (1.0 - z);
}

/// One ray over a height field, in points and levels. It goes from block to block and down into those whose levels it
/// comes near, edge by edge there: how far it is above an edge is worked out once, for the triangles on both sides, so
/// no ray slips between two.
class TerrainWalk {
public:
    static constexpr std::int32_t kWideBits = 2, kWide = 1 << kWideBits;  ///< blocks along a side of the next larger

    TerrainWalk(const HeightField& field, const Ray& ray, IntersectionList& out)
        : field_(field), ray_(ray), inverse_(1.0 / ray.direction), out_(out)
    {}
    void run();

private:
    friend class TerrainLanes;
    /// Where the walk is: over a block of a level (0: a cell), from t on.
    struct Place {
        std::size_t level;
        std::int32_t i, k;
        double t, y;
    };

    /// A part of the ray and its ends' levels.
    struct Step {
        double from, to, y_from, y_to;
        double lowest() const { return std::min(y_to, y_from); }
        double highest() const { return std::max(y_to, y_from); }
    };

    bool clip(double& first, double& last) const;
    void enter_band(double t, bool between);
    void leave_band(double t, bool inside);
    bool start();
    void finish();
    Place first_place() const;
    void walk(Place at);
    bool step(Place& at);
    void descend(Place& at) const;
    bool passed(HeightField::Range range, const Step& step);
    void leave_grid()
    {
        if (inside_ && !done_) out_.leave(std::min(last_, out_.to), kUndrawnFace);
    }
    void triangles(std::uint32_t i, std::uint32_t k, const Step& step);
    void edge(double t, double above, std::uint32_t face);
    void settle(bool inside, double t)
    {
        if (inside != inside_) cross(t, face_below(t));
        known_ = false;
    }
    void cross(double t, std::uint32_t face)
    {
        inside_ = !inside_;
        if (!(inside_ ? out_.enter(t, face) : out_.leave(t, face))) done_ = true;
    }

    double x(double t) const { return ray_.origin.x + t * ray_.direction.x; }
    double y(double t) const { return ray_.origin.y + t * ray_.direction.y; }
    double z(double t) const { return ray_.origin.z + t * ray_.direction.z; }
    std::uint32_t face_of(std::uint32_t i, std::uint32_t k, bool upper) const
    {
        return (k * (field_.grid_.columns - 1) + i) * 2 + (upper ? 1u : 0u);
    }
    /// A triangle of the cell that the ray is over at t: for what rounding has moved.
    std::uint32_t face_below(double t) const
    {
        return face_of(place(x(t), 0, field_.grid_.columns - 1), place(z(t), 0, field_.grid_.rows - 1), false);
    }
    /// The number from `from` to below `to` that holds v.
    static std::uint32_t place(double v, std::uint32_t from, std::uint32_t to)
    {
        const double at = std::floor(v);
        return at >= from ? (at < to ? static_cast<std::uint32_t>(at) : to - 1) : from;
    }

    static constexpr std::size_t kMostLevels = 17;  ///< of 4 in 2^32
    /// The number of those from `first` to `last` that is next to the cell of v.
    static std::int32_t nearest(double v, std::int32_t first, std::int32_t last)
    {
        return static_cast<std::int32_t>(std::min(std::max(double(first), v), double(last)));
    }

    const HeightField& field_;
    const Ray ray_;
    const glm::dvec3 inverse_;
    IntersectionList& out_;
    double last_ = 0.0;               ///< the end of the grid
    double begin_ = 0.0, end_ = 0.0;  ///< of the band of levels in which the terrain lies, over the grid
    bool through_ = false;            ///< the ray leaves the band by its floor or top
    bool inside_ = false, done_ = false;
    bool known_ = false;  ///< the next two belong to the point that the walk has come to
    double t_ = 0.0, above_ = 0.0;
};

}  // namespace csg
