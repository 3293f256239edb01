#pragma once

#include "csg/solids/shared/slab.h"
#include "csg/solids/shared/outline_shape.h"
#include "csg/solids/shared/common.h"

#include <algorithm>
#include <array>
#include <memory>

namespace csg {

struct RayBatch;

/// A plane region swept along local z from `low` to `high`: text, linear prisms (spec 5b, 6 and 11). It holds its
/// surface, its inverse does not. Faces: 0 at low, 1 at high, 2 + piece of the outline.
struct Extrusion {
    std::shared_ptr<const OutlineShape> shape;
    double low = 0.0, high = 1.0;
    bool open = false;     ///< the ends bound the solid but are not drawn
    bool ends_up = false;  ///< the raw normal of both ends points along +z, as a prism's do
    Transform frame;       ///< local to world

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

    /// f(t in, face, t out, face) for the pieces of the ray inside, nearest first. Ends outside of [from, to] may stand
    /// for others that lie there too; `first_only`: no more is wanted than the nearest end in it.
    template <class F>
    void each_span(const Ray& ray, F&& f, double from = -kInfinity, double to = kInfinity,
                   bool first_only = false) const
    {
        const Ray local = local_ray(frame, ray);
        const glm::dvec3 &o = local.origin, &d = local.direction;
        Interval within;
        if (!slab(o.z, d.z, low, high, within)) return;
        const double nearest = glm::max(within.entry, from), farthest = glm::min(within.exit, to);
        if (nearest > farthest) return;
        const glm::dvec2 start(o.x, o.y), along(d.x, d.y);
        if (along == glm::dvec2(0.0)) {
            if (shape->contains(start))
                f(within.entry, end_face(within.entry_face), within.exit, end_face(within.exit_face));
            return;
        }
        if (misses(start, along, nearest, farthest)) return;
        Walls walls;
        meet_walls(start, along, nearest, farthest, first_only, walls);
        tell(within, walls, walls.odd_before, f);
    }
    /// each_span() of the rays of a batch, as the spans of their records. A record of the nearest end may hold others.
    void intersect_many(RayBatch& batch) const;

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
    class Lanes;
    struct Wall {
        double t;
        std::uint32_t face;
    };

    /// Walls that the ray passes, nearest first, and whether the number of those before them is odd.
    struct Walls {
        bool odd_before;
        std::size_t count;
        std::array<Wall, kMostWalls> walls;  // filled as far as the count says

        const Wall* begin() const { return walls.data(); }
        const Wall* end() const { return walls.data() + count; }
    };

    std::uint32_t end_face(std::uint32_t face) const { return open ? kUndrawnFace : face; }

    /// Whether the stretch surely passes the box of the region, by far more than the roundings of a wall's place.
    bool misses(const glm::dvec2& from, const glm::dvec2& along, double nearest, double farthest) const
    {
        const glm::dvec2 &lower = shape->lower(), &upper = shape->upper();
        const glm::dvec2 size = glm::abs(from) + glm::max(glm::abs(lower), glm::abs(upper));
        const double room = 1e-10 * (size.x + size.y);
        for (int k = 0; k < 2; ++k) {
            const double inverse = 1.0 / along[k];
            const double a = (lower[k] - room - from[k]) * inverse, b = (upper[k] + room - from[k]) * inverse;
            nearest = glm::max(nearest, glm::min(a, b));
            farthest = glm::min(farthest, glm::max(a, b));
        }
        return nearest > farthest;
    }

    /// f() of the pieces within both ends between walls. `inside`: before all of them.
    template <class SomeWalls, class F>
    void tell(const Interval& within, const SomeWalls& walls, bool inside, F&& f) const
    {
        static_assert(kLow == 0 && kHigh == 1, "slab() counts its faces so");
        const std::uint32_t first = end_face(within.entry_face), last = end_face(within.exit_face);
        Wall in{-kInfinity, kUndrawnFace};
        const auto piece = [&](double until, std::uint32_t face) {
            if (until < within.entry || in.t > within.exit) return;
            const bool entered = in.t<within.entry, left = until> within.exit;
            f(entered ? within.entry : in.t, entered ? first : in.face, left ? within.exit : until, left ? last : face);
        };
        for (const auto& wall : walls) {
            if (inside) piece(wall.t, wall.face);
            in = {wall.t, wall.face};
            inside = !inside;
        }
        if (inside) piece(kInfinity, kUndrawnFace);
    }

    /// Those in [nearest, farthest], beyond it maybe some.
    void meet_walls(const glm::dvec2& from, const glm::dvec2& along, double nearest, double farthest, bool first_only,
                    Walls& out) const;
};

}  // namespace csg
