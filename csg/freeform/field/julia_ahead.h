#pragma once

#include "csg/freeform/field/julia_orbits.h"

namespace csg {

/// Julia::intersect() of rays too few to fill the lanes: several lanes look for each of them, also where it may look
/// after the next look. Most steps are the least one, and the halves of an interval are known beforehand. A ray goes on
/// as far as the places that it comes to have been looked at; what was looked at in vain costs nothing but its lane.
class Julia::Ahead {
public:
    static constexpr std::size_t kPlaces = 2 * Orbits::kWide;
    static constexpr std::size_t kMostRays = kPlaces / 4;  // two lanes a ray gain nothing

    enum class Phase : std::uint8_t { First, Second, Stepping, Halving };
    /// A ray on its way.
    struct March {
        julia::Way way;
        IntersectionList* out;
        double t, step;      ///< step: to the next look, or half of the interval
        double same;         ///< still as at t: begin of the interval
        double behind;       ///< where the step led that found a change
        double step_behind;  ///< what the look there gave
        Phase phase;
        bool inside, inside_behind;  ///< at t; behind the change
    };

    Ahead(const Julia& set, Orbits& orbits) : set_(set), orbits_(orbits) {}

    void add(const March& march) { marches_[count_++] = march; }
    void begin(const Ray& ray, bool moved, IntersectionList& out)
    {
        March& m = marches_[count_];
        m.way = julia::Way(ray, moved, !set_.terms_.as_37, set_.radius_, out);
        m.out = &out;
        m.t = m.way.begin;
        m.phase = Phase::First;
        if (m.way.meets) ++count_;
    }

    void run()
    {
        while (count_ != 0) {
            deal();
            while (count_ > groups_ / 2) look();
            std::size_t kept = 0;
            for (std::size_t r = 0; r < groups_; ++r)
                if (marches_[r].out != nullptr) marches_[kept++] = marches_[r];
        }
    }

private:
    using Mask = Orbits::Mask;
    // Beyond so many places the next is seldom the one that was foreseen.
    static constexpr std::size_t kMostAhead = 8;

    /// Lanes to the rays, to each as many.
    void deal()
    {
        groups_ = std::bit_ceil(count_);
        ahead_ = std::min(kPlaces / groups_, kMostAhead);
        for (std::size_t r = count_; r < groups_; ++r) marches_[r].out = nullptr;
        for (std::size_t r = 0; r < count_; ++r)
            for (std::size_t k = 0; k < ahead_; ++k) orbits_.set_ray(r * ahead_ + k, marches_[r].way.unit);
    }

    static double wanted(const March& m)
    {
        return m.phase == Phase::Stepping ? m.t + m.step : m.phase == Phase::Halving ? m.same + m.step : m.t;
    }

    /// Where the ray looks next, and where it may look then.
    void foresee(const March& m, double* places) const
    {
        if (m.phase != Phase::Halving) {
            places[0] = wanted(m);
            for (std::size_t k = 1; k < ahead_; ++k) places[k] = places[k - 1] + set_.step_;
            return;
        }
        // Children of k: no change before it, then one.
        std::array<double, 2 * kMostAhead + 1> same;
        same[0] = m.same;
        double step = m.step;
        for (std::size_t k = 0, last = 0; k < ahead_; ++k) {
            if (k > last) step *= 0.5, last = 2 * last + 2;
            places[k] = same[k] + step;
            same[2 * k + 1] = same[k];
            same[2 * k + 2] = places[k];
        }
    }

    void look()
    {
        Mask asked = 0, stepping = 0;
        const Mask all = (1u << ahead_) - 1u;
        for (std::size_t r = 0; r < groups_; ++r) {
            if (marches_[r].out == nullptr) continue;
            foresee(marches_[r], places_.data() + r * ahead_);
            asked |= all << r * ahead_;
            if (marches_[r].phase != Phase::Halving) stepping |= all << r * ahead_;
        }
        const Mask in = orbits_.look(places_, asked, stepping);
        for (std::size_t r = 0; r < groups_; ++r) {
            March& m = marches_[r];
            if (m.out == nullptr || go_on(m, r * ahead_, in >> r * ahead_)) continue;
            m.out = nullptr;
            --count_;
        }
    }

    /// As far as its places are known. False: the ray is done.
    bool go_on(March& m, std::size_t first, Mask in) const
    {
        const double *const places = places_.data() + first, *const steps = orbits_.steps().data() + first;
        const bool halving = m.phase == Phase::Halving;
        for (std::size_t k = 0;;) {
            if (!settle(m, (in >> k & 1u) != 0, steps[k])) return false;
            if ((m.phase == Phase::Halving) != halving) return true;
            const double next = wanted(m);
            const std::size_t child = halving ? 2 * k + 1 : k + 1;
            if (child < ahead_ && places[child] == next) k = child;
            else if (halving && child + 1 < ahead_ && places[child + 1] == next) k = child + 1;
            else return true;
        }
    }

    /// What follows from a look.
    bool settle(March& m, bool in, double step) const
    {
        switch (m.phase) {
        case Phase::Stepping:
            if (in == m.inside) {
                m.t += m.step;
                return march_on(m, step);
            }
            m.same = m.t;
            m.behind = m.t + m.step;
            m.inside_behind = in;
            m.step_behind = step;
            m.phase = Phase::Halving;
            return halve(m);
        case Phase::Halving:
            if (in == m.inside) m.same += m.step;
            return halve(m);
        case Phase::First:
            if (in) {  // once more, a little farther on
                m.t += 2.0 * julia::kNearest;
                m.phase = Phase::Second;
                return true;
            }
            [[fallthrough]];
        case Phase::Second:
            m.inside = in;
            return (!in || m.out->enter(m.way.world(m.way.entry), kUndrawnFace)) && march_on(m, step);
        }
        return false;
    }

    bool march_on(March& m, double step) const
    {
        m.step = std::max(step, set_.step_);
        m.phase = Phase::Stepping;
        if (m.way.goes_on(m.t, m.step)) return true;
        if (m.inside) m.out->leave(m.way.world(m.way.exit), kUndrawnFace);
        return false;
    }

    /// To the next half, or, where the interval is as short as it has to be, over the crossing.
    bool halve(March& m) const
    {
        if (m.step > m.way.nearest) {
            m.step *= 0.5;
            return true;
        }
        const bool more = m.inside ? m.out->leave(m.way.world(m.same), 0)
                                   : m.out->enter(m.way.world(m.same, m.step), 0);
        if (!more || m.out->first_only) return false;
        m.t = m.behind;
        m.inside = m.inside_behind;
        return march_on(m, m.step_behind);
    }

    const Julia& set_;
    Orbits& orbits_;
    std::size_t count_ = 0;   ///< rays on their way
    std::size_t groups_ = 0;  ///< of lanes, a ray each; a ray that is through has no `out`
    std::size_t ahead_ = 0;   ///< lanes a ray
    std::array<March, kMostRays> marches_;
    alignas(64) Orbits::Numbers places_{};
};

}  // namespace csg
