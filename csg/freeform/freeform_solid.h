#pragma once

#include "csg/freeform/shared/ray_batch.h"
#include "csg/solids/shared/common.h"

#include <memory>
#include <span>
#include <vector>

namespace csg {

struct FreeformShape;
struct Share;  // csg/base/hit.h

/// A freeform shape in the world: lathe, blob, isosurface, ... (csg/freeform/freeform.h).
struct Freeform {
    std::shared_ptr<const FreeformShape> shape;
    Transform frame;  ///< local to world

    static constexpr std::uint32_t kMostSpans = IntersectionList::kMostSpans;
    std::uint32_t most_spans() const { return surface() ? 1u : kMostSpans + 1; }
    std::uint32_t most_crossings() const
    {
        return (surface() ? 0 : 2 * kMostSpans + 2) + (reports_touches() ? IntersectionList::kMostTouches : 0);
    }

    /// Whether it is drawn as a mere surface, without an inside.
    bool surface() const;
    /// Whether reported crossings lie beside the surface or depend on the path of the ray: a shadow ray of a point on
    /// it then has to start at that point.
    bool has_open_surface() const;
    /// Whether it is smooth unless made pointed on purpose: a ray that leaves it hardly ever meets it again nearby, and
    /// the test for that is slow.
    bool round() const;
    /// Whether its normals may be interpolated between corners, and so differ from those of the surface.
    bool blends_normals() const;
    /// Whether parts of it may be drawn that bound nothing, as those of a lathe at a negative radius.
    bool reports_touches() const;
    /// Whether its crossings depend on the direction of the ray: a shadow ray has to start at the point itself.
    bool one_way() const;
    bool closed() const;
    bool inverse_closed() const;
    void intersect(const Ray& ray, IntersectionList& out) const;
    /// Whether intersect_many() is faster than intersect() ray by ray.
    bool intersects_many() const;
    /// intersect() of the rays of a batch, which are moved into the shape's space.
    void intersect_many(RayBatch& batch) const;
    void intersect(const Ray& ray, SpanList& out) const { spans(ray, -kInfinity, kInfinity, out); }
    /// The spans that meet [from, to]; correct within that range only.
    void spans(const Ray& ray, double from, double to, SpanList& out) const;
    /// A cheap test: true where the ray surely has no crossing from `from` to `to`, false where it may have one.
    bool meets_no_more(const Ray& ray, double from, double to) const;
    bool contains(const glm::dvec3& p) const;
    bool contains_inverted(const glm::dvec3& p) const;
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t face) const;
    /// normal() of many points, at most kTileRays, to the bit.
    void normals(std::span<const glm::dvec3> points, std::span<const std::uint32_t> faces, glm::dvec3* out) const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const;
    /// Appends the shares of the shape's parts at world point p; nothing for a shape that has none.
    void shares(const glm::dvec3& p, std::vector<Share>& out) const;
    Aabb bounds() const;
    Aabb drawn_bounds() const;  ///< of what can be seen of it
    Aabb space() const;         ///< of the solid, in its own space

private:
    Aabb in_world(const Aabb& local) const;
};

}  // namespace csg
