#include "csg/freeform/surface/parametric.h"

#include <algorithm>

namespace csg {
namespace {

constexpr int kKnownLevels = 14;
constexpr std::uint32_t kLastSplit = 0x40000000u;  // parts from here on are not parted: their number fits 32 bits
constexpr double kParallel = 1e-10;                // of a surface larger than the world, of the ray's length there

}  // namespace

Parametric::Part Parametric::Part::half(int which) const
{
    Part out = *this;
    const int k = longer();
    const double middle = 0.5 * (lower[k] + upper[k]);
    (which == 0 ? out.upper : out.lower)[k] = middle;
    out.number = 2 * number + static_cast<std::uint32_t>(which);
    return out;
}

Parametric::Part Parametric::part(std::uint32_t number) const
{
    Part out = whole();
    int level = 31;
    while (level > 0 && ((number >> level) & 1u) == 0) --level;
    while (level-- > 0) out = out.half(static_cast<int>((number >> level) & 1u));
    return out;
}

/// Corners at (low u, low v), (low u, high v), (high u, low v), (high u, high v) (spec 5b, 14.1).
Parametric::Range Parametric::range_of(const double* corners, const Part& part) const
{
    const auto room = [&](double p, double q, double length) {
        return std::max(0.0, 0.5 * (terms_.max_gradient * length - std::abs(p - q)));
    };
    const glm::dvec2 size = part.upper - part.lower;
    double low[2], high[2];
    for (int side = 0; side < 2; ++side) {
        const double p = corners[2 * side] - terms_.accuracy, q = corners[2 * side + 1] - terms_.accuracy,
                     more = room(p, q, size.y);
        low[side] = std::min(p, q) - more;
        high[side] = std::max(p, q) + more;
    }
    return {std::min(low[0], low[1]) - room(low[0], low[1], size.x),
            std::max(high[0], high[1]) + room(high[0], high[1], size.x)};
}

void Parametric::ranges(const Part& a, const Part& b, std::size_t axis, Range& of_a, Range& of_b) const
{
    EightPoints at;
    for (int i = 0; i < 8; ++i) {
        const Part& part = i < 4 ? a : b;
        at.x.v[i] = (i & 2) != 0 ? part.upper.x : part.lower.x;
        at.y.v[i] = (i & 1) != 0 ? part.upper.y : part.lower.y;
        at.z.v[i] = 0.0;
    }
    Eight f;
    terms_.field[axis]->values(at, f);
    of_a = range_of(f.v, a);
    of_b = range_of(f.v + 4, b);
}

/// Where POV-Ray precomputes, a part's range is that of its halves.
void Parametric::unite(std::uint32_t number)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!terms_.precomputed[axis]) continue;
        const Range &a = known_[2 * number][axis], &b = known_[2 * number + 1][axis];
        known_[number][axis] = {std::min(a.low, b.low), std::max(a.high, b.high)};
    }
}

void Parametric::prepare()
{
    const int levels = std::max(kKnownLevels, terms_.precompute);
    const std::uint32_t end = 1u << levels;
    known_.resize(end);
    for (std::size_t axis = 0; axis < 3; ++axis) ranges(whole(), whole(), axis, known_[1][axis], known_[1][axis]);
    const auto fill = [&](const auto& again, const Part& parent) -> void {
        if (2 * parent.number >= end) return;
        const Part a = parent.half(0), b = parent.half(1);
        for (std::size_t axis = 0; axis < 3; ++axis) ranges(a, b, axis, known_[a.number][axis], known_[b.number][axis]);
        again(again, a);
        again(again, b);
    };
    fill(fill, whole());
    if (terms_.precompute < 1) return;
    for (std::uint32_t number = (1u << (terms_.precompute - 1)) - 1; number > 0; --number) unite(number);
}

struct Parametric::Search {
    glm::dvec3 origin, direction;
    double first, last, best, parallel;
    std::uint32_t found = 0;

    /// What the coordinates so far leave of the ray; longest: of their ranges along it; entry: where the last of them
    /// begins.
    struct Along {
        double low = -kInfinity, high = kInfinity, longest = 0.0, entry = -kInfinity;
    };
    /// Takes in coordinate k. False: the part need not be looked into.
    bool narrow(int k, const Range& side, Along& along) const
    {
        if (std::abs(direction[k]) < parallel) return origin[k] >= side.low && origin[k] <= side.high;
        double a = (side.low - origin[k]) / direction[k], b = (side.high - origin[k]) / direction[k];
        if (a > b) std::swap(a, b);
        if (!(b >= first && a <= last && a <= best && a <= along.high && b >= along.low)) return false;
        along = {std::max(along.low, a), std::min(along.high, b), std::max(along.longest, b - a), a};
        return true;
    }
    bool meets(const Ranges& box, Along& along) const
    {
        return narrow(0, box[0], along) && narrow(1, box[1], along) && narrow(2, box[2], along);
    }
};

void Parametric::intersect(const Ray& ray, IntersectionList& out) const
{
    Interval way;
    if (known_.empty() || !terms_.container.interval(ray, way)) return;
    double first = terms_.container.is_sphere ? way.entry : std::max(way.entry, 0.0);
    if (first == way.exit) first = 0.0;
    first += 4.0 * terms_.accuracy;
    if (!(first <= way.exit) || way.entry > out.to) return;
    Search search{ray.origin, ray.direction, first,
                  way.exit,   kInfinity,     kParallel * glm::min(1.0, glm::length(ray.direction))};
    struct Waiting {
        Part part;
        Ranges box;
    };
    std::array<Waiting, 34> stack;  // one a level, and the part at hand
    std::size_t height = 0;
    stack[height++] = {whole(), known_[1]};
    while (height > 0) {
        const Waiting here = stack[--height];
        Search::Along along;
        if (!search.meets(here.box, along)) continue;
        const Part& part = here.part;
        const int side = part.longer();
        if (std::min(part.upper[side] - part.lower[side], along.longest) < terms_.accuracy ||
            part.number >= kLastSplit) {
            if (!(search.best > along.entry && along.entry > first)) continue;
            search.best = along.entry;
            search.found = part.number;
            continue;
        }
        const Part halves[2] = {part.half(0), part.half(1)};
        if (halves[1].number < known_.size()) {
            for (const int k : {1, 0}) stack[height++] = {halves[k], known_[halves[k].number]};
            continue;
        }
        // Most parts are left after one coordinate: the others are not asked for.
        Ranges boxes[2];
        Search::Along ways[2];
        bool open[2] = {true, true};
        for (std::size_t axis = 0; axis < 3 && (open[0] || open[1]); ++axis) {
            ranges(halves[0], halves[1], axis, boxes[0][axis], boxes[1][axis]);
            for (const int k : {0, 1})
                open[k] = open[k] && search.narrow(static_cast<int>(axis), boxes[k][axis], ways[k]);
        }
        for (const int k : {1, 0})
            if (open[k]) stack[height++] = {halves[k], boxes[k]};
    }
    if (search.found != 0 && search.best < way.exit) out.touch(search.best, search.found);
}

glm::dvec3 Parametric::point(double u, double v) const
{
    const glm::dvec3 at(u, v, 0.0);
    return {terms_.field[0]->value(at), terms_.field[1]->value(at), terms_.field[2]->value(at)};
}

glm::dvec3 Parametric::gradient(const glm::dvec3&, std::uint32_t face) const
{
    const glm::dvec2 at = part(face).lower;
    const glm::dvec3 here = point(at.x, at.y);
    return glm::cross(point(at.x + terms_.accuracy, at.y) - here, point(at.x, at.y + terms_.accuracy) - here);
}

}  // namespace csg
