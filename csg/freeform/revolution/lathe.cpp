#include "csg/freeform/revolution/axis_ray.h"
#include "csg/freeform/revolution/lathe_reach.h"

#include "numbers/functions/functions.h"
#include "numbers/safeguarded_newton.h"

#include <algorithm>
#include <numbers>

namespace csg {
namespace {

bool finite(const glm::dvec2& p) { return std::abs(p.x) < kInfinity && std::abs(p.y) < kInfinity; }

/// Where a component of a piece is `level` between lo and hi, within which it rises or falls.
double reached(const auto& piece, int k, double level, double lo, double hi, bool falling)
{
    const auto at = [&](double w) { return ValueAndSlope{piece.at(w)[k] - level, piece.slope(w)[k]}; };
    return safeguarded_newton(at, lo, hi, !falling, 0.5 * (lo + hi), {}, 80);
}

}  // namespace

double turn_about_y(const glm::dvec3& p, double widest)
{
    if (!(p.x * p.x + p.z * p.z > on_axis(widest))) return 0.0;
    const double turn = numbers::atan2(p.z, p.x) / (2.0 * std::numbers::pi);
    return turn < 0.0 ? turn + 1.0 : turn;
}

Lathe::Lathe(const std::vector<OutlinePiece>& segments, const Aabb& extent, double least_radius) : extent_(extent)
{
    for (const OutlinePiece& piece : segments)
        if (!finite(piece.a) || !finite(piece.b) || !finite(piece.c) || !finite(piece.d) || !finite(piece.start) ||
            !finite(piece.end))
            return;
    segments_ = static_cast<double>(std::max<std::size_t>(segments.size(), 1));
    for (std::size_t i = 0; i < segments.size(); ++i) add_segment(segments[i], static_cast<std::uint32_t>(i));
    find_reaches();
    find_rims();
    if (!rims_.empty()) hole_ = std::max(0.0, least_radius);
}

void Lathe::add_segment(const OutlinePiece& piece, std::uint32_t segment)
{
    constexpr double kShortest = 1e-9;  // of the parameter: shorter arcs are left to their neighbours
    const bool straight = piece.a == glm::dvec2(0.0) && piece.b == glm::dvec2(0.0);
    std::vector<double> cuts = {0.0, 1.0};
    for (int k = 0; k < 2 && !straight; ++k) {
        double turns[2];
        const int n = inner_roots(3.0 * piece.a[k], 2.0 * piece.b[k], piece.c[k], turns);
        cuts.insert(cuts.end(), turns, turns + n);
        const double bend = -piece.b[k] / (3.0 * piece.a[k]);
        if (bend > 0.0 && bend < 1.0) cuts.push_back(bend);
    }
    std::sort(cuts.begin(), cuts.end());
    std::vector<double> zeros;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double before = piece.at(cuts[i]).x, after = piece.at(cuts[i + 1]).x;
        if (before * after < 0.0) zeros.push_back(reached(piece, 0, 0.0, cuts[i], cuts[i + 1], after < 0.0));
    }
    cuts.insert(cuts.end(), zeros.begin(), zeros.end());
    std::sort(cuts.begin(), cuts.end());
    std::vector<double> kept = {0.0};
    for (const double cut : cuts)
        if (cut > kept.back() + kShortest && (cut < 1.0 - kShortest || cut == 1.0)) kept.push_back(cut);
    const auto point = [&](double w) {
        glm::dvec2 p = piece.at(w);
        if (std::find(zeros.begin(), zeros.end(), w) != zeros.end()) p.x = 0.0;
        return p;
    };
    for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
        const glm::dvec2 start = point(kept[i]), end = point(kept[i + 1]);
        if (start == end) continue;
        const bool negative = start.x + end.x < 0.0;
        negative_ = negative_ || negative;
        arcs_.push_back({piece.a, piece.b, piece.c, piece.d, kept[i], kept[i + 1], start, end, piece.slope(kept[i]),
                         piece.slope(kept[i + 1]), segment, straight, negative});
    }
}

void Lathe::Reaches::set(std::size_t lane, const Reach& reach)
{
    nearest[lane] = reach.nearest;
    farthest[lane] = reach.farthest;
    low[lane] = reach.low;
    high[lane] = reach.high;
}

Lathe::Reach Lathe::reach_of(std::size_t first, std::size_t last) const
{
    Reach reach;
    for (std::size_t i = first; i < last; ++i)
        for (const glm::dvec2& p : {arcs_[i].start, arcs_[i].end}) {
            reach.nearest = std::min(reach.nearest, std::abs(p.x));
            reach.farthest = std::max(reach.farthest, std::abs(p.x));
            reach.low = std::min(reach.low, p.y);
            reach.high = std::max(reach.high, p.y);
        }
    // More than the roundings of what is compared with it.
    const double margin = 1e-14 * std::max({reach.farthest, std::abs(reach.low), std::abs(reach.high)});
    return {std::max(0.0, reach.nearest - margin), reach.farthest + margin, reach.low - margin, reach.high + margin};
}

void Lathe::find_reaches()
{
    constexpr std::size_t kEight = Reaches::kArcs, kFewBlocks = 3;
    if (arcs_.empty()) return;
    all_ = reach_of(0, arcs_.size());
    reaches_.assign((arcs_.size() + kEight - 1) / kEight, Reaches{});
    for (std::size_t i = 0; i < arcs_.size(); ++i) reaches_[i / kEight].set(i % kEight, reach_of(i, i + 1));
    if (reaches_.size() < kFewBlocks) return;
    groups_.assign((reaches_.size() + kEight - 1) / kEight, Reaches{});
    for (std::size_t b = 0; b < reaches_.size(); ++b)
        groups_[b / kEight].set(b % kEight, reach_of(b * kEight, std::min((b + 1) * kEight, arcs_.size())));
}

/// Ends of arcs that no other end meets: a ray that passes within one enters or leaves there.
void Lathe::find_rims()
{
    std::vector<glm::dvec2> ends;
    for (const Arc& arc : arcs_) {
        if (arc.negative) continue;
        ends.push_back(arc.start);
        ends.push_back(arc.end);
    }
    std::sort(ends.begin(), ends.end(),
              [](const glm::dvec2& p, const glm::dvec2& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
    for (const glm::dvec2& p : ends) {
        if (!rims_.empty() && rims_.back() == p) rims_.pop_back();
        else rims_.push_back(p);
    }
    std::erase_if(rims_, [](const glm::dvec2& p) { return p.x <= 0.0; });
}

namespace {

/// Which arcs may turn about a point's axis above or below it, farther out.
struct ArcsBeyond {
    lanes::Double height, radius;

    template <class Reaches>
    std::uint32_t misses(const Reaches& reach, int at) const
    {
        using lanes::Double;
        return lanes::mask((height < Double::load_aligned(reach.low + at)) |
                           (height > Double::load_aligned(reach.high + at)) |
                           (radius > Double::load_aligned(reach.farthest + at)));
    }
};

}  // namespace

bool Lathe::contains(const glm::dvec3& p) const
{
    if (arcs_.empty()) return false;
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(rho <= all_.farthest) || !(p.y >= all_.low && p.y <= all_.high) || rho < hole_) return false;
    bool inside = false;
    each_near(ArcsBeyond{lanes::Double(p.y), lanes::Double(rho)}, [&](std::size_t i) {
        const Arc& arc = arcs_[i];
        if (arc.negative || (arc.start.y < p.y) == (arc.end.y < p.y)) return;
        const double r = arc.at(reached(arc, 1, p.y, arc.lo, arc.hi, arc.end.y < arc.start.y)).x;
        if (r >= rho) inside = !inside;
    });
    return inside;
}

double Lathe::parameter(const Arc& arc, const glm::dvec2& p) const
{
    const glm::dvec2 along = arc.end - arc.start;
    const int k = std::abs(along.y) > std::abs(along.x) ? 1 : 0;
    const double low = std::min(arc.start[k], arc.end[k]), high = std::max(arc.start[k], arc.end[k]);
    double w = (p[k] <= low) == (along[k] > 0.0) ? arc.lo : arc.hi;
    if (p[k] > low && p[k] < high) w = reached(arc, k, p[k], arc.lo, arc.hi, along[k] < 0.0);
    // One step to the foot of the perpendicular: near a turn one coordinate alone tells little.
    const glm::dvec2 slope = arc.slope(w);
    const double square = glm::dot(slope, slope);
    if (square > 0.0) w -= glm::dot(arc.at(w) - p, slope) / square;
    return glm::clamp(w, arc.lo, arc.hi);
}

glm::dvec3 Lathe::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    const double rho2 = p.x * p.x + p.z * p.z;
    if (!(rho2 > on_axis(all_.farthest))) return {0.0, 1.0, 0.0};
    const double rho = std::sqrt(rho2);
    const Arc& arc = arcs_[face];
    // Of a negative radius too, where it is no normal: as POV-Ray has it (spec 5b, 7.2).
    const glm::dvec2 slope = arc.slope(parameter(arc, {arc.negative ? -rho : rho, p.y}));
    return {slope.y * p.x, -slope.x * rho, slope.y * p.z};
}

glm::dvec2 Lathe::uv(const glm::dvec3& p, std::uint32_t face) const
{
    const Arc& arc = arcs_[face];
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    return {turn_about_y(p, all_.farthest),
            (arc.segment + parameter(arc, {arc.negative ? -rho : rho, p.y})) / segments_};
}

Aabb Lathe::bounds() const
{
    if (arcs_.empty()) return {};
    return {{-all_.farthest, all_.low, -all_.farthest}, {all_.farthest, all_.high, all_.farthest}};
}

}  // namespace csg
