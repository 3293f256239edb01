#pragma once

// Continues program.h: the ends of a tree's leaves along one ray, inline, since each kernel has its own.
#include "csg/bvh/traverse.h"
#include "csg/tree/leaf_spans.h"

#include <bit>
#include <optional>

namespace csg {

/// A tree at a place of a ray, and the ends at which that changes: those of the leaves that the ray comes near, as far
/// as they can matter. An operator knows how many of its operands decide it by themselves.
class TreeEnds {
protected:
    using End = TreeEnd;

    TreeEnds(const Program& program, const SolidStore& store, const Ray& ray, double t_min, double t_max,
             Scratch& scratch)
        : nodes_(program.nodes.data()), sieves_(program.sieves.data()), store_(store), ray_(ray),
          inverse_(1.0 / ray.direction), t_min_(t_min), t_max_(t_max), scratch_(scratch)
    {
        scratch.prepare(program);
        count_ = scratch.counts_.data();
        reach_ = origin_reach(ray);
        if (!program.sieves.empty()) slabs_.emplace(ray);
    }

    double slack(double t) const { return kCoincidence * (std::abs(t) + reach_); }
    /// Ends that lie outside of a stretch are asked for as far as what coincides with an end inside of it.
    double room(double t) const { return 4.0 * slack(t); }
    Stretch padded(const Stretch& part) const { return {part.from - room(part.from), part.to + room(part.to)}; }

    /// Whether one operand that does not hold something is enough for the node not to; else one that does is enough for
    /// it to.
    static bool takes_all(const Node& node) { return node.op == Op::Intersection || node.op == Op::Clip; }

    static void cut(std::vector<End>& ends, std::size_t size)
    {
        ends.erase(ends.begin() + static_cast<std::ptrdiff_t>(size), ends.end());
    }

    // The tree at the place that the sweep has come to: count_ is of a leaf whether it holds the place, of an operator
    // how many operands decide it.

    bool holds(std::uint32_t i) const { return (count_[i] != 0) != takes_all(nodes_[i]); }

    /// Turns a leaf round, and what that changes up to `last`.
    void turn(std::uint32_t i, std::uint32_t last)
    {
        count_[i] ^= 1u;
        if (i != last) changed(i, last);
    }
    /// An operand holds the place now or does no longer.
    void changed(std::uint32_t i, std::uint32_t last)
    {
        bool held = holds(i);
        do {
            i = nodes_[i].parent;
            const bool all = takes_all(nodes_[i]), decided = count_[i] != 0;
            count_[i] += held != all ? 1u : ~0u;
            if ((count_[i] != 0) == decided) return;
            held = decided == all;
        } while (i != last);
    }

    /// What may be told of a node from the ends of its leaves: where it holds something of the ray or draws, and where
    /// it does not hold all or draws.
    struct Reach {
        Stretch held, open;
    };

    /// Adds the ends of a subtree in a part of the ray and counts what holds before the first of them. `top`: nothing
    /// but unions and merges are above.
    Reach add(std::uint32_t i, const Stretch& part, bool top) { return add(i, part, padded(part), top); }
    /// The same where the part is known with room at its ends. Most operands end here, at their boxes.
    [[gnu::always_inline]] Reach add(std::uint32_t i, const Stretch& part, Stretch in_box, bool top)
    {
        const Node& node = nodes_[i];
        if (node.test_box && !narrow_to_box(node, ray_, inverse_, in_box))
            return add_nothing(i, node.inside_beyond, part);
        return add_met(i, part, in_box, top);
    }

    /// Of a subtree whose box the ray meets: `in_box` there.
    [[gnu::noinline]] Reach add_met(std::uint32_t i, const Stretch& part, Stretch in_box, bool top)
    {
        const Node& node = nodes_[i];
        if (node.op == Op::Leaf) return add_leaf(i, part);
        if (node.op == Op::Guard) return add_guarded(i, part);
        if (!node.bounded) return add_operator(i, part, part, top);
        widen(in_box, reach_);
        in_box.narrow(part);
        return add_operator(i, part, in_box, top);
    }

    /// All of the part is in the subtree, or nothing is.
    Reach add_nothing(std::uint32_t i, bool held, const Stretch& part)
    {
        count_[i] = held != takes_all(nodes_[i]) ? 1u : 0u;
        return held ? Reach{part, {}} : Reach{{}, part};
    }

    Reach add_guarded(std::uint32_t i, const Stretch& part)
    {
        const bool given = undrawn_;
        undrawn_ = undrawn_ || !nodes_[i].drawn || !passes_guard(i);
        const Reach told = add(i + 1, part, false);
        undrawn_ = given;
        count_[i] = holds(i + 1) ? 1u : 0u;
        return told;
    }

    /// Whether the ray meets every bound of a guard, however far, or starts inside of it.
    bool passes_guard(std::uint32_t i)
    {
        for (std::uint32_t k = nodes_[i + 1].end; k < nodes_[i].end; k = nodes_[k].end)
            if (!meets_bound(k)) return false;
        return true;
    }
    bool meets_bound(std::uint32_t bound);  // asks an Evaluation

    /// \param part of the ray in which the node's ends are wanted
    /// \param within what of it lies in the node's box: elsewhere it holds nothing
    Reach add_operator(std::uint32_t i, const Stretch& part, const Stretch& within, bool top)
    {
        const Node& node = nodes_[i];
        const bool all = takes_all(node), narrows = node.op != Op::Union;
        const std::size_t mark = scratch_.waiting_.size();
        Stretch both = within, wide = padded(within), some;
        std::uint32_t deciding = 0;
        const bool wait = top && !all;
        const auto operand = [&](std::uint32_t k) {
            if (wait && waits(k, both)) return true;
            const Reach told = add(k, both, wide, wait);
            deciding += holds(k) != all ? 1u : 0u;
            some.include(all ? told.open : told.held);
            if (!narrows) return true;
            both.narrow(all ? told.held : told.open);
            wide = padded(both);
            return wide.from <= wide.to;  // not so of none, whose room is no number
        };
        if (!each_operand(i, within, operand)) {
            cut(scratch_.waiting_, mark);
            return add_nothing(i, !all, part);
        }
        count_[i] = deciding;
        if (all) return {both, beyond(part, within, some)};
        if (wait) return {part, part};  // nobody asks
        return {some, beyond(part, within, both)};
    }

    /// Where a node is open: in its box there, beyond its box everywhere.
    static Stretch beyond(const Stretch& part, const Stretch& within, Stretch open)
    {
        if (within.from > part.from) open.from = part.from;
        if (within.to < part.to) open.to = part.to;
        return open;
    }

    /// Calls f(operand) for the operands of node i, those that are soon asked before the others, until it returns
    /// false; some that cannot matter for this ray are left out.
    template <class F>
    bool each_operand(std::uint32_t i, const Stretch& part, F&& f)
    {
        const Node& node = nodes_[i];
        if (node.first_sieve == node.last_sieve) {
            if (!node.mixed) {
                for (std::uint32_t k = i + 1; k < node.end; k = nodes_[k].end)
                    if (!f(k)) return false;
                return true;
            }
            for (const bool quick : {true, false})
                for (std::uint32_t k = i + 1; k < node.end; k = nodes_[k].end)
                    if (nodes_[k].quick == quick && !f(k)) return false;
            return true;
        }
        const float begin = rounded_down(part.from - room(part.from)), end = rounded_up(part.to + room(part.to));
        for (std::uint32_t s = node.first_sieve; s < node.last_sieve; ++s) {
            alignas(32) float near[8];
            for (std::uint32_t met = slabs_->intersect(sieves_[s].bounds, begin, end, near); met != 0; met &= met - 1)
                if (!f(sieves_[s].node[std::countr_zero(met)])) return false;
        }
        return true;
    }

    /// Whether an operand is left until the ray comes to its box.
    bool waits(std::uint32_t k, const Stretch& part)
    {
        const Node& node = nodes_[k];
        if (!node.bounded) return false;
        Stretch in_box{part.from, part.to};
        if (!narrow_to_box(node, ray_, inverse_, in_box)) return true;
        widen(in_box, reach_);
        if (!(in_box.from > part.from)) return false;
        scratch_.waiting_.push_back(End::opening(in_box.from, k));
        return true;
    }

    Reach add_leaf(std::uint32_t i, const Stretch& part)
    {
        const Node& node = nodes_[i];
        const double begin = part.from - room(part.from), stop = part.to + room(part.to);
        Stretch inside, outside = part;
        bool some = false, before = false;
        with_solid(store_, node.solid, [&](const auto& solid) {
            each_span_of(solid, ray_, node.inverted, t_min_, t_max_, reach_, {store_, nodes_, i, scratch_.fetched},
                         {scratch_.spans_.data(), node.max_spans},
                         [&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                             if (out < begin || in > stop) return;
                             const bool enters = in >= begin && in > -kInfinity,
                                        leaves = out <= stop && out < kInfinity;
                             if (!some) {
                                 before = !enters;
                                 inside.from = enters ? in : part.from;
                                 if (before) outside.from = leaves ? out : kInfinity;
                             }
                             some = true;
                             inside.to = leaves ? out : part.to;
                             if (!leaves) outside.to = enters ? in : -kInfinity;
                             if (enters && in < kInfinity) add_end(node, i, in, in_face, !node.turned);
                             if (leaves && out > -kInfinity) add_end(node, i, out, out_face, node.turned);
                         });
        });
        count_[i] = before != node.turned ? 1u : 0u;
        if (node.draws_alone && (some || kind_of(node.solid) != SolidKind::Torus)) {
            each_touch_of(store_, node.solid, ray_, t_min_, t_max_, [&](double t, std::uint32_t face) {
                if (!undrawn_ && t > -kInfinity && t < kInfinity) scratch_.waiting_.push_back(End::touch(t, face, i));
            });
            return {part, part};
        }
        return node.turned ? Reach{outside, inside} : Reach{inside, outside};
    }

    void add_end(const Node& node, std::uint32_t i, double t, std::uint32_t face, bool entry)
    {
        const bool hidden = undrawn_ || kind_of(node.solid) == SolidKind::Mesh;  // a mesh draws by itself
        scratch_.waiting_.push_back(End::of(t, face, i, entry != node.closed, hidden));
    }

    const Node* nodes_;
    const OperandSieve* sieves_;
    const SolidStore& store_;
    std::optional<RaySlabs> slabs_;  ///< where there are sieves
    const Ray ray_;
    const glm::dvec3 inverse_;
    double t_min_, t_max_;
    double reach_ = 0.0;  ///< size of the origin, in units of the parameter
    Scratch& scratch_;
    std::uint32_t* count_;  ///< of a leaf whether it holds the place, of an operator how many operands decide it
    bool undrawn_ = false;  ///< what is added now is behind a guard
};

}  // namespace csg
