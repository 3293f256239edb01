#pragma once

#include "csg/outline_shape.h"
#include "csg/solids/common.h"

#include <algorithm>
#include <array>
#include <memory>

namespace csg {

/// A plane region swept along local z from `low` to `high`: text, linear prisms (spec 5b, 6 and 11). It holds its surface,
/// its inverse does not. Faces: 0 at low, 1 at high, 2 + piece of the outline.
struct Extrusion {
    std::shared_ptr<const OutlineShape> shape;
    double low = 0.0, high = 1.0;
    bool open = false;             ///< the ends bound the solid but are not drawn
    bool ends_up = false;          ///< the raw normal of both ends points along +z, as a prism's do
    Transform frame;               ///< local to world

    static constexpr std::uint32_t kLow = 0, kHigh = 1, kFirstWall = 2;
    /// Farther walls of one ray are not looked at.
    static constexpr std::size_t kMostWalls = 256;

    std::uint32_t most_spans() const
    {
        return static_cast<std::uint32_t>(std::min<std::size_t>(shape->most_crossings(), kMostWalls)) / 2 + 1;
    }
    std::uint32_t most_crossings() const { return 2 * most_spans(); }

    void intersect(const Ray& ray, SpanList& out) const
    {
        each_span(ray, [&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
            out.push({{.t = in, .face = in_face}, {.t = end, .face = end_face}});
        });
    }

    /// f(t in, face, t out, face) for the pieces of the ray inside, nearest first.
    template <class F>
    void each_span(const Ray& ray, F&& f) const
    {
        const Ray local = local_ray(frame, ray);
        const glm::dvec3 &o = local.origin, &d = local.direction;
        Interval within;
        if (!slab(o.z, d.z, low, high, within)) return;
        const std::uint32_t first = within.entry_face == 0 ? end_face(kLow) : end_face(kHigh);
        const std::uint32_t last = within.exit_face == 0 ? end_face(kLow) : end_face(kHigh);
        const glm::dvec2 from(o.x, o.y), along(d.x, d.y);
        if (along == glm::dvec2(0.0)) {
            if (shape->contains(from)) f(within.entry, first, within.exit, last);
            return;
        }
        std::array<Wall, kMostWalls> walls;
        const std::size_t count = meet_walls(from, along, walls);
        for (std::size_t i = 0; i + 1 < count; i += 2) {
            const Wall &a = walls[i], &b = walls[i + 1];
            if (b.t < within.entry) continue;
            if (a.t > within.exit) break;
            const bool entered = a.t < within.entry, left = b.t > within.exit;
            f(entered ? within.entry : a.t, entered ? first : a.face, left ? within.exit : b.t, left ? last : b.face);
        }
    }

    bool contains(const glm::dvec3& p) const
    {
        const glm::dvec3 l = frame.inverse_point(p);
        return l.z >= low && l.z <= high && shape->contains({l.x, l.y});
    }
    bool contains_inverted(const glm::dvec3& p) const { return !contains(p); }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t face) const
    {
        if (face < kFirstWall) return unit_or_x(frame.normal({0.0, 0.0, face == kLow && !ends_up ? -1.0 : 1.0}));
        const glm::dvec3 l = frame.inverse_point(p);
        const std::uint32_t piece = face - kFirstWall;
        const glm::dvec2 slope = shape->pieces()[piece].slope(shape->parameter(piece, {l.x, l.y}));
        return unit_or_x(frame.normal({slope.y, -slope.x, 0.0}));
    }
    Aabb bounds() const
    {
        if (shape->empty()) return {};
        return padded(transformed_box(frame, {glm::dvec3(shape->lower(), low), glm::dvec3(shape->upper(), high)}));
    }

    static constexpr bool kClosed = true, kInverseClosed = false;

private:
    struct Wall {
        double t;
        std::uint32_t face;
    };

    std::uint32_t end_face(std::uint32_t face) const { return open ? kUndrawnFace : face; }

    /// The walls that the ray passes, nearest first: an even number.
    std::size_t meet_walls(const glm::dvec2& from, const glm::dvec2& along, std::array<Wall, kMostWalls>& walls) const
    {
        const glm::dvec2 side(-along.y, along.x);
        const double over = 1.0 / glm::dot(along, along);
        std::size_t count = 0;
        shape->crossings(side, glm::dot(side, from), [&](double w, std::uint32_t piece) {
            const Wall wall{glm::dot(shape->pieces()[piece].at(w) - from, along) * over, kFirstWall + piece};
            if (count == kMostWalls) {
                if (wall.t >= walls[count - 1].t) return;
                --count;
            }
            std::size_t at = count++;
            for (; at > 0 && walls[at - 1].t > wall.t; --at) walls[at] = walls[at - 1];
            walls[at] = wall;
        });
        return count & ~std::size_t{1};
    }
};

}  // namespace csg
