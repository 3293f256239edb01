#pragma once

#include "csg/freeform/shared/bernstein.h"
#include "csg/freeform/field/blob.h"

namespace csg {

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

    Stretch* stretches;
    End* ends;
    std::uint32_t* active;
    std::size_t stretch_count = 0, end_count = 0, active_count = 0;

    void sort_ends()
    {
        end_count = 2 * stretch_count;
        const auto before = [](const End& a, const End& b) { return a.t < b.t; };
        const bool many = end_count > 32;
        for (std::uint32_t i = 0; i < end_count; ++i) {
            const Stretch& of = stretches[i / 2];
            const End end{i % 2 == 0 ? of.enter : of.leave, i / 2, i % 2 != 0};
            std::size_t k = i;
            for (; !many && k > 0 && before(end, ends[k - 1]); --k) ends[k] = ends[k - 1];
            ends[k] = end;
        }
        if (many) std::sort(ends, ends + end_count, before);
    }

    void pass(const End& end)
    {
        if (!end.leaves) {
            active[active_count++] = end.stretch;
            return;
        }
        for (std::size_t i = 0; i < active_count; ++i) {
            if (active[i] != end.stretch) continue;
            active[i] = active[--active_count];
            return;
        }
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

    /// The sum of the active fields less the threshold, on [a, b].
    Quartic sum(double a, double b, double threshold) const
    {
        Quartic all{-threshold, -threshold, -threshold, -threshold, -threshold};
        for (std::size_t k = 0; k < active_count; ++k) {
            const Stretch& s = stretches[active[k]];
            const double first = s.w(a), last = s.w(b), middle = s.between(a, b);
            all[0] += s.strength * first * first;
            all[1] += s.strength * first * middle;
            all[2] += s.strength * (first * last + 2.0 * middle * middle) * (1.0 / 3.0);
            all[3] += s.strength * middle * last;
            all[4] += s.strength * last * last;
        }
        return all;
    }
};

/// Room for the stretches of so many components.
template <std::size_t components>
struct Blob::WalkRoom {
    std::array<Stretch, Walk::kStretches * components> stretches;
    std::array<Walk::End, 2 * Walk::kStretches * components> ends;
    std::array<std::uint32_t, Walk::kStretches * components> active;

    Walk walk() { return {stretches.data(), ends.data(), active.data()}; }
};

}  // namespace csg
