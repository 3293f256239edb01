#pragma once

#include "csg/bvh/bvh.h"
#include "csg/packet/point_set.h"
#include "csg/packet/lanes/tile_rays.h"
#include "csg/bvh/traverse.h"
#include "csg/items/world_data.h"

#include <algorithm>

/// The pyramid around a tile's rays.
namespace csg {

/// Four planes, through the common origin if there is one, and a depth along the axis. Every ray of the tile lies
/// inside; what is outside is missed by all of them.
class Beam {
public:
    template <class Rays>
    Beam(const Rays& rays, const Aabb& scene)
    {
        find_axes(rays);
        find_planes(rays);
        const glm::dvec3 widest = glm::max(glm::max(glm::abs(scene.lower), glm::abs(scene.upper)), rays.widest());
        // A dozen roundings of 6e-8 each, of terms no larger than this.
        const double size = 1e-6 * (widest.x + widest.y + widest.z);
        for (int p = 0; p < 5; ++p) {
            const auto [least, most] = rays.along(normal_[p]);
            set_plane(p, normal_[p], least - size);
            if (p == kAxis) deepest_ = rounded_up(most + size);
        }
    }

    /// Around all that lies between the points of two sets.
    Beam(const PointSet& from, const PointSet& to, const Aabb& scene)
    {
        const glm::dvec3 widest = find_axes(from, to, scene);
        // As above; the points of a lamp are given more roughly than rays are.
        const double size = 1e-6 * (widest.x + widest.y + widest.z);
        const auto first_of = [&](const glm::dvec3& v) { return from.foremost(v); };
        const auto last_of = [&](const glm::dvec3& v) { return to.foremost(v); };
        narrow_ = narrow_ && glm::dot(axis_, first_of(-axis_)) < glm::dot(axis_, last_of(axis_));
        const glm::dvec3 sides[kAxis] = {side_, -side_, up_, -up_};
        for (int p = 0; p < 5; ++p) {
            glm::dvec3 n = axis_;
            if (p < kAxis) {
                const glm::dvec3 across = last_of(sides[p]) - first_of(sides[p]);
                const double along = glm::dot(axis_, across);
                n = along > 0.0 ? glm::normalize(sides[p] - glm::dot(sides[p], across) / along * axis_) : sides[p];
            }
            set_plane(p, n, std::min(glm::dot(n, first_of(n)), glm::dot(n, last_of(n))) - size);
        }
        deepest_ = rounded_up(glm::dot(axis_, last_of(-axis_)) + size);
    }

    /// False: rays too far apart for one beam.
    bool narrow() const { return narrow_; }

    /// Whether the rays are as near to each other as those of neighbouring pixels; only of a beam made of rays.
    bool slim() const { return width_ < kSlim; }

    /// Which of eight finite boxes (BvhNode::bounds) reach into the beam no deeper than `limit`; `near` receives where
    /// at the earliest.
    std::uint32_t intersect(const float (&bounds)[6][8], float limit, float* near) const
    {
        using lanes::FloatPart;
        std::uint32_t mask = 0;
        for (int part = 0; part < lanes::kFloatParts; ++part) {
            const int at = part * lanes::kFloatPart;
            std::uint32_t inside = ~0u;
            for (int p = 0; p < 5; ++p) inside &= lanes::mask(along(bounds, p, 0, at) >= FloatPart(threshold_[p]));
            const FloatPart depth = along(bounds, kAxis, 3, at) - FloatPart(deepest_);
            depth.store_aligned(near + at);
            mask |= (inside & lanes::mask(depth <= FloatPart(limit))) << at;
        }
        return mask;
    }

    /// Which spheres of a block reach into the beam.
    std::uint32_t intersect(const SphereBlock& block) const
    {
        using lanes::Double;
        std::uint32_t mask = 0;
        for (int at = 0; at < 8; at += lanes::kDoubles) {
            const Double x = Double::load_aligned(block.x + at), y = Double::load_aligned(block.y + at),
                         z = Double::load_aligned(block.z + at);
            const Double reach = Double::load_aligned(block.radius + at) * Double(-1.0 - 1e-9);
            std::uint32_t inside = lanes::mask(reach < Double(0.0));
            for (int p = 0; p < 5; ++p) {
                const Double d = x * Double(normal_[p].x) + y * Double(normal_[p].y) + z * Double(normal_[p].z);
                inside &= lanes::mask(d - reach >= Double(static_cast<double>(threshold_[p])));
            }
            mask |= inside << at;
        }
        return mask;
    }

private:
    static constexpr int kAxis = 4;
    static constexpr double kSlim = 0.3;

    /// Plane p: everything lies where dot(n, point) >= least.
    void set_plane(int p, const glm::dvec3& n, double least)
    {
        normal_[p] = n;
        for (int axis = 0; axis < 3; ++axis) {
            normal_f_[p][axis] = static_cast<float>(n[axis]);
            far_row_[p][axis] = n[axis] >= 0.0 ? axis + 3 : axis;
        }
        threshold_[p] = rounded_down(least);
    }

    /// From the middle of one set to that of the other, and along the lamp's edge. The largest coordinates, by amount.
    glm::dvec3 find_axes(const PointSet& from, const PointSet& to, const Aabb& scene)
    {
        const glm::dvec3 way = to.middle() - from.middle();
        const double length = glm::length(way);
        narrow_ = length > 0.0;
        axis_ = narrow_ ? way / length : glm::dvec3(0, 0, 1);
        glm::dvec3 u = to.at(0) - to.last();
        u -= glm::dot(u, axis_) * axis_;
        if (glm::dot(u, u) < 1e-16 * length * length)
            u = glm::cross(axis_, std::abs(axis_.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        side_ = glm::normalize(u);
        up_ = glm::cross(axis_, side_);
        return glm::max(glm::max(glm::abs(scene.lower), glm::abs(scene.upper)), glm::max(from.widest(), to.widest()));
    }

    /// dot(normal p, corner) for the corner farthest along the normal (rows 0) or the opposite one (rows 3).
    lanes::FloatPart along(const float (&bounds)[6][8], int p, int rows, int at) const
    {
        using lanes::FloatPart;
        const auto term = [&](int axis) {
            const int row = rows == 0 ? far_row_[p][axis] : (far_row_[p][axis] + 3) % 6;
            return FloatPart::load_aligned(bounds[row] + at) * FloatPart(normal_f_[p][axis]);
        };
        return term(0) + term(1) + term(2);
    }

    /// Also false for NaN.
    static bool all_above(lanes::Double v, double limit)
    {
        return lanes::mask(v > lanes::Double(limit)) == (1u << lanes::kDoubles) - 1u;
    }

    template <class Rays>
    void find_axes(const Rays& rays)
    {
        using lanes::Double;
        Double x(0.0), y(0.0), z(0.0);
        for (int i = 0; i < rays.groups * kRayGroup; i += lanes::kDoubles) {
            const lanes::Directions d = rays.directions(i);
            x += d.x;
            y += d.y;
            z += d.z;
        }
        // The empty places at the end repeat the first ray.
        const double empty = rays.groups * kRayGroup - rays.count;
        const glm::dvec3 sum = glm::dvec3(lanes::sum(x), lanes::sum(y), lanes::sum(z)) - empty * rays.ray(0).direction;
        const double length = glm::length(sum);
        narrow_ = length > 0.5 * rays.count;
        axis_ = narrow_ ? sum / length : glm::dvec3(0, 0, 1);
        // Along the tile's first row, so that the pyramid fits a camera's tile.
        const glm::dvec3 row = rays.ray(std::min(7, rays.count - 1)).direction - rays.ray(0).direction;
        glm::dvec3 u = row - glm::dot(row, axis_) * axis_;
        if (glm::dot(u, u) < 1e-16)
            u = glm::cross(axis_, std::abs(axis_.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
        side_ = glm::normalize(u);
        up_ = glm::cross(axis_, side_);
    }

    template <class Rays>
    void find_planes(const Rays& rays)
    {
        using lanes::Double;
        Double shallowest(kInfinity), least_x(kInfinity), least_y(kInfinity), most_x(-kInfinity), most_y(-kInfinity);
        const auto along = [](const lanes::Directions& d, const glm::dvec3& v) {
            return d.x * Double(v.x) + d.y * Double(v.y) + d.z * Double(v.z);
        };
        for (int i = 0; i < rays.groups * kRayGroup; i += lanes::kDoubles) {
            const lanes::Directions d = rays.directions(i);
            const Double depth = along(d, axis_), over = Double(1.0) / depth;
            const Double sx = along(d, side_) * over, sy = along(d, up_) * over;
            shallowest = xsimd::min(shallowest, depth);
            least_x = xsimd::min(least_x, sx);
            least_y = xsimd::min(least_y, sy);
            most_x = xsimd::max(most_x, sx);
            most_y = xsimd::max(most_y, sy);
        }
        narrow_ = narrow_ && all_above(shallowest, 0.3);
        const glm::dvec2 least(lanes::lowest(least_x), lanes::lowest(least_y));
        const glm::dvec2 most(-lanes::lowest(-most_x), -lanes::lowest(-most_y));
        width_ = glm::max(most.x - least.x, most.y - least.y);
        // Wider than any rounding of what is computed in double.
        constexpr double kMargin = 1e-7;
        normal_[0] = glm::normalize(side_ - (least.x - kMargin) * axis_);
        normal_[1] = glm::normalize((most.x + kMargin) * axis_ - side_);
        normal_[2] = glm::normalize(up_ - (least.y - kMargin) * axis_);
        normal_[3] = glm::normalize((most.y + kMargin) * axis_ - up_);
        normal_[kAxis] = axis_;
    }

    bool narrow_ = false;
    double width_ = kInfinity;  ///< of its section one unit before the eye
    glm::dvec3 axis_, side_, up_, normal_[5];
    float normal_f_[5][3];
    float threshold_[5];  ///< what every ray's origin lies above, along each normal
    float deepest_;       ///< what every origin lies below, along the axis
    int far_row_[5][3];
};

}  // namespace csg
