#pragma once

#include "csg/base/points.h"
#include "csg/freeform/field/blob.h"
#include "csg/freeform/shared/bernstein.h"
#include "csg/freeform/shared/sort_few.h"

#include <algorithm>
#include <cstring>

/// What a ray, or a ray a lane, has in the reach of a blob's components, and what one needs to follow it.

namespace csg {

/// Where rays are nearest to the middle of a sphere around a field, and half of what they have inside.
template <class P>
struct Blob::Chord {
    using V = lanes::NumberOf<P>;

    V ref, half;
    V inside2;                ///< reach squared less the distance squared
    V slope;                  ///< of half the squared distance, at ref: 0 but for rounding
    lanes::Truth<V> meets{};  ///< the sphere, in the range

    /// \param away     from the middle to where the rays start
    /// \param inverse  1 over the square of the directions' lengths
    Chord(const P& away, const P& direction, const V& inverse, const V& from, const V& to, const V& reach2)
        : ref(lanes::negated(lanes::dot(away, direction)) * inverse)
    {
        const P foot = lanes::advanced(away, ref, direction);
        const V zero(0.0);
        inside2 = reach2 - lanes::dot(foot, foot);
        const lanes::Truth<V> in = inside2 > zero;
        half = lanes::root_of(lanes::choose(in, inside2 * inverse, zero));
        meets = in & !((ref + half < from) | (ref - half > to));
        slope = lanes::dot(foot, direction);
    }
    /// Of a field that is the sphere.
    Course<V> course(const Field& field, const V& inverse) const
    {
        const double scale = 1.0 / field.reach2;
        return {ref - half, ref + half, ref, inside2 * scale, -2.0 * scale * slope, -scale / inverse};
    }
};

template <class V>
inline V finite_or(const V& a, const V& other)
{
    return lanes::choose(lanes::size_of(a) < V(kInfinity), a, other);
}

/// What the lines o + t v have between `low` and `high` in the unit sphere. Returns which of them have any in the
/// range. `top`: the vertex of the field.
template <class P, class V>
inline lanes::Truth<V> Blob::in_unit_sphere(const P& o, const P& v, V low, V high, const V& from, const V& to, V& top,
                                            Course<V>& out)
{
    const auto in_range = [&]() -> lanes::Truth<V> { return (low < high) & (!(high < from)) & (!(low > to)); };
    lanes::Truth<V> met = in_range();
    if (lanes::mask(met) == 0) return met;
    const V zero(0.0), a = lanes::dot(v, v);
    top = finite_or(lanes::choose(a > zero, lanes::negated(lanes::dot(o, v)) / a, zero), zero);
    const V ref = lanes::smaller(lanes::larger(top, finite_or(low, top)), finite_or(high, top));
    const P foot = lanes::advanced(o, ref, v);
    const V w0 = 1.0 - lanes::dot(foot, foot), half = lanes::negated(lanes::dot(foot, v));
    // Roots of w0 + 2 half s - a s^2.
    const V discriminant = half * half + a * w0;
    const lanes::Truth<V> crosses = discriminant > zero, ends = crosses & (a > zero);
    met = met & (crosses | ((a == zero) & (w0 > zero)));
    if (lanes::mask(met) == 0) return met;
    const V q = half + lanes::signed_as(lanes::root_of(lanes::choose(crosses, discriminant, zero)), half);
    const V s1 = q / a, s2 = lanes::negated(w0) / q;
    low = lanes::larger(lanes::choose(ends, lanes::larger(low, ref + lanes::smaller(s1, s2)), low), V(-1e300));
    high = lanes::smaller(lanes::choose(ends, lanes::smaller(high, ref + lanes::larger(s1, s2)), high), V(1e300));
    out = {low, high, ref, w0, 2.0 * half, lanes::negated(a)};
    return met & in_range();
}

/// Calls f(o, v, low, high) for the slices where the nearest point of a capsule's axis is its one end, between them,
/// and its other end, in the order of lines u + t d that lie in none of them.
template <class P, class F>
inline void Blob::each_slice(const Field& field, const P& u, const P& d, F&& f)
{
    using V = lanes::NumberOf<P>;
    const V zero(0.0), least(-kInfinity), most(kInfinity), upper_z = u.z - field.length;
    const V at_low = lanes::negated(u.z) / d.z, at_high = lanes::negated(upper_z) / d.z;
    const lanes::Truth<V> up = d.z > zero;
    f(P{u.x, u.y, lanes::choose(up, u.z, upper_z)}, d, least, lanes::choose(up, at_low, at_high));
    f(P{u.x, u.y, zero}, P{d.x, d.y, zero}, lanes::smaller(at_low, at_high), lanes::larger(at_low, at_high));
    f(P{u.x, u.y, lanes::choose(up, upper_z, u.z)}, d, lanes::choose(up, at_high, at_low), most);
}

/// Bernstein ordinates.
using Quartic = std::array<double, 5>;

/// What one ray needs, in room that is there already: a component has three stretches at most.
struct Blob::Walk {
    struct End {
        double t;
        std::uint32_t stretch;
        bool leaves;
    };
    static constexpr std::size_t kStretches = 3;  ///< of a component
    static constexpr std::size_t kTogether = 4;
    typedef double Together __attribute__((vector_size(sizeof(double) * kTogether)));
    /// What sums ask of so many stretches that are active, side by side: from the k-th on; 0 where there are no more.
    struct Active {
        Together leave, ref, w0, w1, w2, strength;

        Active(const Walk& of, std::size_t k)
        {
            static constexpr Stretch kNone{};
            static_assert(sizeof(Stretch) == 2 * sizeof(Together));
            Together low[kTogether], high[kTogether];
            for (std::size_t i = 0; i < kTogether; ++i) {
                const Stretch& s = k + i < of.active_count ? of.stretches[of.active[k + i]] : kNone;
                const char* const numbers = reinterpret_cast<const char*>(&s);
                std::memcpy(&low[i], numbers, sizeof low[i]);                    // enter, leave, ref, w0
                std::memcpy(&high[i], numbers + sizeof low[i], sizeof high[i]);  // w1, w2, strength, most
            }
            Together unused;
            turn(low, unused, leave, ref, w0);
            turn(high, w1, w2, strength, unused);
        }
        /// Columns from rows.
        static void turn(const Together* of, Together& a, Together& b, Together& c, Together& d)
        {
            const Together ac01 = __builtin_shufflevector(of[0], of[1], 0, 4, 2, 6),
                           bd01 = __builtin_shufflevector(of[0], of[1], 1, 5, 3, 7),
                           ac23 = __builtin_shufflevector(of[2], of[3], 0, 4, 2, 6),
                           bd23 = __builtin_shufflevector(of[2], of[3], 1, 5, 3, 7);
            a = __builtin_shufflevector(ac01, ac23, 0, 1, 4, 5);
            b = __builtin_shufflevector(bd01, bd23, 0, 1, 4, 5);
            c = __builtin_shufflevector(ac01, ac23, 2, 3, 6, 7);
            d = __builtin_shufflevector(bd01, bd23, 2, 3, 6, 7);
        }
        // Results go where they are wanted: calls that return four numbers differ from machine to machine.
        void w(double t, Together& out) const
        {
            const Together s = t - ref;
            out = w0 + s * (w1 + s * w2);
        }
        /// The middle Bernstein ordinate between two places.
        void between(double a, double b, Together& out) const
        {
            out = w0 + 0.5 * w1 * ((a - ref) + (b - ref)) + w2 * (a - ref) * (b - ref);
        }
    };

    Stretch* stretches;
    End* ends;
    std::uint32_t* active;
    std::uint32_t* places;  ///< of stretches that are active: where they stand there
    std::size_t stretch_count = 0, end_count = 0, active_count = 0;
    std::size_t sorted = 0;  ///< of the ends; most rays are done before they need them all
    bool only_adds = true;   ///< no field takes away

    /// Those from `from` on, and the last one before it; what began earlier is active, in order,
    /// so that sums are those of a ray that comes from afar.
    void set_ends(double from)
    {
        End* const last = ends + 2 * stretch_count;
        End* began = last;  // in the room that their own ends leave
        for (std::uint32_t i = 0; i < stretch_count; ++i) {
            const Stretch& of = stretches[i];
            places[i] = 0;
            only_adds = only_adds && of.strength > 0.0;
            if (!(of.enter < from)) ends[end_count++] = {of.enter, i, false};
            else *--began = {of.enter, i, false};
            ends[end_count++] = {of.leave, i, true};
        }
        if (began != last) {
            std::reverse(began, last);
            put_in_order(began, last);
            const End latest = last[-1];
            for (; began != last - 1; ++began) begin(began->stretch);
            ends[end_count++] = latest;
        }
        sort_more();
    }

    /// As many again, in order behind those that are.
    void sort_more()
    {
        End* const first = ends + sorted;
        sorted = std::min(end_count, sorted + std::max(sorted, SortFew<End>::kMost));
        if (sorted < end_count) std::nth_element(first, ends + sorted, ends + end_count, earlier);
        put_in_order(first, ends + sorted);
    }

    static bool earlier(const End& a, const End& b) { return a.t < b.t; }
    static void put_in_order(End* first, End* last)
    {
        const auto count = static_cast<std::size_t>(last - first);
        if (count > SortFew<End>::kMost) std::sort(first, last, earlier);
        else SortFew<End>::sort(first, count);
    }

    double last_end() const
    {
        double last = ends[sorted - 1].t;
        for (std::size_t k = sorted; k < end_count; ++k) last = std::max(last, ends[k].t);
        return last;
    }

    void pass(const End& end)
    {
        if (!end.leaves) return begin(end.stretch);
        const std::uint32_t place = places[end.stretch];
        if (place >= active_count || active[place] != end.stretch) return;
        const std::uint32_t last = active[--active_count];
        active[place] = last;
        places[last] = place;
    }
    void begin(std::uint32_t stretch)
    {
        places[stretch] = static_cast<std::uint32_t>(active_count);
        active[active_count++] = stretch;
    }

    /// No sum of fields in the range asked for is above this.
    double most_of_all() const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < stretch_count; ++k) sum += stretches[k].most;
        return sum;
    }

    /// Nor above this where `active` are.
    double most() const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < active_count; ++k) sum += stretches[active[k]].most;
        return sum;
    }

    /// Where fields only add: whether the sum surely is above the threshold between two places. One that reaches over
    /// both is least at one of them.
    bool above(double threshold, double a, double b) const
    {
        constexpr double kEnough = 1e-9;  // more than all that are left may take away by rounding
        Together sum{};
        double known = 0.0;
        for (std::size_t k = 0; k < active_count && known <= threshold + kEnough; k += kTogether) {
            const Active s(*this, k);
            Together first, last;
            s.w(a, first);
            s.w(b, last);
            const Together w = first < last ? first : last;
            sum += s.leave < b ? Together{} : s.strength * (w * w - kRounding);
            known = (sum[0] + sum[1]) + (sum[2] + sum[3]);
        }
        return known > threshold;
    }

    /// The sum of the active fields less the threshold, on [a, b]. Terms are made side by side and added one after the
    /// other, in order.
    Quartic sum(double a, double b, double threshold) const
    {
        Together outer{-threshold, -threshold, -threshold, -threshold};  // all but the middle ordinate
        double inner = -threshold;
        for (std::size_t k = 0; k < active_count; k += kTogether) {
            const Active s(*this, k);
            Together first, last, middle;
            s.w(a, first);
            s.w(b, last);
            s.between(a, b, middle);
            const Together begin = s.strength * first, end = s.strength * last;
            const Together t0 = begin * first, t1 = begin * middle, t3 = s.strength * middle * last, t4 = end * last;
            const Together t2 = s.strength * (first * last + 2.0 * middle * middle) * (1.0 / 3.0);
            const Together ordinates[] = {t0, t1, t3, t4};
            Together of[kTogether];
            Active::turn(ordinates, of[0], of[1], of[2], of[3]);
            for (const Together& one : of) outer += one;
            for (std::size_t i = 0; i < kTogether; ++i) inner += t2[i];
        }
        return {outer[0], outer[1], inner, outer[2], outer[3]};
    }
};

/// Room for the stretches of so many components.
template <std::size_t components>
struct Blob::WalkRoom {
    std::array<Stretch, Walk::kStretches * components> stretches;
    std::array<Walk::End, 2 * Walk::kStretches * components> ends;
    std::array<std::uint32_t, Walk::kStretches * components> active, places;

    Walk walk() { return {stretches.data(), ends.data(), active.data(), places.data()}; }
};

}  // namespace csg
