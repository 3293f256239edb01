#include "csg/freeform/field/isosurface_search.h"

#include "numbers/lanes.h"
#include "csg/base/fused_at.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace csg {
namespace {

constexpr int kParts = 8;

/// Sides of the boxes between from + k step and from + (k + 1) step, with room for rounding.
void sides(double origin, double direction, double from, double step, EightRanges& out)
{
    using lanes::Double;
    alignas(64) static constexpr double kPart[kParts] = {0, 1, 2, 3, 4, 5, 6, 7};
    const Double size(std::abs(origin));
    for (std::size_t k = 0; k < kParts; k += lanes::kDoubles) {
        const auto place = [&](const Double& part) {
            return Double(origin) + (Double(from) + part * Double(step)) * Double(direction);
        };
        const Double part = Double::load_aligned(kPart + k), a = place(part), b = place(part + Double(1.0)),
                     room = Double(kPointRoom) * (size + xsimd::abs(a) + xsimd::abs(b));
        (xsimd::min(b, a) - room).store_aligned(out.low.v + k);
        (xsimd::max(b, a) + room).store_aligned(out.high.v + k);
    }
}

}  // namespace

bool IsosurfaceSearch::is_far(const Container& container, const Ray& ray)
{
    // Sizes of the container; from there on points rounded twice are off by more than 1e-11 of it, and farther out a
    // shallow crossing falls apart into many.
    constexpr double kFar = 1e5;
    const Aabb box = container.bounds();
    const glm::dvec3 size = box.upper - box.lower, away = ray.origin - 0.5 * (box.lower + box.upper);
    return glm::dot(away, away) > kFar * kFar * glm::dot(size, size);
}

double IsosurfaceSearch::accuracy_along(const IsosurfaceTerms& terms, const Interval& way)
{
    constexpr double kLeastPart = 0x1p-40;  // of a ray's way through the container is told apart
    return std::max(terms.accuracy, (way.exit - way.entry) * kLeastPart);
}

IsosurfaceSearch::IsosurfaceSearch(const IsosurfaceTerms& terms, const Ray& ray, const Interval& way, double to)
    : terms_(terms), ray_(ray), box_(terms.field->rounded_box()), to_(to),
      speed_(std::sqrt(glm::dot(ray.direction, ray.direction))), gradient_(terms.max_gradient),
      accuracy_(accuracy_along(terms, way)), far_(is_far(terms.container, ray))
{}

glm::dvec3 IsosurfaceSearch::near_point(double t) const { return fused_at(ray_, t); }

void IsosurfaceSearch::sample(const Eight& t, double sign, Eight& f) const
{
    EightPoints p;
    for (int k = 0; k < kParts; ++k) {
        p.x.v[k] = ray_.origin.x + t.v[k] * ray_.direction.x;
        p.y.v[k] = ray_.origin.y + t.v[k] * ray_.direction.y;
        p.z.v[k] = ray_.origin.z + t.v[k] * ray_.direction.z;
    }
    if (far_)
        for (int k = 0; k < kParts; ++k) {
            const glm::dvec3 near = near_point(t.v[k]);
            p.x.v[k] = near.x, p.y.v[k] = near.y, p.z.v[k] = near.z;
        }
    terms_.field->values(p, f);
    for (double& v : f.v) v = sign * (v - terms_.threshold);
}

void IsosurfaceSearch::look(double from, double end)
{
    known_.from = from;
    known_.end = end;
    if (!by_ranges()) return;
    int halvings = 0;
    for (double length = end - from; length >= accuracy_; length *= 0.5) ++halvings;
    // Eighths as fine as POV-Ray's last halves, or up to four times finer.
    known_.levels = std::max(1, (halvings + 2) / 3);
    known_.grid = {from, (end - from) / std::ldexp(1.0, 3 * known_.levels), 3 * known_.levels - halvings};
    if (box_ != nullptr) return;
    known_.polynomial = terms_.field->polynomial() && find_polynomial();
    if (!known_.polynomial) ranges_of(known_.grid, 0, known_.levels, known_.ranges);
}

bool IsosurfaceSearch::starts_inside() const
{
    if (by_ranges() && box_ == nullptr) {
        const bool polynomial = known_.polynomial;
        const double low = polynomial ? known_.along.c[0] - known_.margin : known_.ranges.low.v[0] - terms_.threshold,
                     high = polynomial ? known_.along.c[0] + known_.margin : known_.ranges.high.v[0] - terms_.threshold;
        if (low > 0.0) return false;
        if (high < 0.0) return true;
    }
    return value(known_.from) < 0.0;
}

bool IsosurfaceSearch::first(double sign, double& found)
{
    const double from = known_.from, end = known_.end;
    if (!by_ranges()) {
        if (terms_.evaluate && gradient_ > terms_.growth.x) gradient_ *= terms_.growth.z;
        return bisect({from, sign * value(from)}, {end, sign * value(end)}, sign, found);
    }
    if (box_ != nullptr)
        return sign > 0.0 ? comes_in(known_.grid, known_.parts(), found) : goes_out(known_.grid, known_.parts(), found);
    if (known_.polynomial) return by_polynomial(sign, found);
    return eighths(known_.ranges, known_.grid, 0, known_.levels, sign, found);
}

/// By secants from before: beyond two places a convex field lies above the line through them, so that nothing is
/// inside before that line is.
bool IsosurfaceSearch::comes_in(const Grid& grid, std::int64_t parts, double& found) const
{
    std::int64_t before = 0, at = 1;
    double above = value(grid.at(before));
    for (;;) {
        const double here = value(grid.at(at));
        if (here < 0.0) {
            found = told(grid, at, 1.0);
            return true;
        }
        const double fall = (above - here) / static_cast<double>(at - before);
        if (!(fall > 0.0)) return false;
        const double skipped = std::max(1.0, std::floor(here / fall));
        if (!(skipped <= static_cast<double>(parts - at))) return false;
        before = at;
        above = here;
        if (grid.at(at) > to_) return false;
        at += static_cast<std::int64_t>(skipped);
    }
}

/// The same from behind, where everything is outside.
bool IsosurfaceSearch::goes_out(const Grid& grid, std::int64_t parts, double& found) const
{
    std::int64_t behind = parts, at = parts - 1;
    double above = value(grid.at(behind));
    if (!(above > 0.0)) return false;
    while (at > 0) {
        const double here = value(grid.at(at));
        if (!(here > 0.0)) break;
        const double rise = (above - here) / static_cast<double>(behind - at);
        const double skipped = rise > 0.0 ? std::max(1.0, std::floor(here / rise)) : 1.0;
        behind = at;
        above = here;
        at -= static_cast<std::int64_t>(std::min(skipped, static_cast<double>(at)));
    }
    // Rounding may have led past some that are outside.
    while (at + 1 < behind && !(value(grid.at(at + 1)) > 0.0)) ++at;
    found = told(grid, at + 1, -1.0);
    return true;
}

void IsosurfaceSearch::ranges_of(const Grid& grid, std::int64_t first, int level, EightRanges& f) const
{
    const double from = grid.at(first), step = grid.step * static_cast<double>(std::int64_t{1} << (3 * (level - 1)));
    EightBoxes boxes;
    sides(ray_.origin.x, ray_.direction.x, from, step, boxes.x);
    sides(ray_.origin.y, ray_.direction.y, from, step, boxes.y);
    sides(ray_.origin.z, ray_.direction.z, from, step, boxes.z);
    terms_.field->ranges(boxes, f);
}

bool IsosurfaceSearch::eighths(const Grid& grid, std::int64_t first, int level, double sign, double& found) const
{
    constexpr std::uint32_t kAll = (1u << kParts) - 1u;
    if (level == 1) return in_leaves(grid, first, kAll, sign, found);  // sooner than what their ranges would leave
    EightRanges f;
    ranges_of(grid, first, level, f);
    return eighths(f, grid, first, level, sign, found);
}

bool IsosurfaceSearch::eighths(const EightRanges& f, const Grid& grid, std::int64_t first, int level, double sign,
                               double& found) const
{
    const std::int64_t width = std::int64_t{1} << (3 * (level - 1));
    const double from = grid.at(first), step = grid.step * static_cast<double>(width);
    const auto clear = [&](int k) {
        return (sign > 0.0 ? f.low.v[k] - terms_.threshold : terms_.threshold - f.high.v[k]) > 0.0;
    };
    if (level > 1) {
        for (int k = 0; k < kParts && from + k * step <= to_; ++k)
            if (!clear(k) && eighths(grid, first + k * width, level - 1, sign, found)) return true;
        return false;
    }
    std::uint32_t open = 0;
    for (int k = 0; k < kParts; ++k) open |= clear(k) ? 0u : 1u << k;
    return open != 0 && in_leaves(grid, first, open, sign, found);
}

bool IsosurfaceSearch::in_leaves(const Grid& grid, std::int64_t first, std::uint32_t open, double sign,
                                 double& found) const
{
    constexpr int kFewLeaves = 2;  // are asked one by one: what the library computes is asked so anyway
    const bool few = std::popcount(open) <= kFewLeaves;
    Eight t, f;
    for (int k = 0; k < kParts; ++k) t.v[k] = grid.at(first + k + 1);
    if (!few) sample(t, sign, f);
    const auto is_met = [&](std::int64_t place) {  // POV-Ray's interval ends among the eight as well
        const std::int64_t k = place - first - 1;
        return (few ? sign * value(t.v[k]) : f.v[k]) < 0.0;
    };
    for (; open != 0; open &= open - 1) {
        const std::int64_t place = first + std::countr_zero(open) + 1;
        if (!is_met(place)) continue;
        found = told(grid, place, is_met);
        return true;
    }
    return false;
}

/// POV-Ray's own rule (spec 5b, 13.2): halves, the nearer one first, while the ends allow a root under the gradient.
bool IsosurfaceSearch::bisect(const Sample& left, const Sample& right, double sign, double& found)
{
    if (left.t > to_) return false;
    const double length = right.t - left.t, world = speed_ * length;
    if (terms_.evaluate) {
        const double slope = std::abs(right.f - left.f) / world;
        if (gradient_ < slope * terms_.growth.y) gradient_ = slope * terms_.growth.y * terms_.growth.y;
    }
    const double t = left.t + 0.5 * length;
    // From far off no number may lie between, however long the accuracy.
    if (length < accuracy_ || t == left.t || t == right.t) {
        found = right.t;
        return right.f < 0.0;
    }
    if (!(left.f + right.f - gradient_ * world < 0.0)) return false;
    const Sample middle{t, sign * value(t)};
    return bisect(left, middle, sign, found) || bisect(middle, right, sign, found);
}

}  // namespace csg
