#include "csg/freeform/shared/bernstein.h"
#include "csg/freeform/sweep/sphere_sweep.h"
#include "csg/freeform/sweep/sweep_bend.h"
#include "csg/freeform/sweep/swept_spheres.h"
#include "csg/bvh/traverse.h"

/// A ray through a sphere sweep: its intervals in the spheres of each segment, united.
namespace csg {
namespace {

constexpr int kMostPieces = 3;  // halvings of a segment, after which its extremes are taken as roots of degree 10

/// f(in, out) for each interval of the line in the union of the spheres.
template <std::size_t count, class F>
void each_interval(const SweptSpheres<count>& spheres, F&& f)
{
    bool met = spheres.reach[0] > 0.0;
    if (!met && ordinate_changes(spheres.reach) == 0) return;
    const Extremes<count> extremes(spheres);
    double since = 0.0;
    const auto end = [&](double u) {
        SweepEnd in, out;
        extremes.find(since, u, in, out);
        f(in, out);
    };
    each_change(spheres.reach, 0.0, 1.0, kHalvings, [&](double u) {
        if (met) end(u);
        since = u;
        met = !met;
        return true;
    });
    if (met) end(1.0);
}

/// f(in, out) for intervals whose union is that of each_interval(), on the part [low, high] of a segment: halves that
/// bend too much for one extreme each.
template <class F>
void each_bend(const SweptSpheres<4>& spheres, double low, double high, int depth, F&& f)
{
    if (ordinate_changes(spheres.reach) == 0 && !(spheres.reach[0] > 0.0)) return;
    const double length = high - low;
    const auto keep = [&](const SweepEnd& in, const SweepEnd& out) {
        f({in.t, low + length * in.u}, {out.t, low + length * out.u});
    };
    if (SweepBend::applies(spheres.m, spheres.reach)) {
        SweepEnd in, out;
        if (SweepBend(spheres.aside, spheres.m).ends(in, out)) keep(in, out);
        return;
    }
    if (depth == 0) return each_interval(spheres, keep);
    SweptSpheres<4> left, right;
    halve(spheres.m, left.m, right.m);
    halve(spheres.reach, left.reach, right.reach);
    halve(spheres.aside, left.aside, right.aside);
    each_bend(left, low, low + 0.5 * length, depth - 1, f);
    each_bend(right, low + 0.5 * length, high, depth - 1, f);
}

}  // namespace

void SphereSweep::gather(std::uint32_t index, const Ray& ray, std::vector<Piece>& out) const
{
    const Segment& segment = segments_[index];
    const double length = std::sqrt(glm::dot(ray.direction, ray.direction));
    const glm::dvec3 direction = ray.direction / length;
    const auto from = [&](std::size_t k) { return segment.control[k] - glm::dvec4(ray.origin, 0.0); };
    const auto keep = [&](const SweepEnd& in, const SweepEnd& end) {
        out.push_back({{in.t / length, in.u}, {end.t / length, end.u}, index});
    };
    if (segment.linear) return each_interval(spheres_along<2>(direction, from), keep);
    each_bend(spheres_along<4>(direction, from), 0.0, 1.0, kMostPieces, keep);
}

void SphereSweep::gather_all(const Ray& ray, double from, double to, bool first_only, std::vector<Piece>& out) const
{
    out.clear();
    if (tree_.nodes.empty()) {
        for (std::uint32_t i = 0; i < segments_.size(); ++i) gather(i, ray, out);
        return;
    }
    // Below 0 the walk would end. What begins beyond the first entry matters only to a ray that starts inside.
    double limit = std::max(to, 0.0);
    bool covered = false;
    traverse(tree_, RaySlabs(ray), from, limit, ~0u, [&](ChildWord leaf) {
        std::size_t i = out.size();
        gather(leaf.index(), ray, out);
        for (; first_only && i < out.size(); ++i) {
            covered = covered || (out[i].in.t < from && out[i].out.t >= from);
            if (out[i].in.t >= from) limit = std::min(limit, std::max(out[i].in.t, 0.0));
        }
        return limit;
    });
    if (covered) gather_all(ray, from, to, false, out);
}

void SphereSweep::intersect(const Ray& ray, IntersectionList& out) const
{
    if (segments_.empty()) return;
    thread_local std::vector<Piece> pieces;
    // From the point nearest to the middle, so that the way there does not set the rounding.
    const double start = -glm::dot(ray.origin - middle_, ray.direction) / glm::dot(ray.direction, ray.direction);
    if (!std::isfinite(start)) return;
    const Ray near{ray.at(start), ray.direction};
    gather_all(near, out.from - start, out.to - start, out.first_only, pieces);
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
        return a.in.t != b.in.t ? a.in.t < b.in.t : a.segment < b.segment;
    });
    bool through = false;  // the ray runs in a span
    for (std::size_t i = 0; i < pieces.size();) {
        const Piece& first = pieces[i];
        if (!out.enter(start + first.in.t, face_of(first.segment, first.in.u))) return;
        const Piece* last = &first;
        for (++i; i < pieces.size() && pieces[i].in.t <= last->out.t; ++i)
            if (pieces[i].out.t > last->out.t) last = &pieces[i];
        through = through || (start + last->out.t > out.from && start + first.in.t < out.to);
        if (!out.leave(start + last->out.t, face_of(last->segment, last->out.u))) break;
    }
    if (through && reports_touches()) touch_within(near, start, out);
}

}  // namespace csg
