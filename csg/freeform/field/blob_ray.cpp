#include "csg/freeform/field/blob_lanes.h"
#include "csg/bvh/traverse.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

/// A ray through a blob: the stretches that it has in each component's reach, and between their ends a sum of quartics.
namespace csg {

void Blob::gather(const Field& field, const Ray& ray, double inverse, double from, double to, Stretch*& out) const
{
    const Chord<glm::dvec3> chord(ray.origin - field.middle, ray.direction, inverse, from, to, field.reach2);
    if (!chord.meets) return;
    const auto keep = [&](const Course<double>& course, double top) {
        *out++ = {course, field.strength, course.most(field.strength, top, from, to)};
    };
    if (field.is_sphere) return keep(chord.course(field, inverse), chord.ref);
    const auto slice = [&](const glm::dvec3& o, const glm::dvec3& v, double low, double high) {
        Course<double> course;
        double top;
        if (in_unit_sphere(o, v, low, high, from, to, top, course)) keep(course, top);
    };
    glm::dvec3 u = field.unit(ray.origin);
    const glm::dvec3 d = lanes::times(field.to_unit, ray.direction);
    if (field.length != 0.0 && d.z != 0.0) return each_slice(field, u, d, slice);
    u.z -= glm::clamp(u.z, 0.0, field.length);  // all of the ray lies in one slice
    slice(u, d, -kInfinity, kInfinity);
}

/// Of a few components, with no hierarchy: lanes ask which spheres the ray's line meets.
void Blob::gather_loose(const Ray& ray, double inverse, double from, double to, Stretch*& out) const
{
    constexpr std::size_t kLanes = 4;
    static_assert(kMostLoose % kLanes == 0);
    typedef double Four __attribute__((vector_size(sizeof(double) * kLanes)));
    const glm::dvec3 &o = ray.origin, &d = ray.direction;
    for (std::size_t first = 0; first < fields_.size(); first += kLanes) {
        Four x, y, z, reach2;
        std::memcpy(&x, &loose_.x[first], sizeof x);
        std::memcpy(&y, &loose_.y[first], sizeof y);
        std::memcpy(&z, &loose_.z[first], sizeof z);
        std::memcpy(&reach2, &loose_.reach2[first], sizeof reach2);
        x = o.x - x, y = o.y - y, z = o.z - z;
        const Four ref = -(x * d.x + y * d.y + z * d.z) * inverse;
        const Four fx = x + ref * d.x, fy = y + ref * d.y, fz = z + ref * d.z;
        const Four left2 = reach2 - (fx * fx + fy * fy + fz * fz);
        for (std::size_t k = 0; k < kLanes; ++k)
            if (left2[k] > 0.0) gather(fields_[first + k], ray, inverse, from, to, out);
    }
}

void Blob::intersect(const Ray& ray, IntersectionList& out) const
{
    if (box_.empty()) return;
    if (tree_.nodes.empty()) {
        WalkRoom<kMostLoose> room;
        Walk walk = room.walk();
        return intersect(ray, walk, out);
    }
    thread_local std::vector<Stretch> stretches;
    thread_local std::vector<Walk::End> ends;
    thread_local std::vector<std::uint32_t> active, places;
    const std::size_t room = Walk::kStretches * fields_.size();
    if (stretches.size() < room) {
        stretches.resize(room);
        ends.resize(2 * room);
        active.resize(room);
        places.resize(room);
    }
    Walk walk{stretches.data(), ends.data(), active.data(), places.data()};
    intersect(ray, walk, out);
}

void Blob::intersect(const Ray& ray, Walk& walk, IntersectionList& out) const
{
    // From the point nearest to the blob, so that its size and not the way there sets the rounding.
    const double inverse = 1.0 / glm::dot(ray.direction, ray.direction),
                 start = -glm::dot(ray.origin - middle_, ray.direction) * inverse;
    if (!std::isfinite(start)) return;
    const Ray near{ray.at(start), ray.direction};
    const double from = out.from - start, to = out.to - start;
    Stretch* next = walk.stretches;
    if (tree_.nodes.empty()) {
        gather_loose(near, inverse, from, to, next);
    } else {
        thread_local std::vector<std::uint32_t> components;
        const Part part{near, from, to};
        find_near({&part, 1}, components);
        for (const std::uint32_t component : components) gather(fields_[component], near, inverse, from, to, next);
    }
    walk.stretch_count = static_cast<std::size_t>(next - walk.stretches);
    follow(walk, start, out);
}

void Blob::follow(const Walk& walk, double start, IntersectionList& out) const
{
    Follower follower(threshold_, walk, start, out);
    while (follower.next()) follower.found(detail::only_change(follower.sum()));
}

void Blob::find_near(std::span<const Part> rays, std::vector<std::uint32_t>& out) const
{
    struct Entry {
        std::uint32_t node, rays;
    };
    out.clear();
    std::array<Entry, kBvhStack> stack;
    std::size_t top = 0;
    stack[top++] = {0, (1u << rays.size()) - 1u};
    std::array<std::optional<RaySlabs>, kMostTogether> slabs;
    std::array<float, kMostTogether> begin, limit;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        slabs[k].emplace(rays[k].ray);
        begin[k] = rounded_down(rays[k].from);
        limit[k] = rounded_up(rays[k].to);
    }
    alignas(32) float unused[8];
    while (top > 0) {
        const Entry at = stack[--top];
        const BvhNode& node = tree_.nodes[at.node];
        std::array<std::uint32_t, 8> met{};
        std::uint32_t any = 0;
        for (std::uint32_t left = at.rays; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            const std::uint32_t children = slabs[k]->intersect(node.bounds, begin[k], limit[k], unused);
            any |= children;
            for (std::uint32_t c = children; c != 0; c &= c - 1)
                met[static_cast<std::size_t>(std::countr_zero(c))] |= 1u << k;
        }
        for (; any != 0; any &= any - 1) {
            const auto c = static_cast<std::size_t>(std::countr_zero(any));
            if (node.child[c].is_leaf()) out.push_back(node.child[c].index());
            else stack[top++] = {node.child[c].index(), met[c]};
        }
    }
}

template <std::size_t components>
void Blob::intersect_in_lanes(std::span<const Ray> rays, IntersectionList* out) const
{
    using InLanes = Lanes<components>;
    InLanes lanes(*this);
    for (std::size_t k = 0; k < rays.size(); k += InLanes::kWide) {
        const std::size_t count = std::min(InLanes::kWide, rays.size() - k);
        if (count == 1) intersect(rays[k], out[k]);
        else lanes.run(rays.subspan(k, count), out + k);
    }
}

void Blob::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    tree_.nodes.empty() ? intersect_in_lanes<kMostLoose>(rays, out) : intersect_in_lanes<kMostNear>(rays, out);
}

}  // namespace csg
