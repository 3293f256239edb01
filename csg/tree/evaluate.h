#pragma once

// Continues program.h: evaluation along one ray, inline, since each kernel has its own.
#include "csg/tree/face_held.h"
#include "csg/tree/tree_ends.h"

#include <algorithm>

namespace csg {

/// One query: a ray, the range in which crossings matter, and the scratch it works in.
///
/// The ends of all leaves that the ray comes near are gone through in order. An operator knows how many of its operands
/// decide it by themselves, so what an end changes is found by going up as far as anything changes, and whether it is
/// seen is asked of its ancestors alone. Where an intersection holds nothing, for one operand holds nothing there, no
/// other operand is asked, nor any of a merge where one of them holds all. Operands of unions and merges at the top
/// wait until the ray comes to their boxes. See docs/flat_csg.md.
class Evaluation : TreeEnds {
public:
    Evaluation(const Program& program, const SolidStore& store, const Ray& ray, double t_min, double t_max,
               Scratch& scratch)
        : TreeEnds(program, store, ray, t_min, t_max, scratch)
    {}

    /// The nearest visible crossing of the whole program; t is infinite when there is none. Among equal ones the last
    /// generated, as in POV-Ray (spec 5a, 2.1 and 2.2).
    Crossing nearest()
    {
        Crossing best{.t = kInfinity};
        sweep([&](std::size_t i) {
            if (!seen(i)) return true;
            std::size_t drawn = i;
            for (std::size_t k = i + 1; fill(k) && end(k).t == end(i).t; ++k)
                if (seen(k) && node_of(end(k)).rank >= node_of(end(drawn)).rank) drawn = k;
            best = crossing(end(drawn));
            return false;
        });
        return best;
    }

    /// All visible crossings within range, nearest first, equal ones in POV-Ray's order of generation: in scratch,
    /// valid until its next use.
    std::pair<const Crossing*, const Crossing*> crossings()
    {
        std::vector<std::uint32_t>& order = scratch_.seen_;
        sweep([&](std::size_t i) {
            if (!seen(i)) return true;
            std::size_t at = order.size();
            order.push_back(static_cast<std::uint32_t>(i));
            for (;
                 at > 0 && end(order[at - 1]).t == end(i).t && node_of(end(order[at - 1])).rank > node_of(end(i)).rank;
                 --at)
                std::swap(order[at - 1], order[at]);
            return true;
        });
        for (const std::uint32_t i : order) scratch_.add(crossing(end(i)));
        return scratch_.crossings();
    }

    /// The spans of the inside that meet the range; correct within the range only. In scratch, as the crossings.
    SpanList inside()
    {
        std::vector<Span>& out = scratch_.inside_;
        begin();
        bool held = holds(root_);
        if (held) out.push_back(Span::everything());
        for (std::size_t i = 0; fill(i); ++i) {
            if (!end(i).is_touch()) turn(end(i).node(), root_);
            if (fill(i + 1) && same_side(i, i + 1)) continue;
            if (holds(root_) == held) continue;
            held = !held;
            if (held) out.push_back(Span::from(crossing(end(i))));
            else out.back().out = crossing(end(i));
        }
        SpanList spans(out.data(), static_cast<std::uint32_t>(out.size()));
        for (const Span& span : out) spans.push(span);
        return spans;
    }

private:
    friend class TreeEnds;

    /// For a part of a tree, while the whole waits.
    Evaluation(const TreeEnds& whole, std::size_t ends, std::size_t waiting, std::uint32_t root)
        : TreeEnds(whole), root_(root), first_(ends), first_waiting_(waiting)
    {
        t_max_ = kInfinity;
        undrawn_ = false;
    }

    /// Where there is no inside, it is drawn all the same.
    bool met()
    {
        begin();
        bool any = holds(root_);
        go_on([&](std::size_t i) {
            any = any || holds(root_) || seen(i);
            return !any;
        });
        return any;
    }

    const End& end(std::size_t i) const { return scratch_.ends_[first_ + i]; }
    const Node& node_of(const End& e) const { return nodes_[e.node()]; }

    Crossing crossing(const End& e) const
    {
        const Node& node = node_of(e);
        return {e.t, node.solid, e.face, node.normal_flipped, node.closed};
    }
    bool same_side(std::size_t i, std::size_t k) const
    {
        return end(i).t == end(k).t && end(i).after() == end(k).after();
    }

    /// Calls f(index of an end) for the ends in range, in order, the tree being as it is behind each, until it returns
    /// false.
    template <class F>
    void sweep(F&& f)
    {
        begin();
        go_on(f);
    }

    void begin()
    {
        add(root_, {t_min_, t_max_}, true);
        std::vector<End>& waiting = scratch_.waiting_;
        heaped_ = waiting.size() - first_waiting_ > kFewToSort;
        if (heaped_) std::make_heap(waiting.begin() + first(), waiting.end(), End::later);
        else std::sort(waiting.begin() + first(), waiting.end(), End::later);
    }

    template <class F>
    void go_on(F&& f)
    {
        for (std::size_t i = 0; fill(i); ++i) {
            const End& e = end(i);
            if (e.t > t_max_) return;
            if (!e.is_touch()) turn(e.node(), root_);
            passed_ = i;
            if (!(e.t < t_min_) && !f(i)) return;
        }
    }

    std::ptrdiff_t first() const { return static_cast<std::ptrdiff_t>(first_waiting_); }

    /// Whether there are so many ends, sorted now.
    bool fill(std::size_t i)
    {
        while (scratch_.ends_.size() - first_ <= i)
            if (!next()) return false;
        return true;
    }
    /// All ends up to a place are sorted.
    void fill_to(double t)
    {
        while (scratch_.waiting_.size() > first_waiting_ && nearest_waiting().t <= t) next();
    }
    const End& nearest_waiting() const
    {
        return heaped_ ? scratch_.waiting_[first_waiting_] : scratch_.waiting_.back();
    }
    bool next()
    {
        std::vector<End>& waiting = scratch_.waiting_;
        if (waiting.size() == first_waiting_) return false;
        if (heaped_) std::pop_heap(waiting.begin() + first(), waiting.end(), End::later);
        const End found = waiting.back();
        waiting.pop_back();
        if (!found.opens()) scratch_.ends_.push_back(found);
        else open(found);
        return true;
    }

    /// The ray has come to the box of an operand.
    void open(const End& at)
    {
        if (at.t > t_max_) return;
        std::vector<End>& waiting = scratch_.waiting_;
        if (!heaped_) std::make_heap(waiting.begin() + first(), waiting.end(), End::later);
        heaped_ = true;
        const std::size_t before = waiting.size();
        add(at.node(), {at.t, t_max_}, true);
        if (holds(at.node())) changed(at.node(), root_);
        for (std::size_t k = before; k < waiting.size(); ++k)
            std::push_heap(waiting.begin() + first(), waiting.begin() + static_cast<std::ptrdiff_t>(k) + 1, End::later);
    }

    static bool same_place(double t, double other, double room) { return t >= other - room && t <= other + room; }

    /// Whether an end is seen, of the one passed last or of others in exactly the same place.
    bool seen(std::size_t i)
    {
        const End e = end(i);
        if (!node_of(e).drawn || e.hidden() || e.face == kUndrawnFace) return false;
        const double near = slack(e.t);
        fill_to(e.t + 2.0 * near);
        std::size_t first = i, last = i + 1;
        while (first > 0 && same_place(e.t, end(first - 1).t, near)) --first;
        while (last < scratch_.ends_.size() - first_ && same_place(e.t, end(last).t, near)) ++last;
        const bool alone = last - first == 1;
        if (!alone) gather(first, last);
        for (std::uint32_t own = e.node(); own != root_;) {
            const std::uint32_t above = nodes_[own].parent;
            const Node& node = nodes_[above];
            if (node.op != Op::Union && node.op != Op::Guard) {
                const std::uint32_t against = count_[above] - (holds(own) != takes_all(node) ? 1u : 0u);
                if (alone ? against != 0 : !seen_beside(i, above, own, against)) return false;
            }
            own = above;
        }
        return true;
    }

    /// Ends in one place by node, so that those of a subtree stand together.
    void gather(std::size_t first, std::size_t last)
    {
        std::vector<std::uint32_t>& place = scratch_.place_;
        place.clear();
        for (std::size_t k = first; k < last; ++k)
            if (!end(k).is_touch()) place.push_back(static_cast<std::uint32_t>(k));
        std::stable_sort(place.begin(), place.end(),
                         [this](std::uint32_t a, std::uint32_t b) { return end(a).node() < end(b).node(); });
    }
    /// The first of them from `at` on that lies in or behind node i.
    std::size_t gathered_from(std::uint32_t i, std::size_t at) const
    {
        while (at < scratch_.place_.size() && end(scratch_.place_[at]).node() < i) ++at;
        return at;
    }

    /// Whether a node lets an end of its operand `own` be seen. `against`: how many of its other operands do not, by
    /// what they hold behind the end passed last.
    bool seen_beside(std::size_t i, std::uint32_t above, std::uint32_t own, std::uint32_t against)
    {
        const bool all = takes_all(nodes_[above]);
        const std::size_t begin = gathered_from(above, 0), stop = gathered_from(nodes_[above].end, begin);
        const auto each = [&](auto&& f) {
            for (std::size_t at = begin; at < stop;) {
                std::uint32_t operand = end(scratch_.place_[at]).node();
                while (nodes_[operand].parent != above) operand = nodes_[operand].parent;
                const std::size_t next = gathered_from(nodes_[operand].end, at);
                if (operand != own && !f(operand, at, next)) return false;
                at = next;
            }
            return true;
        };
        each([&](std::uint32_t operand, std::size_t, std::size_t) {
            against -= holds(operand) != all ? 1u : 0u;
            return true;
        });
        return against == 0 && each([&](std::uint32_t operand, std::size_t from, std::size_t to) {
                   return holds_beside(i, from, to, operand) == all;
               });
    }

    /// Whether a subtree holds the place of an end, those gathered in [from, to) being ends of it: of the pieces of the
    /// ray that it holds, the ends that lie there hold it or not as their solids have it (SpanList::contains).
    bool holds_beside(std::size_t i, std::size_t from, std::size_t to, std::uint32_t subtree)
    {
        const auto held_at = [&](std::size_t k) { return holds_end(store_, ray_, crossing(end(k)), crossing(end(i))); };
        if (to - from == 1) {
            const std::size_t k = scratch_.place_[from];
            const std::uint32_t leaf = end(k).node();
            if ((count_[leaf] != 0) == held_at(k)) return holds(subtree);
            turn(leaf, subtree);
            const bool held = holds(subtree);
            turn(leaf, subtree);
            return held;
        }
        std::vector<std::uint32_t>& steps = scratch_.steps_;
        steps.assign(scratch_.place_.begin() + static_cast<std::ptrdiff_t>(from),
                     scratch_.place_.begin() + static_cast<std::ptrdiff_t>(to));
        std::sort(steps.begin(), steps.end());
        for (const std::uint32_t k : steps)  // as it is before all of them
            if (k <= passed_) turn(end(k).node(), subtree);
        bool held = holds(subtree), begun = held, answer = false;
        for (std::size_t at = 0; at < steps.size();) {
            std::uint32_t entry = steps[at], exit = entry;  // ends on one side of one place are one step
            const std::uint32_t first = entry;
            for (; at < steps.size() && same_side(first, steps[at]); ++at) {
                const std::uint32_t leaf = end(steps[at]).node();
                turn(leaf, subtree);
                (count_[leaf] != 0 ? entry : exit) = steps[at];
            }
            if (holds(subtree) == held) continue;
            held = !held;
            if (held) begun = held_at(entry);
            else answer = answer || (begun && held_at(exit)), begun = false;
        }
        for (const std::uint32_t k : steps)
            if (k > passed_) turn(end(k).node(), subtree);
        return answer || (held && begun);
    }

    static constexpr std::size_t kFewToSort = 24;

    std::uint32_t root_ = 0;
    std::size_t first_ = 0, first_waiting_ = 0;  ///< ours among the scratch's ends
    std::size_t passed_ = 0;                     ///< the end that the sweep has come to
    bool heaped_ = false;                        ///< waiting ends are a heap; else they are sorted, the nearest last
};

inline bool TreeEnds::meets_bound(std::uint32_t bound)
{
    const std::size_t ends = scratch_.ends_.size(), waiting = scratch_.waiting_.size();
    const bool met = Evaluation(*this, ends, waiting, bound).met();
    cut(scratch_.ends_, ends);
    cut(scratch_.waiting_, waiting);
    return met;
}

}  // namespace csg
