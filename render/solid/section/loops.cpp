#include "render/solid/section/contour.h"

#include <algorithm>
#include <cmath>

namespace solid {
namespace {

constexpr int kFaceGrid = 64;       // lines across the plane by which a face in it is found
constexpr double kInFace = 1e-6;    // of the body's size: a face as near to the plane lies in it
constexpr double kAcross = 0.9999;  // cosine between the plane's normal and that of a face in it

double cross_of(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The point at which the loop turns most: no straight line goes on through it.
std::size_t sharpest(const Loop& loop)
{
    std::size_t best = 0;
    double least = 2.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec2 in = loop[i] - loop[(i + loop.size() - 1) % loop.size()],
                         on = loop[(i + 1) % loop.size()] - loop[i];
        const double lengths = glm::length(in) * glm::length(on);
        if (!(lengths > 0.0)) continue;
        if (const double cosine = glm::dot(in, on) / lengths; cosine < least) {
            least = cosine;
            best = i;
        }
    }
    return best;
}

}  // namespace

double distance_to_side(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 along = b - a;
    const double square = glm::dot(along, along);
    const double t = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(p - (a + t * along));
}

CuttingPlane beside_faces(const Body& body, const csg::Aabb& extent, CuttingPlane plane)
{
    const glm::dvec3 size = extent.upper - extent.lower;
    const double room = kInFace * glm::max(size.x, glm::max(size.y, size.z));
    const glm::dvec2 lower = plane.flat(extent.lower), wide = plane.flat(size);
    glm::dvec3 across(0.0);
    across[plane.axis] = 1.0;
    std::vector<Chord> chords;
    for (int j = 0; j < kFaceGrid; ++j)
        for (int i = 0; i < kFaceGrid; ++i) {
            const glm::dvec2 share((i + 0.5037) / kFaceGrid, (j + 0.4961) / kFaceGrid);
            const glm::dvec3 p = plane.point(lower + wide * share);
            body.chords(p, across, -numbers::kInfinity, numbers::kInfinity, chords);
            for (const Chord& chord : chords)
                for (const End* end : {&chord.in, &chord.out}) {
                    if (std::abs(end->t) > room) continue;
                    const glm::dvec3 normal = body.normal(p + end->t * across, *end);
                    if (normal != glm::dvec3(0.0) && std::abs(normal[plane.axis]) < kAcross) continue;
                    const double middle = 0.5 * (extent.lower[plane.axis] + extent.upper[plane.axis]);
                    plane.value += plane.value <= middle ? 4.0 * room : -4.0 * room;
                    return plane;
                }
        }
    return plane;
}

std::vector<Loop> without_straight_points(const std::vector<Loop>& loops, double room)
{
    std::vector<Loop> out;
    for (const Loop& loop : loops) {
        Loop kept;
        const std::size_t count = loop.size(), start = sharpest(loop);
        const auto at = [&](std::size_t i) { return loop[(start + i) % count]; };
        for (std::size_t from = 0; from < count;) {
            kept.push_back(at(from));
            // As far as the line from here passes all points between; doubling first would not be faster for arcs.
            std::size_t to = from + 1;
            for (bool passes = true; passes && to < count;) {
                for (std::size_t i = from + 1; i <= to && passes; ++i)
                    passes = distance_to_side(at(i), at(from), at(to + 1)) <= room;
                if (passes) ++to;
            }
            from = to;
        }
        out.push_back(kept.size() >= 3 ? std::move(kept) : loop);
    }
    return out;
}

double area_of(const std::vector<Loop>& loops)
{
    double sum = 0.0;
    for (const Loop& loop : loops)
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            sum += 0.5 * cross_of(loop[i] - loop[0], loop[i + 1] - loop[0]);
    return sum;
}

double length_of(const std::vector<Loop>& loops)
{
    double sum = 0.0;
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) sum += glm::length(loop[(i + 1) % loop.size()] - loop[i]);
    return sum;
}

}  // namespace solid
