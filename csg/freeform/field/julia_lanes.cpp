#include "csg/freeform/field/julia_ahead.h"

#include <array>
#include <bit>
#include <cmath>

namespace csg {

/// Julia::intersect() of many rays, a ray a lane: every number comes from the same operations in the same order. What a
/// lane does is told by bits of masks, not by branches: rays that march and rays that close in on a crossing follow
/// their orbits together. A lane whose ray is done takes the next one.
class Julia::Lanes {
public:
    Lanes(const Julia& set, std::span<const Ray> rays, bool moved, IntersectionList* out)
        : set_(set), rays_(rays), moved_(moved), out_(out)
    {}

    void run()
    {
        for (std::size_t lane = 0; lane < kRays; ++lane) take_next(lane);
        while (std::popcount(busy()) > static_cast<int>(Ahead::kMostRays)) {
            while (vectors() > 1 && std::popcount(busy()) <= vectors() / 2 * lanes::kDoubles) join(vectors() / 2);
            look();
        }
        if (busy() != 0) finish_few();
    }

private:
    using Double = lanes::Double;
    using Mask = Orbits::Mask;
    using Numbers = Orbits::Numbers;
    static constexpr std::size_t kRays = Orbits::kPlaces;

    static void set_bit(Mask& of, Mask bit, bool on) { of = on ? of | bit : of & ~bit; }

    void leave(std::size_t lane)
    {
        const Mask rest = ~(1u << lane);
        first_ &= rest, second_ &= rest, stepping_ &= rest, halving_ &= rest;
    }

    /// The next ray that comes into the sphere.
    void take_next(std::size_t lane)
    {
        leave(lane);
        while (next_ray_ < rays_.size()) {
            const std::size_t k = next_ray_++;
            const julia::Way way(rays_[k], moved_, !set_.terms_.as_37, set_.radius_, out_[k]);
            if (!way.meets) continue;
            orbits_.set_ray(lane, way.unit);
            t_[lane] = way.begin, end_[lane] = way.end, last_[lane] = way.last, nearest_[lane] = way.nearest;
            marches_[lane] = {way, &out_[k], 0.0, false};
            first_ |= 1u << lane;
            return;
        }
    }

    /// On from t by the step that a look gave.
    void march_on(std::size_t lane, double step)
    {
        leave(lane);
        step_[lane] = std::max(step, set_.step_);
        if (marches_[lane].way.goes_on(t_[lane], step_[lane])) stepping_ |= 1u << lane;
        else finish(lane);
    }

    void finish(std::size_t lane)
    {
        const March& m = marches_[lane];
        if ((inside_ >> lane & 1u) != 0) m.out->leave(m.way.world(m.way.exit), kUndrawnFace);
        take_next(lane);
    }

    /// The interval where the ray goes in or out is as short as it has to be.
    void cross(std::size_t lane)
    {
        const March& m = marches_[lane];
        const bool leaves = (inside_ >> lane & 1u) != 0;
        const bool more = leaves ? m.out->leave(m.way.world(same_[lane]), 0)
                                 : m.out->enter(m.way.world(same_[lane], step_[lane]), 0);
        if (!more || m.out->first_only) return take_next(lane);
        t_[lane] = behind_[lane];
        set_bit(inside_, 1u << lane, m.inside_behind);
        march_on(lane, m.step_behind);
    }

    int vectors() const { return Orbits::vectors(busy()); }

    /// All rays to the first vectors, when no other waits.
    void join(int kept)
    {
        for (Mask left = busy() & ~Orbits::first(kept); left != 0; left &= left - 1) {
            const auto from = static_cast<std::size_t>(std::countr_zero(left)),
                       to = static_cast<std::size_t>(std::countr_zero(~busy()));
            orbits_.move_ray(from, to);
            for (Numbers* of : {&t_, &end_, &last_, &nearest_, &step_, &same_, &behind_}) (*of)[to] = (*of)[from];
            marches_[to] = marches_[from];
            set_bit(inside_, 1u << to, (inside_ >> from & 1u) != 0);
            for (Mask* of : {&first_, &second_, &stepping_, &halving_}) {
                set_bit(*of, 1u << to, (*of >> from & 1u) != 0);
                *of &= ~(1u << from);
            }
        }
    }

    /// One look of every lane, and what follows from it: at t, a step beyond it, or half of an interval beyond `same`.
    void look()
    {
        const int used = vectors();
        for (int v = 0; v < used; ++v) {
            const Double here = Orbits::load(t_, v), step = Orbits::load(step_, v);
            Orbits::store(places_, v,
                          Orbits::pick(Orbits::part(stepping_, v), here + step,
                                       Orbits::pick(Orbits::part(halving_, v), Orbits::load(same_, v) + step, here)));
        }
        settle(orbits_.look(places_, busy(), busy() & ~halving_));
    }

    /// What follows from a look: most rays step on or halve once more, the others one by one.
    void settle(Mask in)
    {
        const Mask changed = stepping_ & (in ^ inside_), going = stepping_ & ~changed;
        Mask special = first_ | second_;
        const int used = vectors();
        for (int v = 0; v < used; ++v) {
            const Mask goes = Orbits::part(going, v), halves = Orbits::part(halving_, v),
                       change = Orbits::part(changed, v),
                       same = halves & ~(Orbits::part(in, v) ^ Orbits::part(inside_, v));
            const Double step = Orbits::load(step_, v), here = Orbits::load(t_, v), low = Orbits::load(same_, v),
                         there = here + step;
            const Double found = Orbits::load(orbits_.steps(), v), least(set_.step_);
            const Double wide = xsimd::select(found < least, least, found);
            Orbits::store(t_, v, Orbits::pick(goes, there, here));
            Orbits::store(same_, v, Orbits::pick(change, here, Orbits::pick(same, low + step, low)));
            Orbits::store(behind_, v, Orbits::pick(change, there, Orbits::load(behind_, v)));
            // An interval with a change just found is treated as one that was halved.
            const Mask more = (halves | change) & lanes::mask(step > Orbits::load(nearest_, v));
            const Mask ends = goes &
                              ~(lanes::mask(wide < Double(kInfinity)) & lanes::mask(there <= Orbits::load(last_, v)) &
                                lanes::mask(there + wide <= Orbits::load(end_, v)));
            Orbits::store(step_, v, Orbits::pick(goes, wide, Orbits::pick(more, step * Double(0.5), step)));
            special |= Orbits::whole(ends | ((halves | change) & ~more), v);
        }
        for (Mask left = changed; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            marches_[lane].inside_behind = (in >> lane & 1u) != 0;
            marches_[lane].step_behind = orbits_.steps()[lane];
        }
        stepping_ &= ~changed;
        halving_ |= changed;
        for (; special != 0; special &= special - 1)
            settle_one(static_cast<std::size_t>(std::countr_zero(special)), in);
    }

    void settle_one(std::size_t lane, Mask looked)
    {
        const Mask bit = 1u << lane;
        const bool in = (looked & bit) != 0;
        if ((halving_ & bit) != 0) return cross(lane);
        if ((stepping_ & bit) != 0) return finish(lane);
        set_bit(inside_, bit, in);
        const March& m = marches_[lane];
        if ((first_ & bit) != 0 && in) {  // once more, a little farther on
            t_[lane] += 2.0 * julia::kNearest;
            first_ &= ~bit, second_ |= bit;
            return;
        }
        if (in && !m.out->enter(m.way.world(m.way.entry), kUndrawnFace)) return take_next(lane);
        march_on(lane, orbits_.steps()[lane]);
    }

    /// Those that are on their way when no other waits.
    void finish_few()
    {
        Ahead few(set_, orbits_);
        for (Mask left = busy(); left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            const March& m = marches_[lane];
            const Mask bit = left & (0u - left);
            const Ahead::Phase phase = (first_ & bit) != 0     ? Ahead::Phase::First
                                       : (second_ & bit) != 0  ? Ahead::Phase::Second
                                       : (halving_ & bit) != 0 ? Ahead::Phase::Halving
                                                               : Ahead::Phase::Stepping;
            few.add({m.way, m.out, t_[lane], step_[lane], same_[lane], behind_[lane], m.step_behind, phase,
                     (inside_ & bit) != 0, m.inside_behind});
        }
        few.run();
    }

    Mask busy() const { return first_ | second_ | stepping_ | halving_; }

    /// What a ray seldom needs.
    struct March {
        julia::Way way;
        IntersectionList* out;
        double step_behind;  ///< what the look behind a crossing gave
        bool inside_behind;
    };

    const Julia& set_;
    Orbits orbits_{set_};
    std::span<const Ray> rays_;
    bool moved_;
    IntersectionList* out_;
    std::size_t next_ray_ = 0;
    Mask first_ = 0, second_ = 0, stepping_ = 0, halving_ = 0;  ///< what a lane looks for; none: it has no ray
    Mask inside_ = 0;                                           ///< at t
    // A lane without a ray looks all the same.
    alignas(64) Numbers places_, t_{}, end_{}, last_{}, nearest_{};
    alignas(64) Numbers step_{};    ///< to the next look, or half of the interval
    alignas(64) Numbers same_{};    ///< still as at t: begin of the interval
    alignas(64) Numbers behind_{};  ///< where the step led that found a change
    std::array<March, kRays> marches_;
};

void Julia::intersect_many(std::span<const Ray> rays, IntersectionList* out, bool moved) const
{
    if (rays.size() > Ahead::kMostRays) return Lanes(*this, rays, moved, out).run();
    Orbits orbits(*this);
    Ahead few(*this, orbits);
    for (std::size_t k = 0; k < rays.size(); ++k) few.begin(rays[k], moved, out[k]);
    few.run();
}

}  // namespace csg
