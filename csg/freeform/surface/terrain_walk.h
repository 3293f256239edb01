#pragma once

#include "csg/freeform/surface/height_field.h"
#include "csg/solids/common.h"

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
    static constexpr std::uint32_t kWideBits = 2,
                                   kWide = 1u << kWideBits;  ///< blocks along a side of the next larger block

    TerrainWalk(const HeightField& field, const Ray& ray, IntersectionList& out)
        : field_(field), ray_(ray), inverse_(1.0 / ray.direction), out_(out)
    {}
    void run();

private:
    /// Of blocks or cells: [from, to) along x and z.
    struct Window {
        std::uint32_t x_from, x_to, z_from, z_to;
    };

    /// A part of the ray and its ends' levels.
    struct Step {
        double from, to, y_from, y_to;
        double lowest() const { return std::min(y_from, y_to); }
        double highest() const { return std::max(y_from, y_to); }
    };

    bool clip(double& first, double& last) const;
    void enter_band(double t, bool between);
    void leave_band(double t, bool inside);
    void walk(std::size_t level, const Window& window, double from, double to);
    void block(std::size_t level, std::uint32_t i, std::uint32_t k, const Step& step);
    void cell(std::uint32_t i, std::uint32_t k, const Step& step);
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

    const HeightField& field_;
    const Ray ray_;
    const glm::dvec3 inverse_;
    IntersectionList& out_;
    bool inside_ = false, done_ = false;
    bool known_ = false;  ///< the next two belong to the point that the walk has come to
    double t_ = 0.0, above_ = 0.0;
};

}  // namespace csg
