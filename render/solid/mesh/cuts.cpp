#include "render/solid/mesh/cuts.h"

#include <algorithm>
#include <cmath>

namespace solid {
namespace {

constexpr double kRounding = 1e-6;   // of an edge: ends of chords so far beyond it are taken for its own
constexpr double kLeastShare = 0.2;  // of an edge: where it is split

struct Passage {
    double t = 0.0;
    bool entering = false;
    const End* end = nullptr;
};

/// Tangent of the angle between a line and the surface that it passes.
double slope_of(const Body& body, const glm::dvec3& point, const End& end, const glm::dvec3& along)
{
    const double sine = std::min(1.0, std::abs(glm::dot(body.normal(point, end), along)));
    return sine / std::sqrt(std::max(1.0 - sine * sine, 1e-30));
}

}  // namespace

double height_between(const Body& body, const glm::dvec3& from, const glm::dvec3& along, const End& a, const End& b)
{
    const double first = slope_of(body, from + a.t * along, a, along),
                 second = slope_of(body, from + b.t * along, b, along);
    const double both = first + second;
    return both > 0.0 ? (b.t - a.t) * (first / both) * second : 0.0;
}

double end_room(double length, const Finish& finish)
{
    return std::clamp(std::max(0.1 * finish.off, 4.0 * finish.grain) / length, 1e-3, 0.1);
}

bool cut_edge(const Body& body, const Finish& finish, const glm::dvec3& from, const glm::dvec3& along, double start,
              double length, bool first_inside, bool second_inside, const std::vector<Chord>& chords, EdgeCut& out,
              std::uint64_t& lost)
{
    out.crosses = first_inside != second_inside;
    out.split = std::numeric_limits<double>::quiet_NaN();
    const double room = kRounding * length;
    thread_local std::vector<Passage> passed;
    passed.clear();
    for (const Chord& chord : chords) {
        if (chord.in.t > start + length + room) break;
        if (chord.out.t < start - room) continue;
        if (chord.in.t >= start - room) passed.push_back({chord.in.t - start, true, &chord.in});
        if (chord.out.t <= start + length + room) passed.push_back({chord.out.t - start, false, &chord.out});
    }
    // At the very ends of the edge the corner's own side decides.
    const bool entering = !first_inside;
    if (!out.crosses) std::erase_if(passed, [&](const Passage& p) { return p.t <= room || p.t >= length - room; });
    if (passed.empty() && !out.crosses) return false;

    if (passed.size() > 1) {  // the parts between two passages
        double widest = 0.0, middle = 0.0;
        for (std::size_t i = 0; i + 1 < passed.size(); ++i) {
            const double wide = passed[i + 1].t - passed[i].t;
            if (wide <= std::max(widest, finish.narrow)) continue;
            if (2.0 * height_between(body, from, along, *passed[i].end, *passed[i + 1].end) <= finish.narrow) continue;
            widest = wide;
            middle = passed[i].t + 0.5 * wide;
        }
        if (widest > finish.narrow && length > finish.least) {
            const double share = middle / length;
            out.split = share >= kLeastShare && share <= 1.0 - kLeastShare ? share : 0.5;
        }
    }
    if (!out.crosses) return out.split == out.split;
    const Passage* best = nullptr;
    for (const Passage& p : passed)
        if (p.entering == entering &&
            (best == nullptr || std::abs(p.t - 0.5 * length) < std::abs(best->t - 0.5 * length)))
            best = &p;
    const double least = end_room(length, finish) * length;
    double at = 0.5 * length;
    if (best != nullptr) {
        at = best->t;
        const glm::dvec3 point = from + (start + at) * along;
        out.place.normal = body.normal(point, *best->end);
        if ((glm::dot(out.place.normal, along) > 0.0) == entering) out.place.normal = -out.place.normal;
    } else {
        ++lost;
        double low = 0.0, high = length;
        for (int i = 0; i < 40; ++i) {
            at = 0.5 * (low + high);
            (body.inside(from + (start + at) * along, along) == first_inside ? low : high) = at;
        }
        out.place.normal = entering ? -along : along;
    }
    if (out.place.normal == glm::dvec3(0.0)) out.place.normal = entering ? -along : along;
    out.place.point = from + (start + std::clamp(at, least, length - least)) * along;
    return true;
}

bool cut_edge(const Body& body, const Finish& finish, const std::vector<glm::dvec3>& points,
              const std::vector<std::uint8_t>& inside, std::uint64_t edge, EdgeCut& out, std::uint64_t& lost)
{
    thread_local std::vector<Chord> chords;
    const glm::dvec3 a = points[first_of(edge)], b = points[second_of(edge)];
    const double length = glm::length(b - a);
    const glm::dvec3 along = (b - a) / length;
    body.chords(a, along, -kRounding * length, (1.0 + kRounding) * length, chords);
    // Ends of chords beyond the range mean nothing.
    out.edge = edge;
    return cut_edge(body, finish, a, along, 0.0, length, inside[first_of(edge)] != 0, inside[second_of(edge)] != 0,
                    chords, out, lost);
}

}  // namespace solid
