#pragma once

#include "csg/freeform/shared/container.h"
#include "csg/freeform/field/field.h"
#include "csg/freeform/shared/intersection_list.h"

#include <memory>
#include <optional>
#include <span>

namespace csg {

/// What an isosurface is made of (spec 5b, 13; reference manual: Isosurface).
struct IsosurfaceTerms {
    std::shared_ptr<const Field> field;
    double threshold = 0.0;
    double accuracy = 0.001;    ///< above 0, distance in the world
    double max_gradient = 1.1;  ///< asked only where the field has no ranges, or `trusting`
    bool trusting = false;      ///< by POV-Ray's bisection, ranges or not
    bool evaluate = false;      ///< let that grow while a ray is followed, by `growth`
    glm::dvec3 growth{0.0};
    int max_trace = 1;  ///< crossings drawn on one ray
    bool open = false;  ///< the container's wall is not drawn
    /// Of a ray that is asked about a short part of its way nothing else is looked at: what is told of it there differs
    /// up to the accuracy from what is told of the whole.
    bool short_ways = false;
    Container container;
};

class IsosurfaceSearch;

/// Where field <= threshold inside of a container. The first crossing is found by the field's ranges, or by
/// its polynomial along the ray: nothing thicker than the accuracy is missed, whatever max_gradient says; without
/// ranges by POV-Ray's bisection, which trusts max_gradient. Either way a crossing is told where POV-Ray's bisection
/// ends, up to the accuracy behind the field's own: textures and what a scene places by trace() depend on it.
class Isosurface {
public:
    explicit Isosurface(IsosurfaceTerms terms) : terms_(std::move(terms)) {}

    void intersect(const Ray& ray, IntersectionList& out) const;
    /// Where the field is asked at points alone: eight rays ask for theirs together. One with ranges asks for eight of
    /// one ray.
    bool intersects_many() const { return (!terms_.field->ranged() || terms_.trusting) && !terms_.short_ways; }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
    bool contains(const glm::dvec3& p) const
    {
        return terms_.container.contains(p) && terms_.field->value(p) - terms_.threshold <= 0.0;
    }
    /// By forward differences over the accuracy, as POV-Ray's: they smooth what is finer.
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    /// Those of many points, to the bit: the field is asked for two of them at a time.
    void gradients(std::span<const glm::dvec3> points, std::span<const std::uint32_t> faces, glm::dvec3* out) const;
    Aabb bounds() const { return terms_.container.bounds(); }

    const IsosurfaceTerms& terms() const { return terms_; }

    static constexpr bool kSurface = false;
    static constexpr bool kOpenSurface = true;  ///< up to the accuracy too far
    static constexpr bool kClosed = true, kInverseClosed = false;

private:
    static constexpr std::uint32_t kField = 7;  ///< face of the field's own crossings; below it the container's
    class Walk;
    struct Start;
    /// Of a point that the container draws, or would if its walls were drawn; of the field's nothing.
    std::optional<glm::dvec3> wall_gradient(const glm::dvec3& p, std::uint32_t face) const;
    double difference_step() const;
    Start start(IsosurfaceSearch& search, const Interval& way) const;

    IsosurfaceTerms terms_;
};

}  // namespace csg
