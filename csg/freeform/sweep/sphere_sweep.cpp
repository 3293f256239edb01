#include "csg/freeform/sweep/sphere_sweep.h"

#include "csg/freeform/shared/bernstein.h"
#include "csg/freeform/shared/similarity.h"
#include "csg/solids/shared/common.h"

namespace csg {
namespace {

glm::dvec4 joined(const SphereSweep::SweptSphere& sphere) { return {sphere.center, sphere.radius}; }

bool finite(const glm::dvec4& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

/// Whether the point lies in one of the spheres.
template <std::size_t count, class From>
bool within(From&& from)
{
    std::array<double, count> part[4];
    for (std::size_t k = 0; k < count; ++k)
        for (int i = 0; i < 4; ++i) part[i][k] = from(k)[i];
    auto reach = product(part[3], part[3]);
    for (int axis = 0; axis < 3; ++axis) {
        const auto square = product(part[axis], part[axis]);
        for (std::size_t i = 0; i < square.size(); ++i) reach[i] -= square[i];
    }
    bool found = reach.front() >= 0.0 || reach.back() >= 0.0;
    if (!found)
        each_change(reach, 0.0, 1.0, kHalvings, [&](double) {
            found = true;
            return false;
        });
    return found;
}

}  // namespace

glm::dvec4 SphereSweep::Segment::at(double u) const
{
    const double v = 1.0 - u;
    if (linear) return v * control[0] + u * control[1];
    return v * v * v * control[0] + 3.0 * v * v * u * control[1] + 3.0 * v * u * u * control[2] +
           u * u * u * control[3];
}

glm::dvec4 SphereSweep::Segment::rate(double u) const
{
    const double v = 1.0 - u;
    if (linear) return control[1] - control[0];
    return 3.0 * (v * v * (control[1] - control[0]) + 2.0 * v * u * (control[2] - control[1]) +
                  u * u * (control[3] - control[2]));
}

SphereSweep::SphereSweep(Spline spline, std::span<const SweptSphere> spheres)
    : spline_(spline), spheres_(spheres.begin(), spheres.end())
{
    const std::size_t wanted = spline == Spline::Linear ? 2 : 4;
    for (std::size_t i = 0; i + wanted <= spheres.size() && segments_.size() < kMostSegments; ++i) {
        const glm::dvec4 a = joined(spheres[i]), b = joined(spheres[i + 1]);
        if (spline == Spline::Linear) {
            add({{a, b, b, b}, true});
            continue;
        }
        const glm::dvec4 c = joined(spheres[i + 2]), d = joined(spheres[i + 3]);
        if (spline == Spline::Cubic) add({{b, b + (c - a) / 6.0, c - (d - b) / 6.0, c}, false});
        else add({{(a + 4.0 * b + c) / 6.0, (2.0 * b + c) / 3.0, (b + 2.0 * c) / 3.0, (b + 4.0 * c + d) / 6.0}, false});
    }
    for (const Aabb& box : boxes_) box_.include(box);
    if (box_.empty()) return;
    middle_ = 0.5 * (box_.lower + box_.upper);
    if (segments_.size() <= kMostLoose) return;
    std::vector<BvhInput> inputs;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        inputs.push_back({.bounds = boxes_[i], .index = static_cast<std::uint32_t>(i)});
    tree_ = build_bvh(std::move(inputs));
}

void SphereSweep::add(const Segment& segment)
{
    Aabb box;
    for (const glm::dvec4& c : segment.control) {
        if (!finite(c)) return;
        box.include({glm::dvec3(c) - std::abs(c.w), glm::dvec3(c) + std::abs(c.w)});
    }
    segments_.push_back(segment);
    boxes_.push_back(padded(box));
}

Aabb SphereSweep::extent(const Transform& moved) const
{
    const double times = spline_ == Spline::Cubic ? 2.0 : 1.0;
    double factor = 1.0;
    const bool round = keeps_spheres(moved.linear, factor);
    Aabb box;
    for (const SweptSphere& sphere : spheres_) {
        const double reach = times * std::abs(sphere.radius) * (round ? factor : 1.0);
        const glm::dvec3 c = round ? moved.point(sphere.center) : sphere.center;
        box.include({c - reach, c + reach});
    }
    return round ? box : transformed_box(moved, box);
}

bool SphereSweep::contains(const glm::dvec3& p) const
{
    for (std::size_t i = 0; i < segments_.size(); ++i) {
        const Aabb& box = boxes_[i];
        if (!(glm::all(glm::lessThanEqual(box.lower, p)) && glm::all(glm::lessThanEqual(p, box.upper)))) continue;
        const auto from = [&](std::size_t k) { return segments_[i].control[k] - glm::dvec4(p, 0.0); };
        if (segments_[i].linear ? within<2>(from) : within<4>(from)) return true;
    }
    return false;
}

glm::dvec3 SphereSweep::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    const std::size_t number = face >> kPlaceBits, count = segments_.size();
    const double place = static_cast<double>(face & kPlaces) / kPlaces, step = 1.0 / kPlaces;
    if (number >= count) return glm::dvec3(segments_[std::min(number - count, count - 1)].rate(place)) * (place - 0.5);
    const Segment& segment = segments_[number];
    double low = std::max(0.0, place - step), high = std::min(1.0, place + step);
    // The sphere that touches p there: the distance from its surface is least, and this is the rate at which it grows.
    const auto rate = [&](double u) {
        const glm::dvec4 c = segment.at(u), d = segment.rate(u);
        return glm::dot(glm::dvec3(c) - p, glm::dvec3(d)) - c.w * d.w;
    };
    double at_low = rate(low), at_high = rate(high), u = at_low > 0.0 ? low : high;
    constexpr double kClose = 1e-12;  // of the segment
    for (int i = 0; i < 60 && at_low <= 0.0 && at_high > 0.0 && high - low > kClose; ++i) {
        // The chord's zero, and half of the bracket where that is outside.
        u = low + (high - low) * (at_low / (at_low - at_high));
        if (i % 3 == 2 || !(u > low && u < high)) u = 0.5 * (low + high);
        const double here = rate(u);
        if (std::abs(here) <= kClose * (at_high - at_low)) break;
        (here > 0.0 ? high : low) = u;
        (here > 0.0 ? at_high : at_low) = here;
    }
    const glm::dvec4 c = segment.at(u);
    return (p - glm::dvec3(c)) * (c.w < 0.0 ? -1.0 : 1.0);
}

}  // namespace csg
