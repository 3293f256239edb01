#include "csg/freeform/revolution/ovus.h"

#include "csg/freeform/shared/convex_ends.h"
#include "csg/solids/shared/common.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace csg {
namespace {

constexpr double kLastStep = 1e-12;  // of the arc's radius: the last step of a search

/// The ray's part in a sphere about a place of the axis, cut to [from, to].
template <class P, class V>
lanes::Truth<V> in_sphere(const P& o, const P& e, double height, double radius, V& from, V& to)
{
    const P off{o.x, o.y - V(height), o.z};
    const V shift = lanes::negated(lanes::dot(off, e));
    const P foot = lanes::advanced(off, shift, e);
    const V room = V(radius * radius) - lanes::dot(foot, foot);
    const lanes::Truth<V> met = room > V(0.0);
    const V half = lanes::root_of(lanes::choose(met, room, V(0.0)));
    from = lanes::larger(from, shift - half);
    to = lanes::smaller(to, shift + half);
    return met & (from <= to);
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

/// A ray from near the egg's middle, at unit speed.
template <class P>
struct Ovus::Course {
    lanes::NumberOf<P> length, shift;
    P o, e;
    lanes::TruthOf<P> valid;

    auto world(const lanes::NumberOf<P>& s) const { return (shift + s) / length; }
};

template <class P>
Ovus::Course<P> Ovus::course(const P& origin, const P& way) const
{
    using V = lanes::NumberOf<P>;
    const V length = lanes::root_of(lanes::dot(way, way));
    const P e{way.x / length, way.y / length, way.z / length};
    const V shift = lanes::negated(lanes::dot(P{origin.x, origin.y - V(0.5 * distance_), origin.z}, e));
    const lanes::TruthOf<P> valid = (length > V(0.0)) & (length < V(kInfinity));
    return {length, shift, lanes::advanced(origin, shift, e), e, valid};
}

/// How far a point at parameter s lies outside of the arc, rho + offset - sqrt(arc^2 - (y - height)^2): a convex
/// function of s.
template <class P, class V>
void Ovus::beyond(const P& o, const P& e, const V& s, V& value, V& slope) const
{
    const V x = o.x + s * e.x, z = o.z + s * e.z, up = o.y + s * e.y - V(height_), zero(0.0);
    const V rho = lanes::root_of(x * x + z * z);
    const V width = lanes::root_of(lanes::larger((V(arc_) - up) * (V(arc_) + up), zero));
    slope = lanes::choose(rho > zero, (x * e.x + z * e.z) / rho, zero) +
            lanes::choose(width > zero, up * e.y / width, zero);
    value = rho + V(offset_) - width;
}

/// Where the arc begins on the axis.
double Ovus::tip() const { return height_ - std::sqrt((arc_ - offset_) * (arc_ + offset_)); }

/// What the spheres and the arc hold together; crossings that are drawn though one of the others holds them bound
/// nothing.
void Ovus::intersect_stepped(const Ray& ray, IntersectionList& out) const
{
    const Course<glm::dvec3> course = this->course(ray.origin, ray.direction);
    if (!course.valid) return;
    const glm::dvec3 &o = course.o, &e = course.e;
    std::array<Interval, 3> parts;
    std::size_t count = 0;
    const auto ball = [&](double middle, double radius, auto&& face_at) {
        double from = -kInfinity, to = kInfinity;
        if (in_sphere(o, e, middle, radius, from, to))
            parts[count++] = {from, to, face_at(o.y + from * e.y), face_at(o.y + to * e.y)};
    };
    ball(0.0, bottom_, [&](double y) { return y < low_ ? kBelow : kUndrawnFace; });
    ball(distance_, top_, [&](double y) { return y > high_ ? kAbove : kUndrawnFace; });
    Interval zone;
    double from = -kInfinity, to = kInfinity;
    if (slab(o.y, e.y, glm::max(low_, tip()), high_, zone) &&
        in_sphere(o, e, 0.5 * distance_, bottom_ + 0.5 * distance_ + top_, from, to)) {
        const double begin = glm::max(zone.entry, from), end = glm::min(zone.exit, to), close = kLastStep * arc_;
        double in = begin, leave = end;
        const auto arc = [&](double s, double& value, double& slope) { beyond(o, e, s, value, slope); };
        bool met = begin <= end;
        if (met) move_onto_convex(arc, 1.0, in, leave, close, met);
        if (met) move_onto_convex(arc, -1.0, leave, in, close, met);
        if (met)
            parts[count++] = {in, leave, in > begin ? kBetween : kUndrawnFace, leave < end ? kBetween : kUndrawnFace};
    }
    std::sort(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Interval& a, const Interval& b) { return a.entry < b.entry; });
    const double slack = 1e-12 * arc_;  // two that touch are one
    for (std::size_t i = 0; i < count;) {
        Interval all = parts[i];
        for (++i; i < count && parts[i].entry <= all.exit + slack; ++i) {
            Interval& next = parts[i];
            if (next.exit > all.exit) {
                std::swap(next.exit, all.exit);
                std::swap(next.exit_face, all.exit_face);
            }
            out.touch(course.world(next.entry), next.entry_face);
            out.touch(course.world(next.exit), next.exit_face);
        }
        if (!out.enter(course.world(all.entry), all.entry_face) || !out.leave(course.world(all.exit), all.exit_face))
            return;
    }
}

/// The part of a ray, or of a ray a lane, that lies inside. Where one crossing is enough, the way in behind `start` of
/// the ray's parameter, the way out may lie too far.
template <class P>
lanes::TruthOf<P> Ovus::inside_of(const P& origin, const P& way, lanes::NumberOf<P> start, bool first_only,
                                  EndsOf<lanes::NumberOf<P>>& out) const
{
    using V = lanes::NumberOf<P>;
    using Truth = lanes::TruthOf<P>;
    const Course<P> course = this->course(origin, way);
    const P &o = course.o, &e = course.e;
    V from(-kInfinity), to(kInfinity);
    const Truth possible = course.valid & in_sphere(o, e, 0.5 * distance_, bottom_ + 0.5 * distance_ + top_, from, to);
    if (lanes::mask(possible) == 0) return possible;

    // A little more than where it is wanted, so that rounding cannot make it no crossing.
    start = start * course.length;
    const V slack = V(1e-12) * (lanes::size_of(start) + lanes::size_of(course.shift) + V(arc_)),
            wanted = first_only ? start - course.shift + slack : V(kInfinity);
    out = {V(kInfinity), V(-kInfinity), V(0.0), V(0.0)};
    const auto in_zone = [&](double low, double high, V& a, V& b) {
        EndsOf<V> part;
        const Truth in = possible & slab(o.y, e.y, low, high, part);
        a = lanes::larger(part.entry, from);
        b = lanes::smaller(part.exit, to);
        return in & (a <= b);
    };
    const auto take = [&](const Truth& in, const V& a, const V& b, std::uint32_t face) {
        const Truth sooner = in & (a < out.entry), later = in & (b > out.exit);
        out.entry = lanes::choose(sooner, a, out.entry);
        out.entry_face = lanes::choose(sooner, V(face), out.entry_face);
        out.exit = lanes::choose(later, b, out.exit);
        out.exit_face = lanes::choose(later, V(face), out.exit_face);
    };
    V a, b;
    Truth in = in_zone(-kInfinity, low_, a, b);
    in = in & in_sphere(o, e, 0.0, bottom_, a, b);
    take(in, a, b, kBelow);
    in = in_zone(high_, kInfinity, a, b);
    in = in & in_sphere(o, e, distance_, top_, a, b);
    take(in, a, b, kAbove);

    in = in_zone(glm::max(low_, tip()), high_, a, b);
    const Truth before = out.entry <= a;
    in = in & !(before & (out.entry >= wanted));
    if (lanes::mask(in) != 0) {
        const auto arc = [&](const V& s, V& value, V& slope) { beyond(o, e, s, value, slope); };
        const Truth alone = in & !before & (a >= wanted);  // no more than the way in is asked for
        move_onto_convex(arc, 1.0, a, b, kLastStep * arc_, in);
        Truth both = in & !alone;
        move_onto_convex(arc, -1.0, b, a, kLastStep * arc_, both);
        take((in & alone) | both, a, b, kBetween);
    }
    const Truth met = possible & (out.entry <= out.exit);
    out.entry = course.world(out.entry);
    out.exit = course.world(out.exit);
    return met;
}

void Ovus::intersect(const Ray& ray, IntersectionList& out) const
{
    if (stepped_) return intersect_stepped(ray, out);
    EndsOf<double> ends;
    if (!inside_of(ray.origin, ray.direction, out.from, out.first_only, ends)) return;
    if (out.enter(ends.entry, static_cast<std::uint32_t>(ends.entry_face)))
        out.leave(ends.exit, static_cast<std::uint32_t>(ends.exit_face));
}

void Ovus::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    convex_in_lanes(
        rays, out,
        [&](const lanes::Points& origins, const lanes::Points& ways, std::size_t first, EndsOf<lanes::Double>& ends) {
            alignas(64) std::array<double, LocalRays::kWide> start{};
            for (std::size_t k = 0; k < start.size() && first + k < rays.size(); ++k) start[k] = out[first + k].from;
            return inside_of(origins, ways, lanes::Double::load_aligned(start.data()), out[first].first_only, ends);
        });
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
