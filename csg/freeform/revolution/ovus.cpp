#include "csg/freeform/revolution/ovus.h"

#include "csg/solids/shared/common.h"
#include "csg/solids/shared/slab.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace csg {
namespace {

/// The ray's part in a sphere, cut to [from, to].
bool in_sphere(const glm::dvec3& o, const glm::dvec3& e, const glm::dvec3& center, double radius, double& from,
               double& to)
{
    const glm::dvec3 off = o - center;
    const double shift = -glm::dot(off, e);
    const glm::dvec3 foot = off + shift * e;
    const double room = radius * radius - glm::dot(foot, foot);
    if (!(room > 0.0)) return false;
    const double half = std::sqrt(room);
    from = glm::max(from, shift - half);
    to = glm::min(to, shift + half);
    return from <= to;
}

}  // namespace

Ovus::Ovus(double bottom, double top) : bottom_(bottom), top_(top), distance_(bottom)
{
    const double b = bottom, t = top;
    if (t < b) {
        arc_ = 2.0 * b;
        height_ = 2.0 * t - b - t * t / (2.0 * b);
        offset_ = std::sqrt(glm::max((b - height_) * (b + height_), 0.0));
        low_ = -height_;
        high_ = b + (b - height_) * t / (arc_ - t);
    } else {
        arc_ = 2.0 * t;
        height_ = b - 2.0 * t + 3.0 * t * t / (2.0 * b);
        offset_ = std::sqrt(glm::max((t - (height_ - b)) * (t + (height_ - b)), 0.0));
        low_ = -height_ * b / (arc_ - b);
        high_ = 2.0 * b - height_;
    }
}

/// The arc touches both spheres from outside of them: its middle is as far from theirs as its radius is larger. Where
/// the second sphere is the larger one the middle lies above that sphere's in POV-Ray 3.8, never below (spec 7c, 2).
Ovus::Ovus(double bottom, double top, double distance, double arc)
    : bottom_(bottom), top_(top), distance_(distance), arc_(arc), heights_of_38_(true)
{
    const double b = arc - bottom, t = arc - top;
    height_ = ((b - t) * (b + t) / distance + distance) / 2.0;
    offset_ = std::sqrt(glm::max((b - height_) * (b + height_), 0.0));
    stepped_ = top > bottom && height_ < distance;
    if (stepped_) height_ = 2.0 * distance - height_;
    low_ = -height_ * bottom / b;
    high_ = distance + (distance - height_) * top / t;
}

/// How far a point at parameter s lies outside of the arc, rho + offset - sqrt(arc^2 - (y - height)^2), is a convex
/// function of s: Newton's steps from either end never pass the nearest root. Without `both`, `to` is not cut.
bool Ovus::between(const glm::dvec3& o, const glm::dvec3& e, double& from, double& to, bool both) const
{
    const auto outside = [&](double s, double& slope) {
        const glm::dvec3 p = o + s * e;
        const double rho = std::sqrt(p.x * p.x + p.z * p.z), up = p.y - height_;
        const double width = std::sqrt(glm::max((arc_ - up) * (arc_ + up), 0.0));
        slope = (rho > 0.0 ? (p.x * e.x + p.z * e.z) / rho : 0.0) + (width > 0.0 ? up * e.y / width : 0.0);
        return rho + offset_ - width;
    };
    constexpr double kClose = 1e-12;  // of the arc's radius: so small a step has squared the error before it
    const auto approach = [&](double& s, double end, double way) {
        for (int i = 0; i < 100; ++i) {
            double slope = 0.0;
            const double value = outside(s, slope);
            if (value <= 0.0) return true;
            if (!(way * slope < 0.0)) return false;
            const double step = -value / slope;
            s += step;
            if (way * (end - s) < 0.0) return false;
            if (std::abs(step) <= kClose * arc_) return true;
        }
        return true;
    };
    return approach(from, to, 1.0) && (!both || approach(to, from, -1.0));
}

/// Where the arc begins on the axis.
double Ovus::tip() const { return height_ - std::sqrt((arc_ - offset_) * (arc_ + offset_)); }

/// What the spheres and the arc hold together; crossings that are drawn though one of the others holds them bound
/// nothing.
void Ovus::intersect_stepped(const glm::dvec3& o, const glm::dvec3& e, double shift, double length,
                             IntersectionList& out) const
{
    std::array<Interval, 3> parts;
    std::size_t count = 0;
    const auto ball = [&](double middle, double radius, auto&& face_at) {
        double from = -kInfinity, to = kInfinity;
        if (in_sphere(o, e, {0.0, middle, 0.0}, radius, from, to))
            parts[count++] = {from, to, face_at(o.y + from * e.y), face_at(o.y + to * e.y)};
    };
    ball(0.0, bottom_, [&](double y) { return y < low_ ? kBelow : kUndrawnFace; });
    ball(distance_, top_, [&](double y) { return y > high_ ? kAbove : kUndrawnFace; });
    Interval zone;
    double from = -kInfinity, to = kInfinity;
    if (slab(o.y, e.y, glm::max(low_, tip()), high_, zone) &&
        in_sphere(o, e, {0.0, 0.5 * distance_, 0.0}, bottom_ + 0.5 * distance_ + top_, from, to)) {
        const double begin = glm::max(zone.entry, from), end = glm::min(zone.exit, to);
        double in = begin, leave = end;
        if (begin <= end && between(o, e, in, leave, true))
            parts[count++] = {in, leave, in > begin ? kBetween : kUndrawnFace, leave < end ? kBetween : kUndrawnFace};
    }
    std::sort(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Interval& a, const Interval& b) { return a.entry < b.entry; });
    const auto world = [&](double s) { return (shift + s) / length; };
    const double slack = 1e-12 * arc_;  // two that touch are one
    for (std::size_t i = 0; i < count;) {
        Interval all = parts[i];
        for (++i; i < count && parts[i].entry <= all.exit + slack; ++i) {
            Interval& next = parts[i];
            if (next.exit > all.exit) {
                std::swap(next.exit, all.exit);
                std::swap(next.exit_face, all.exit_face);
            }
            out.touch(world(next.entry), next.entry_face);
            out.touch(world(next.exit), next.exit_face);
        }
        if (!out.enter(world(all.entry), all.entry_face) || !out.leave(world(all.exit), all.exit_face)) return;
    }
}

void Ovus::intersect(const Ray& ray, IntersectionList& out) const
{
    const double length = std::sqrt(glm::dot(ray.direction, ray.direction));
    if (!(length > 0.0 && length < kInfinity)) return;
    const glm::dvec3 e = ray.direction / length, middle(0.0, 0.5 * distance_, 0.0);
    const double shift = -glm::dot(ray.origin - middle, e);
    const glm::dvec3 o = ray.origin + shift * e;  // near the middle
    if (stepped_) return intersect_stepped(o, e, shift, length, out);
    double from = -kInfinity, to = kInfinity;
    if (!in_sphere(o, e, middle, bottom_ + 0.5 * distance_ + top_, from, to)) return;

    // Zone by zone, in the ray's order: the first that is met has the way in, the last the way out. A way in behind
    // `wanted` is enough where one crossing is; a little more, so that rounding cannot make it none.
    const double start = out.from * length, slack = 1e-12 * (std::abs(start) + std::abs(shift) + arc_);
    const double wanted = out.first_only ? start - shift + slack : kInfinity;
    const double low[] = {-kInfinity, high_, glm::max(low_, tip())}, high[] = {low_, kInfinity, high_};  // by face
    Interval found{kInfinity, -kInfinity};
    const auto zone = [&](std::uint32_t face) {
        Interval part;
        if (!slab(o.y, e.y, low[face], high[face], part)) return false;
        double a = glm::max(part.entry, from), b = glm::min(part.exit, to);
        if (!(a <= b)) return false;
        const bool both = found.entry < kInfinity || !(a >= wanted);
        const bool met = face == kBetween ? between(o, e, a, b, both)
                         : face == kBelow ? in_sphere(o, e, glm::dvec3(0.0), bottom_, a, b)
                                          : in_sphere(o, e, {0.0, distance_, 0.0}, top_, a, b);
        if (!met) return false;
        if (a < found.entry) found.entry = a, found.entry_face = face;
        if (b > found.exit) found.exit = b, found.exit_face = face;
        return found.entry >= wanted;
    };
    const bool rising = e.y >= 0.0;
    if (!zone(rising ? kBelow : kAbove) && !zone(kBetween)) zone(rising ? kAbove : kBelow);
    if (!(found.entry <= found.exit)) return;
    if (out.enter((shift + found.entry) / length, found.entry_face))
        out.leave((shift + found.exit) / length, found.exit_face);
}

bool Ovus::contains(const glm::dvec3& p) const
{
    const double rho2 = p.x * p.x + p.z * p.z, over = p.y - distance_;
    if (rho2 + p.y * p.y < bottom_ * bottom_ || rho2 + over * over < top_ * top_) return true;
    if (!(p.y > low_ && p.y < high_)) return false;
    const double rho = std::sqrt(rho2) + offset_, up = p.y - height_;
    return rho * rho + up * up < arc_ * arc_;
}

glm::dvec3 Ovus::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    if (face == kBelow) return p;
    if (face == kAbove) return {p.x, p.y - distance_, p.z};
    const double rho = std::sqrt(p.x * p.x + p.z * p.z), stretch = rho > 0.0 ? 1.0 + offset_ / rho : 0.0;
    return {p.x * stretch, p.y - height_, p.z * stretch};
}

/// In POV-Ray 3.8 v goes by height: evenly between the spheres' middles, by a sine beyond them (spec 7c, 2).
glm::dvec2 Ovus::uv(const glm::dvec3& p, std::uint32_t) const
{
    glm::dvec2 place = sphere_uv(unit_or_x(p - glm::dvec3(0.0, 0.5 * top_, 0.0)));
    if (!heights_of_38_) return place;
    const auto beyond = [](double left, double radius) {
        return 0.25 * numbers::sin(0.5 * std::numbers::pi * std::sqrt(glm::clamp(left / radius, 0.0, 1.0)));
    };
    if (p.y < 0.0) place.y = 1.0 - beyond(bottom_ + p.y, bottom_);
    else if (p.y > distance_) place.y = top_ > 0.0 ? beyond(distance_ + top_ - p.y, top_) : 0.25;
    else place.y = 0.75 - 0.5 * p.y / distance_;
    return place;
}

Aabb Ovus::bounds() const
{
    const double widest = glm::max(arc_ - offset_, glm::max(bottom_, top_));
    return {{-widest, -bottom_, -widest}, {widest, distance_ + top_, widest}};
}

}  // namespace csg
