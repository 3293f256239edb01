#include "csg/freeform/revolution/lemon.h"

#include "csg/freeform/shared/convex_ends.h"
#include "csg/solids/shared/common.h"
#include "csg/solids/shared/tube.h"
#include "numbers/functions/functions.h"

namespace csg {

double Lemon::least_arc(double base_radius, double cap_radius, double height)
{
    const double middle = 0.5 * (height + (cap_radius - base_radius) * (cap_radius + base_radius) / height);
    return numbers::hypot(base_radius, middle);
}

Lemon::Lemon(const glm::dvec3& base, double base_radius, const glm::dvec3& cap, double cap_radius, double arc,
             bool open)
    : frame_(axis_frame(0.5 * (base + cap), glm::normalize(cap - base), 1.0, 1.0)), height_(glm::distance(base, cap)),
      radius_(base_radius), open_(open)
{
    // The arc's middle lies on the line through that of the chord, across it, on the axis' side.
    const double widening = cap_radius - base_radius, chord = numbers::hypot(widening, height_);
    const double away = std::sqrt(glm::max((arc - 0.5 * chord) * (arc + 0.5 * chord), 0.0)) / chord;
    offset_ = glm::max(away * height_ - 0.5 * (base_radius + cap_radius), 0.0);
    middle_ = 0.5 * height_ + away * widening;
    widest_ = glm::max(base_radius, cap_radius);
    if (middle_ > 0.0 && middle_ < height_) widest_ = glm::max(widest_, arc - offset_);
}

/// Below 0 inside of the arc, a convex function along a ray. Written from where the arc meets the base: nothing large
/// cancels, however large the arc is.
template <class P, class V>
void Lemon::beyond(const P& o, const P& d, const V& t, V& value, V& slope) const
{
    const V x = o.x + t * d.x, y = o.y + t * d.y, z = o.z + t * d.z + V(0.5 * height_);
    const V rho = lanes::root_of(x * x + y * y);
    value = (rho - V(radius_)) * (rho + V(radius_ + 2.0 * offset_)) + z * (z - V(2.0 * middle_));
    const V outwards = x * d.x + y * d.y, along = lanes::choose(rho > V(0.0), outwards / rho, V(0.0));
    slope = V(2.0) * (outwards + V(offset_) * along + (z - V(middle_)) * d.z);
}

/// The part of a ray, or of a ray a lane, that lies inside.
template <class P>
lanes::TruthOf<P> Lemon::inside_of(const P& origin, const P& way, EndsOf<lanes::NumberOf<P>>& out) const
{
    using V = lanes::NumberOf<P>;
    const P from = lanes::into(frame_, origin), turned = lanes::turned(frame_, way);
    const V length = lanes::root_of(lanes::dot(turned, turned)), inverse = V(1.0) / length;
    const P d{turned.x * inverse, turned.y * inverse, turned.z * inverse};
    const V shift = lanes::negated(lanes::dot(from, d));
    const P o = lanes::advanced(from, shift, d);  // nearest to the middle
    const V room = V(widest_ * widest_ + 0.25 * height_ * height_) - lanes::dot(o, o);
    lanes::Truth<V> met = (length > V(0.0)) & (length < V(kInfinity)) & (room > V(0.0));
    if (lanes::mask(met) == 0) return met;
    const V half = lanes::root_of(lanes::choose(met, room, V(0.0))) * V(1.0 + 1e-9);  // a little outside
    met = met & slab(o.z, d.z, -0.5 * height_, 0.5 * height_, out);
    name_ends(open_, out);
    met = met & narrow(out, {lanes::negated(half), half, V(kSide), V(kSide)});
    if (lanes::mask(met) == 0) return met;
    const auto surface = [&](const V& t, V& value, V& slope) { beyond(o, d, t, value, slope); };
    const double close = 1e-13 * (widest_ + height_);
    const auto enters = move_onto_convex(surface, 1.0, out.entry, out.exit, close, met);
    if (lanes::mask(met) == 0) return met;
    const auto leaves = move_onto_convex(surface, -1.0, out.exit, out.entry, close, met);
    out.entry_face = lanes::choose(enters, V(kSide), out.entry_face);
    out.exit_face = lanes::choose(leaves, V(kSide), out.exit_face);
    out.entry = (shift + out.entry) * inverse;
    out.exit = (shift + out.exit) * inverse;
    return met & (out.entry <= out.exit);
}

void Lemon::intersect(const Ray& ray, IntersectionList& out) const
{
    EndsOf<double> ends{};
    if (!inside_of(ray.origin, ray.direction, ends)) return;
    if (out.enter(ends.entry, static_cast<std::uint32_t>(ends.entry_face)))
        out.leave(ends.exit, static_cast<std::uint32_t>(ends.exit_face));
}

void Lemon::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    convex_in_lanes(rays, out,
                    [this](const lanes::Points& origins, const lanes::Points& ways, std::size_t,
                           EndsOf<lanes::Double>& ends) { return inside_of(origins, ways, ends); });
}

bool Lemon::contains(const glm::dvec3& p) const
{
    const glm::dvec3 l = frame_.inverse_point(p);
    if (!(std::abs(l.z) <= 0.5 * height_)) return false;
    double value = 0.0, slope = 0.0;
    beyond(l, glm::dvec3(0.0), 0.0, value, slope);
    return value < 0.0;
}

glm::dvec3 Lemon::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    if (face == kLowEnd || face == kHighEnd) return frame_.normal({0.0, 0.0, face == kLowEnd ? -1.0 : 1.0});
    const glm::dvec3 l = frame_.inverse_point(p);
    const double rho = numbers::hypot(l.x, l.y), stretch = rho > 0.0 ? 1.0 + offset_ / rho : 0.0;
    return frame_.normal({l.x * stretch, l.y * stretch, l.z + 0.5 * height_ - middle_});
}

Aabb Lemon::space() const
{
    const glm::dvec3 half(widest_, widest_, 0.5 * height_);
    return {-half, half};
}

Aabb Lemon::bounds() const { return transformed_box(frame_, space()); }
Aabb Lemon::extent(const Transform& moved) const { return transformed_box(moved * frame_, space()); }

}  // namespace csg
