#include "csg/bvh/traverse.h"
#include "csg/freeform/sweep/sphere_sweep.h"
#include "csg/freeform/sweep/swept_spheres.h"

/// The surfaces that POV-Ray shows within a sphere sweep whose segments are curved (spec 5b, 9.3). It sees the sphere
/// of a segment only where its ends along the ray stand still, and keeps of all candidates those at which its count
/// says that the ray enters or leaves. Where a ray runs along a segment, spheres that fill it are no candidates, and
/// the count finds a gap; a flat end without its counterpart leaves the count off by one.
namespace csg {
namespace {

constexpr double kAlike = 1e-6;         // scene units: a candidate so near to an end of a span is that end
constexpr double kGrazing = 1e-6;       // squared half chord of a joint's sphere that POV-Ray leaves out (spec 5b, 9.2)
constexpr double kLevelSegment = 1e-6;  // rate of a segment along a ray that does not meet its flat ends

constexpr double kFlush = 1e-9;  // scene units: what rounding leaves between flat ends of one plane

}  // namespace

void SphereSweep::candidates(std::uint32_t index, const Ray& ray, std::vector<Candidate>& out) const
{
    const Segment& segment = segments_[index];
    const SweptSpheres<4> spheres = spheres_along<4>(
        ray.direction, [&](std::size_t k) { return segment.control[k] - glm::dvec4(ray.origin, 0.0); });
    if (ordinate_changes(spheres.reach) == 0 && !(spheres.reach[0] > 0.0)) return;
    const auto sphere = [&](double u, double m, double reach) {
        const double half = std::sqrt(std::max(reach, 0.0));
        const bool outward = segment.at(u).w >= 0.0;
        out.push_back({m - half, outward && half > 0.0, face_of(index, u)});
        out.push_back({m + half, !outward && half > 0.0, face_of(index, u)});
    };
    const std::uint32_t flat = index + static_cast<std::uint32_t>(segments_.size());
    for (const double u : {0.0, 1.0}) {
        double m = 0.0, way = 0.0, reach = 0.0, rate = 0.0;
        detail::casteljau(spheres.m, u, m, way);
        detail::casteljau(spheres.reach, u, reach, rate);
        const bool joint = u == 0.0 || index + 1 == segments_.size();  // the next segment begins with this sphere
        if (joint && reach > kGrazing) sphere(u, m, reach);
        if (std::abs(way) <= kLevelSegment) continue;
        const double ahead = -0.5 * rate / way;  // of the sphere's middle along the ray
        if (ahead * ahead < reach) out.push_back({m + ahead, (way > 0.0) == (u == 0.0), face_of(flat, u)});
    }
    Extremes<4>(spheres).each_place([&](double u) {
        double m = 0.0, reach = 0.0, unused = 0.0;
        detail::casteljau(spheres.m, u, m, unused);
        detail::casteljau(spheres.reach, u, reach, unused);
        sphere(u, m, reach);
    });
}

/// `ray` begins at `start` of the one that is asked for. Its spans have been told.
void SphereSweep::touch_within(const Ray& ray, double start, IntersectionList& out) const
{
    thread_local std::vector<Candidate> all;
    all.clear();
    const double length = std::sqrt(glm::dot(ray.direction, ray.direction));
    const Ray along{ray.origin, ray.direction / length};
    if (tree_.nodes.empty()) {
        for (std::uint32_t i = 0; i < segments_.size(); ++i) candidates(i, along, all);
    } else {
        double limit = kInfinity;
        traverse(tree_, RaySlabs(along), -kInfinity, limit, ~0u, [&](ChildWord leaf) {
            candidates(leaf.index(), along, all);
            return limit;
        });
    }
    std::sort(all.begin(), all.end(),
              [](const Candidate& a, const Candidate& b) { return a.t != b.t ? a.t < b.t : a.face < b.face; });
    int depth = 1;  // after the first, which begins a span, as the last ends one
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
        const Candidate &here = all[i], &next = all[i + 1];
        // Flat ends of neighbours lie in one plane: which of the two comes first is POV-Ray's rounding.
        const bool flat = std::min(here.face, next.face) >> kPlaceBits >= segments_.size();
        if (flat && !here.enters && next.enters && next.t - here.t <= kFlush) {
            ++i;
            continue;
        }
        const bool kept = depth == (here.enters ? 0 : 1);
        depth += here.enters ? 1 : -1;
        if (!kept) continue;
        const double t = start + here.t / length;
        bool end = false;
        out.each_span([&](double in, std::uint32_t, double away, std::uint32_t) {
            end = end || std::min(std::abs(t - in), std::abs(t - away)) * length <= kAlike;
        });
        if (!end) out.touch(t, here.face);
    }
}

}  // namespace csg
