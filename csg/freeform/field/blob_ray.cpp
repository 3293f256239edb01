#include "csg/freeform/bernstein.h"
#include "csg/freeform/field/blob.h"
#include "csg/bvh/traverse.h"

/// A ray through a blob: the stretches that it has in each component's reach, and between their ends a sum of quartics.
namespace csg {

/// Bernstein ordinates.
using Quartic = std::array<double, 5>;

/// What one ray needs, in room that is there already: a component has three stretches at most.
struct Blob::Walk {
    struct End {
        double t;
        std::uint32_t stretch;
        bool leaves;
    };
    static constexpr std::size_t kStretches = 3;  ///< of a component

    Stretch* stretches;
    End* ends;
    std::uint32_t* active;
    std::size_t stretch_count = 0, end_count = 0, active_count = 0;

    void sort_ends()
    {
        end_count = 2 * stretch_count;
        const auto before = [](const End& a, const End& b) { return a.t < b.t; };
        const bool many = end_count > 32;
        for (std::uint32_t i = 0; i < end_count; ++i) {
            const Stretch& of = stretches[i / 2];
            const End end{i % 2 == 0 ? of.enter : of.leave, i / 2, i % 2 != 0};
            std::size_t k = i;
            for (; !many && k > 0 && before(end, ends[k - 1]); --k) ends[k] = ends[k - 1];
            ends[k] = end;
        }
        if (many) std::sort(ends, ends + end_count, before);
    }

    void pass(const End& end)
    {
        if (!end.leaves) {
            active[active_count++] = end.stretch;
            return;
        }
        for (std::size_t i = 0; i < active_count; ++i) {
            if (active[i] != end.stretch) continue;
            active[i] = active[--active_count];
            return;
        }
    }

    /// No sum of fields is above this where `active` are.
    double most() const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < active_count; ++k) sum += stretches[active[k]].most;
        return sum;
    }

    /// The sum of the active fields less the threshold, on [a, b].
    Quartic sum(double a, double b, double threshold) const
    {
        Quartic all{-threshold, -threshold, -threshold, -threshold, -threshold};
        for (std::size_t k = 0; k < active_count; ++k) {
            const Stretch& s = stretches[active[k]];
            const double first = s.w(a), last = s.w(b), middle = s.between(a, b);
            all[0] += s.strength * first * first;
            all[1] += s.strength * first * middle;
            all[2] += s.strength * (first * last + 2.0 * middle * middle) * (1.0 / 3.0);
            all[3] += s.strength * middle * last;
            all[4] += s.strength * last * last;
        }
        return all;
    }
};

/// `inverse`: 1 over the square of the direction's length.
void Blob::gather(const Field& field, const Ray& ray, double inverse, double from, double to, Stretch*& out) const
{
    const glm::dvec3 o = ray.origin - field.middle;
    const double ref = -glm::dot(o, ray.direction) * inverse;
    const glm::dvec3 foot = o + ref * ray.direction;
    const double left2 = field.reach2 - glm::dot(foot, foot);
    if (!(left2 > 0.0)) return;
    if (!field.is_sphere) return gather_capsule(field, ray, from, to, out);
    const double half = std::sqrt(left2 * inverse);
    if (ref + half < from || ref - half > to) return;
    const double scale = 1.0 / field.reach2, w0 = left2 * scale;
    *out++ = {ref - half,
              ref + half,
              ref,
              w0,
              -2.0 * scale * glm::dot(foot, ray.direction),
              -scale / inverse,
              field.strength,
              field.strength > 0.0 ? field.strength * w0 * w0 : 0.0};
}

void Blob::gather_capsule(const Field& field, const Ray& ray, double from, double to, Stretch*& out) const
{
    const glm::dvec3 u = field.unit(ray.origin), d = field.to_unit * ray.direction;
    // Where the nearest point of the axis is its inner part, its lower or its upper end; a sphere is one end.
    const auto add = [&](const glm::dvec3& o, const glm::dvec3& v, double low, double high) {
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
        Stretch s{low, high, ref, w0, 2.0 * half, -a, field.strength, 0.0};
        if (field.strength > 0.0) {
            const double top = s.w(glm::clamp(nearest, low, high));
            s.most = field.strength * top * top;
        }
        *out++ = s;
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
        std::array<Stretch, Walk::kStretches * kMostLoose> stretches;
        std::array<Walk::End, 2 * Walk::kStretches * kMostLoose> ends;
        std::array<std::uint32_t, Walk::kStretches * kMostLoose> active;
        Walk walk{stretches.data(), ends.data(), active.data()};
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
        for (const Field& field : fields_) gather(field, near, inverse, from, to, next);
    } else {
        const double limit = std::max(to, 0.0);  // below 0 the walk would end
        traverse(tree_, RaySlabs(near), from, limit, ~0u, [&](ChildWord leaf) {
            gather(fields_[leaf.index()], near, inverse, from, to, next);
            return limit;
        });
    }
    walk.stretch_count = static_cast<std::size_t>(next - walk.stretches);
    if (walk.stretch_count == 0 && threshold_ >= 0.0) return;
    walk.sort_ends();

    bool inside = 0.0 > threshold_;
    bool more = !inside || out.enter(-kInfinity, kUndrawnFace);
    const auto cross = [&](double t) {
        inside = !inside;
        more = inside ? out.enter(start + t, 0) : out.leave(start + t, 0);
        return more;
    };
    const auto cross_before = [&] {
        inside = !inside;
        if (inside) out.enter(-kInfinity, kUndrawnFace);
        else out.leave(-kInfinity, kUndrawnFace);
    };
    for (std::size_t i = 0; i < walk.end_count && more; ++i) {
        walk.pass(walk.ends[i]);
        double a = walk.ends[i].t;
        const double b = i + 1 < walk.end_count ? walk.ends[i + 1].t : a;
        if (!(a < b) || b < from) continue;
        if (a > to) break;
        // Sums in another order differ by far less than the rest of the rounding.
        if (!inside && walk.most() * (1.0 + 1e-12) < threshold_) continue;
        // Of the nearest end alone, what lies before the range need not be found.
        const bool cut = out.first_only && a < from;
        if (cut) a = from;
        // Nor what lies beyond: its end may depend on what else the ray has met, so that no number comes from it.
        if (out.first_only && to < b && a < to) {
            const Quartic wanted = walk.sum(a, to, threshold_);
            if (ordinate_changes(wanted) == 0 && ((wanted[0] > 0.0) == inside || cut)) break;
        }
        const Quartic sum = walk.sum(a, b, threshold_);
        if ((sum[0] > 0.0) != inside) {
            if (cut) cross_before();
            else if (!cross(a)) break;
        }
        each_change(sum, a, b, kHalvings, cross);
    }
    // Nothing reaches beyond the last end.
    if (more && inside != (0.0 > threshold_) && walk.end_count != 0) cross(walk.ends[walk.end_count - 1].t);
}

}  // namespace csg
