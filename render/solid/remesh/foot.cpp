#include "render/solid/remesh/foot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace solid {
namespace {

constexpr double kNear = 0.1;  // of the reach
constexpr double kFold = 0.2;  // cosine: what turns so far from a side is another one
/// Of the way from the meeting place into a side: where its tangent plane is taken, one after the other.
constexpr std::array<double, kExactSteps> kShares{0.5, 0.2, 0.04, 0.004, 0.0004};

Foot foot_within(const Body& body, const glm::dvec3& point, const glm::dvec3& out, double reach)
{
    thread_local std::vector<Chord> chords;
    body.chords(point, out, -reach, reach, chords);
    Foot best;
    double nearest = reach;
    for (const Chord& chord : chords) {
        const double t = std::abs(chord.out.t);
        if (t > nearest) continue;
        nearest = t;
        best.found = true;
        best.end = chord.out;
    }
    if (!best.found) return best;
    best.at.point = point + best.end.t * out;
    best.at.normal = body.normal(best.at.point, best.end);
    if (best.at.normal == glm::dvec3(0.0)) best.at.normal = out;
    else if (glm::dot(best.at.normal, out) < 0.0) best.at.normal = -best.at.normal;
    return best;
}

}  // namespace

Foot foot_of(const Body& body, const glm::dvec3& point, const glm::dvec3& out, double reach)
{
    // Mostly it is near, and a short line is followed sooner.
    const Foot near = foot_within(body, point, out, kNear * reach);
    return near.found ? near : foot_within(body, point, out, reach);
}

bool meeting_place(const Body& body, std::span<Side> sides, const glm::dvec3& start, double size, std::size_t steps,
                   glm::dvec3& out)
{
    if (sides.size() > 16) return false;
    std::array<SurfacePoint, 16> planes;
    glm::dvec3 x = start;
    for (const double share : std::span(kShares).first(steps)) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            Side& side = sides[i];
            const glm::dvec3 from = x + share * (side.within - x);
            const Foot foot = foot_of(body, from, side.normal, size);
            if (!foot.found || glm::dot(foot.at.normal, side.normal) < kFold) {
                if (!side.foot.found) return false;
            } else {
                side.foot = foot;
                side.normal = foot.at.normal;
            }
            planes[i] = side.foot.at;
        }
        x = meeting_point(std::span(planes.data(), sides.size()), x);
        const glm::dvec3 moved = x - start;
        if (!(glm::dot(moved, moved) <= size * size)) return false;
    }
    out = x;
    return true;
}

bool is_sharp_between(const Body& body, const SurfacePoint& a, const SurfacePoint& b)
{
    constexpr int kHalvings = 7;
    SurfacePoint p = a, q = b;
    for (int i = 0; i < kHalvings; ++i) {
        const glm::dvec3 both = p.normal + q.normal;
        const double length = glm::length(both), wide = glm::length(q.point - p.point);
        if (!(length > 1e-3) || !(wide > 0.0)) return true;
        const Foot foot = foot_of(body, 0.5 * (p.point + q.point), both / length, 2.0 * wide);
        if (!foot.found) return true;
        (glm::dot(foot.at.normal, p.normal) > glm::dot(foot.at.normal, q.normal) ? p : q) = foot.at;
        if (glm::dot(p.normal, q.normal) > kSharpTurn) return false;
    }
    return true;
}

}  // namespace solid
