#include "csg/freeform/field/blob_lanes.h"
#include "csg/bvh/traverse.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

/// A ray through a blob: the stretches that it has in each component's reach, and between their ends a sum of quartics.
namespace csg {

/// Where a ray is nearest to the middle of a sphere around a field, and half of what it has inside.
struct Blob::Chord {
    double ref, half;
    double left2;  ///< reach squared less the distance squared; not positive: outside of the range or of the sphere
    double slope;  ///< of half the squared distance, at ref: 0 but for rounding

    /// (x, y, z): the middle. `inverse`: 1 over the square of the direction's length.
    static Chord of(const Ray& ray, double inverse, double from, double to, double x, double y, double z, double reach2)
    {
        const glm::dvec3& d = ray.direction;
        x = ray.origin.x - x;
        y = ray.origin.y - y;
        z = ray.origin.z - z;
        const double ref = -(x * d.x + y * d.y + z * d.z) * inverse;
        x += ref * d.x;
        y += ref * d.y;
        z += ref * d.z;
        const double inside2 = reach2 - (x * x + y * y + z * z);
        const double half = std::sqrt(inside2 > 0.0 ? inside2 * inverse : 0.0);
        const bool beside = (ref + half < from) | (ref - half > to);
        return {ref, half, beside ? 0.0 : inside2, x * d.x + y * d.y + z * d.z};
    }
};

void Blob::gather(const Field& field, const Chord& chord, const Ray& ray, double inverse, double from, double to,
                  Stretch*& out) const
{
    if (!(chord.left2 > 0.0)) return;
    if (!field.is_sphere) return gather_capsule(field, ray, from, to, out);
    const double scale = 1.0 / field.reach2;
    Stretch& s = *out++;
    s = {chord.ref - chord.half,     chord.ref + chord.half, chord.ref,      chord.left2 * scale,
         -2.0 * scale * chord.slope, -scale / inverse,       field.strength, kRounding * std::abs(field.strength)};
    s.bound(chord.ref, from, to);
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
        for (std::size_t k = 0; k < kLanes; ++k) {
            if (!(left2[k] > 0.0)) continue;
            const Field& field = fields_[first + k];
            const glm::dvec3& c = field.middle;
            gather(field, Chord::of(ray, inverse, from, to, c.x, c.y, c.z, field.reach2), ray, inverse, from, to, out);
        }
    }
}

void Blob::gather_capsule(const Field& field, const Ray& ray, double from, double to, Stretch*& out) const
{
    const glm::dvec3 u = field.unit(ray.origin), d = field.to_unit * ray.direction;
    // Where the nearest point of the axis is its inner part, its lower or its upper end; a sphere is one end.
    const auto add = [&](const glm::dvec3& o, const glm::dvec3& v, double low, double high) {
        if (!(low < high) || high < from || low > to) return;
        const double a = glm::dot(v, v);
        double nearest = a > 0.0 ? -glm::dot(o, v) / a : 0.0;
        nearest = std::isfinite(nearest) ? nearest : 0.0;
        const double ref =
            glm::clamp(nearest, std::isfinite(low) ? low : nearest, std::isfinite(high) ? high : nearest);
        const glm::dvec3 foot = o + ref * v;
        const double w0 = 1.0 - glm::dot(foot, foot), half = -glm::dot(foot, v);
        // Roots of w0 + 2 half s - a s^2.
        const double discriminant = half * half + a * w0;
        if (!(discriminant > 0.0)) {
            if (!(a == 0.0 && w0 > 0.0)) return;
        } else if (a > 0.0) {
            const double q = half + std::copysign(std::sqrt(discriminant), half);
            const double s1 = q / a, s2 = -w0 / q;
            low = std::max(low, ref + std::min(s1, s2));
            high = std::min(high, ref + std::max(s1, s2));
        }
        low = std::max(low, -1e300);
        high = std::min(high, 1e300);
        if (!(low < high) || high < from || low > to) return;
        Stretch& s = *out++;
        s = {low, high, ref, w0, 2.0 * half, -a, field.strength, kRounding * std::abs(field.strength)};
        s.bound(nearest, from, to);
    };
    if (field.length == 0.0) return add(u, d, -kInfinity, kInfinity);
    const glm::dvec3 upper_u(u.x, u.y, u.z - field.length), flat_u(u.x, u.y, 0.0), flat_d(d.x, d.y, 0.0);
    if (d.z == 0.0) {
        if (u.z <= 0.0) add(u, d, -kInfinity, kInfinity);
        else if (upper_u.z >= 0.0) add(upper_u, d, -kInfinity, kInfinity);
        else add(flat_u, d, -kInfinity, kInfinity);
        return;
    }
    const double at_low = -u.z / d.z, at_high = -upper_u.z / d.z;
    const bool up = d.z > 0.0;
    if (up) add(u, d, -kInfinity, at_low);
    else add(upper_u, d, -kInfinity, at_high);
    add(flat_u, flat_d, std::min(at_low, at_high), std::max(at_low, at_high));
    if (up) add(upper_u, d, at_high, kInfinity);
    else add(u, d, at_low, kInfinity);
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
    thread_local std::vector<std::uint32_t> active;
    const std::size_t room = Walk::kStretches * fields_.size();
    if (stretches.size() < room) {
        stretches.resize(room);
        ends.resize(2 * room);
        active.resize(room);
    }
    Walk walk{stretches.data(), ends.data(), active.data()};
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
        for (const std::uint32_t component : components) {
            const Field& field = fields_[component];
            const glm::dvec3& c = field.middle;
            gather(field, Chord::of(near, inverse, from, to, c.x, c.y, c.z, field.reach2), near, inverse, from, to,
                   next);
        }
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
    std::sort(out.begin(), out.end());
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
