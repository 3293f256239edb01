#pragma once

// The crossings of a boolean form; inline, since each kernel has its own.
#include "csg/tree/evaluate.h"
#include "csg/tree/product_intersector.h"

#include <array>

namespace csg {

/// One ray through a tree: the ends of all leaves in order, and at each which leaves hold the point behind it. Of two
/// ends in one place each is seen or not as SpanList::contains() has it of a leaf: by whether the other belongs to its
/// solid. More ends in one place that matter to one another are left to the general evaluation.
class BooleanWalk {
public:
    BooleanWalk(const Program& program, const SolidStore& store, const Ray& ray, double t_min, double t_max,
                Scratch& scratch)
        : program_(program), form_(program.boolean), store_(store), ray_(ray), inverse_(1.0 / ray.direction),
          t_min_(t_min), t_max_(t_max), scratch_(scratch)
    {
        scratch.prepare(program);
        reach_ = origin_reach(ray);
    }

    ProductAnswer nearest(Crossing& out)
    {
        ProductAnswer answer = ProductAnswer::Nothing;
        const bool decided = walk(true, [&](const Crossing& c) {
            out = c;
            answer = ProductAnswer::Found;
            return false;
        });
        return decided ? answer : ProductAnswer::Undecided;
    }

    /// f(Crossing) for every crossing in range, nearest first. False: undecided, after some of them perhaps.
    template <class F>
    bool crossings(F&& f)
    {
        return walk(false, [&](const Crossing& c) {
            f(c);
            return true;
        });
    }

    /// What a leaf's solid holds of the ray, in scratch: valid until its next use.
    SpanList spans_of(const BooleanLeaf& leaf) const
    {
        SpanList spans(scratch_.spans_.get(), program_.nodes[leaf.node].max_spans);
        with_solid(store_, leaf.solid, [&](const auto& solid) {
            if constexpr (std::is_same_v<std::decay_t<decltype(solid)>, Freeform>) {
                if (!scratch_.fetched.spans(&solid, t_min_, t_max_, spans)) solid.spans(ray_, t_min_, t_max_, spans);
            } else if constexpr (!std::is_same_v<std::decay_t<decltype(solid)>, Mesh>) {
                intersect(solid, ray_, spans);
            }
        });
        return spans;
    }

private:
    struct End {
        double t;
        std::uint32_t face;
        std::uint32_t leaf;
        bool within = false;  ///< its solid holds what is on both sides
    };

    double slack(double t) const { return kCoincidence * (std::abs(t) + reach_); }

    /// Calls f(crossing) in order until it returns false. first_only: it does at the first. False: undecided, for ends
    /// that share a place or because there are too many.
    template <class F>
    bool walk(bool first_only, F&& f)
    {
        if (!find_ends()) return !full_;
        if (full_) return false;
        std::uint32_t i = 0;
        while (i < count_ && ends_[i].t < t_min_) ++i;
        for (; i < count_ && ends_[i].t <= t_max_; ++i) {
            state_ ^= std::uint64_t{ends_[i].within ? 0u : 1u} << ends_[i].leaf;
            bool met = false;
            if (!decide(i, met)) return false;
            if (!met) continue;
            std::uint32_t drawn = i;
            for (std::uint32_t k = i + 1; k < count_ && ends_[k].t == ends_[i].t; ++k) {
                // In exactly one place: the one that is drawn last.
                if (first_only && !decide(k, met)) return false;
                if (first_only && met && form_.leaves[ends_[k].leaf].rank >= form_.leaves[ends_[drawn].leaf].rank)
                    drawn = k;
            }
            const End& end = ends_[drawn];
            const BooleanLeaf& leaf = form_.leaves[end.leaf];
            if (!f({.t = end.t,
                    .part = leaf.solid,
                    .face = end.face,
                    .inverted = leaf.normal_flipped,
                    .closed = leaf.closed}))
                return true;
        }
        return true;
    }

    static bool same_place(double t, double other, double room) { return t >= other - room && t <= other + room; }

    /// Whether an end is seen. False: undecided.
    bool decide(std::uint32_t i, bool& met) const
    {
        const End& end = ends_[i];
        const BooleanLeaf& leaf = form_.leaves[end.leaf];
        met = false;
        if (!leaf.drawn || end.face == kUndrawnFace) return true;
        const double room = slack(end.t);
        const std::uint64_t matters = leaf.matters();
        std::uint64_t state = state_, beside = 0;
        const auto look = [&](std::uint32_t k) {
            const std::uint64_t bit = std::uint64_t{1} << ends_[k].leaf;
            if ((matters & bit) == 0) return true;
            if ((beside & bit) != 0) return false;
            if ((leaf.below & bit) != 0 && (leaf.below & beside) != 0) return false;
            beside |= bit;
            state = holds_end(store_, ray_, crossing(k), crossing(i)) ? state | bit : state & ~bit;
            return true;
        };
        for (std::uint32_t k = i; k-- > 0 && same_place(end.t, ends_[k].t, room);)
            if (!look(k)) return false;
        for (std::uint32_t k = i + 1; k < count_ && same_place(end.t, ends_[k].t, room); ++k)
            if (!look(k)) return false;
        met = seen(leaf, state);
        return true;
    }

    Crossing crossing(std::uint32_t k) const
    {
        const End& end = ends_[k];
        const BooleanLeaf& leaf = form_.leaves[end.leaf];
        return {.t = end.t, .part = leaf.solid, .face = end.face, .closed = leaf.closed};
    }

    bool seen(const BooleanLeaf& leaf, std::uint64_t state) const
    {
        if ((leaf.inside & ~state) != 0 || (leaf.outside & state) != 0) return false;
        for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k)
            if (holds(form_.conditions[k].node, state) != form_.conditions[k].inside) return false;
        return true;
    }

    /// Whether the point at hand is inside of the subtree at node i.
    bool holds(std::uint32_t i, std::uint64_t state) const
    {
        const Node& node = program_.nodes[i];
        if (node.op == Op::Leaf) return (state >> form_.first_leaf[i] & 1) != 0;
        const bool all = node.op == Op::Intersection || node.op == Op::Clip;
        for (std::uint32_t k = i + 1; k < node.end; k = program_.nodes[k].end)
            if (holds(k, state) != all) return !all;
        return all;
    }

    /// Ends of all leaves in order, and the leaves that hold the ray before the first of them in range. False: nothing
    /// is met.
    bool find_ends()
    {
        count_ = 0;
        state_ = 0;
        if (!add_node(0)) return false;
        for (std::uint32_t i = 1; i < count_; ++i) {
            const End end = ends_[i];
            std::uint32_t at = i;
            for (; at > 0 && ends_[at - 1].t > end.t; --at) ends_[at] = ends_[at - 1];
            ends_[at] = end;
        }
        return true;
    }

    /// Adds the ends of a subtree. False: it holds nothing of the range and draws nothing there; none is left then.
    bool add_node(std::uint32_t i)
    {
        const Node& node = program_.nodes[i];
        if (!meets_box(node, ray_, inverse_, t_min_, t_max_)) return set_all(i, node.inside_beyond);
        if (node.op == Op::Leaf) return add_leaf(form_.first_leaf[i]);
        const bool both = node.op == Op::Intersection || node.op == Op::Clip;
        const std::uint32_t mark = count_;
        bool some = both;
        for (std::uint32_t k = i + 1; k < node.end; k = program_.nodes[k].end) {
            const bool met = add_node(k);
            if (both && !met) {
                count_ = mark;
                return set_all(i, false);
            }
            some = some || met;
        }
        return some;
    }

    /// All leaves of a subtree hold the range, or none does: so does the subtree.
    bool set_all(std::uint32_t i, bool inside)
    {
        const std::uint32_t first = form_.first_leaf[i], last = form_.first_leaf[program_.nodes[i].end];
        const std::uint64_t below = last < BooleanForm::kMostLeaves ? (std::uint64_t{1} << last) - 1
                                                                    : ~std::uint64_t{0};
        const std::uint64_t bits = below & ~((std::uint64_t{1} << first) - 1);
        state_ = inside ? state_ | bits : state_ & ~bits;
        return inside;
    }

    bool add_leaf(std::uint32_t which)
    {
        const BooleanLeaf& leaf = form_.leaves[which];
        const SpanList spans = spans_of(leaf);
        bool inside = false, reached = false;
        for (const Span& span : spans) {
            if (span.out.t < t_min_ - slack(t_min_) || span.in.t > t_max_ + slack(t_max_)) continue;
            reached = true;
            inside = inside || (span.in.t < t_min_ && span.out.t >= t_min_);
            add_end({span.in.t, span.in.face, which});
            add_end({span.out.t, span.out.face, which});
        }
        if (kind_of(leaf.solid) == SolidKind::Torus && reached) {
            double t[2];
            const int n = store_.all<Torus>()[index_of(leaf.solid)].inner_sheet(ray_, t);
            for (int k = 0; k < n; ++k) add_end({t[k], 0, which, true});
        }
        if (inside != leaf.inverted) state_ |= std::uint64_t{1} << which;
        return reached || leaf.inverted;
    }

    void add_end(const End& end)
    {
        if (!(end.t > -kInfinity && end.t < kInfinity)) return;
        if (count_ == ends_.size()) full_ = true;
        else ends_[count_++] = end;
    }

    const Program& program_;
    const BooleanForm& form_;
    const SolidStore& store_;
    const Ray& ray_;
    const glm::dvec3 inverse_;
    double t_min_, t_max_;
    double reach_ = 0.0;
    Scratch& scratch_;
    std::uint64_t state_ = 0;
    std::uint32_t count_ = 0;
    bool full_ = false;  ///< there are more ends than places for them
    std::array<End, 2 * BooleanForm::kMostSpans> ends_;
};

}  // namespace csg
