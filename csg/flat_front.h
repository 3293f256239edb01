#pragma once

// The nearest crossing by the flat form; inline because it is compiled once per instruction set.
#include "csg/evaluate.h"
#include "csg/flat.h"
#include "csg/traverse.h"

#include <bit>

namespace csg {

/// One ray against a flat form: see docs/flat_csg.md. Undecided where two ends coincide: the general evaluation knows
/// which of them is drawn.
class FlatFront {
public:
    enum class Answer { Found, Nothing, Undecided };

    FlatFront(const FlatForm& form, const SolidStore& store, const Ray& ray, double t_min, double t_max, Scratch& scratch)
        : form_(form), store_(store), ray_(ray), t_min_(t_min), t_max_(t_max), scratch_(scratch)
    {
        const glm::dvec3 o = glm::abs(ray.origin), d = glm::abs(ray.direction);
        reach_ = glm::max(o.x, glm::max(o.y, o.z)) / glm::max(d.x, glm::max(d.y, d.z));
    }

    Answer nearest(Crossing& out)
    {
        if (form_.terms.size() == 1) return nearest_of(form_.terms[0], out);
        Answer answer = Answer::Nothing;
        each_term([&](const FlatTerm& term) {
            Crossing found;
            const Answer one = nearest_of(term, found);
            if (one == Answer::Nothing) return true;
            if (one == Answer::Undecided || (answer == Answer::Found && close(found.t, out.t))) {
                answer = Answer::Undecided;
                return false;
            }
            answer = Answer::Found;
            out = found;
            t_max_ = found.t + slack(found.t);  // one that coincides must be noticed
            return true;
        });
        return answer;
    }

    /// All visible crossings in range, each once, in any order: emit(Crossing). Some may have been emitted already when
    /// the answer is Undecided.
    template <class Emit>
    Answer crossings(Emit&& emit)
    {
        Answer answer = Answer::Nothing;
        each_term([&](const FlatTerm& term) {
            if (crossings_of(term, emit) == Answer::Undecided) answer = Answer::Undecided;
            return answer != Answer::Undecided;
        });
        return answer;
    }

private:
    static constexpr std::uint32_t kNoCut = 0xffffffffu;

    double slack(double t) const { return kCoincidence * (std::abs(t) + reach_); }
    bool close(double a, double b) const
    {
        const double gap = std::abs(a - b);
        return gap <= slack(a) && gap < kInfinity;
    }

    bool within(double t) const { return t <= t_max_ && t < kInfinity; }

    /// Calls f for the terms whose box the ray meets between t_min and t_max as they are then, until f returns false.
    template <class F>
    void each_term(F&& f)
    {
        if (form_.terms.size() == 1) {
            f(form_.terms[0]);
            return;
        }
        const RaySlabs slabs(ray_);
        const float begin = RaySlabs::rounded_down(t_min_);
        for (std::size_t block = 0; block < form_.term_boxes.size(); ++block) {
            alignas(32) float near[8];
            std::uint32_t mask = slabs.meet(form_.term_boxes[block].bounds, begin, RaySlabs::rounded_up(t_max_), near);
            for (; mask != 0; mask &= mask - 1) {
                const int k = std::countr_zero(mask);
                if (static_cast<double>(near[k]) > t_max_) continue;
                if (!f(form_.terms[8 * block + static_cast<std::size_t>(k)])) return;
            }
        }
    }

    /// A convex solid's interval; false where the ray misses it.
    bool interval(const FlatLeaf& leaf, Interval& out) const
    {
        return with_solid(store_, leaf.solid, [&](const auto& solid) {
            if constexpr (requires { solid.interval(ray_, out); })
                return solid.interval(ray_, out);
            else
                return false;  // never convex
        });
    }

    static Crossing end(const FlatLeaf& leaf, double t, std::uint32_t face)
    {
        return {.t = t, .part = leaf.solid, .face = face, .inverted = leaf.turned};
    }

    /// What the convex leaves leave of the line: [in_, out_].
    Answer meet_leaves(const FlatTerm& term)
    {
        in_ = {.t = -kInfinity};
        out_ = {.t = kInfinity};
        const std::uint32_t last = term.convex ? term.last : term.last - 1;
        for (std::uint32_t k = term.first; k < last; ++k) {
            const FlatLeaf& leaf = form_.leaves[k];
            Interval own;
            if (!interval(leaf, own) || own.entry > t_max_ || own.exit < t_min_) return Answer::Nothing;
            if (close(own.entry, in_.t) || close(own.exit, out_.t)) return Answer::Undecided;
            if (own.entry > in_.t) in_ = end(leaf, own.entry, own.entry_face);
            if (own.exit < out_.t) out_ = end(leaf, own.exit, own.exit_face);
            if (close(in_.t, out_.t)) return Answer::Undecided;
            if (in_.t > out_.t) return Answer::Nothing;
        }
        return Answer::Found;
    }

    /// Calls f(in, out) for the pieces of the line in all leaves that meet the range, nearest first, until f answers
    /// something else than Nothing.
    template <class F>
    Answer each_piece(const FlatTerm& term, F&& f)
    {
        const Answer met = meet_leaves(term);
        if (met != Answer::Found) return met;
        if (term.convex) {
            const Answer cut = collect_cuts(term, in_.t, out_.t);
            return cut == Answer::Found ? f(in_, out_) : cut;
        }
        const FlatLeaf& leaf = form_.leaves[term.last - 1];
        Span memory[kFlatSpans + 1];
        SpanList spans(memory, kFlatSpans + 1);
        with_solid(store_, leaf.solid, [&](const auto& solid) { intersect(solid, ray_, spans); });
        std::uint32_t count = 0;
        for (const Span& span : spans) {
            const double entry = span.in.t, exit = span.out.t;
            if (close(entry, in_.t) || close(exit, out_.t) || close(entry, out_.t) || close(exit, in_.t)) return Answer::Undecided;
            Span piece{in_, out_};
            if (entry > in_.t) piece.in = end(leaf, entry, span.in.face);
            if (exit < out_.t) piece.out = end(leaf, exit, span.out.face);
            if (piece.in.t > piece.out.t || piece.in.t > t_max_ || piece.out.t < t_min_) continue;
            memory[count++] = piece;
        }
        if (count == 0) return Answer::Nothing;
        const Answer cut = collect_cuts(term, memory[0].in.t, memory[count - 1].out.t);
        if (cut != Answer::Found) return cut;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Answer answer = f(memory[i].in, memory[i].out);
            if (answer != Answer::Nothing) return answer;
        }
        return Answer::Nothing;
    }

    /// The cuts that meet the ray between in and out, as far as the range reaches.
    Answer collect_cuts(const FlatTerm& term, double in, double out)
    {
        count_ = 0;
        if (term.cut_first == term.cut_last) return Answer::Found;
        scratch_.prepare(form_.span_memory);
        // Margins: an end that coincides with the beginning or the end of the piece must be seen.
        low_ = glm::max(in - slack(in), t_min_);
        high_ = glm::min(out + slack(out), t_max_);
        Answer answer = Answer::Found;
        const auto take = [&](std::uint32_t k) {
            if (!add_cut(form_.cuts[k], in, out)) answer = Answer::Undecided;
            return answer == Answer::Found;
        };
        if (term.cut_last - term.cut_first <= 2) {
            for (std::uint32_t k = term.cut_first; k < term.cut_last; ++k)
                if (!take(k)) break;
        } else if (term.tree != FlatTerm::kNoTree) {
            traverse(form_.trees[term.tree], ray_, low_, high_, 0xffu,
                     [&](ChildWord word) { return take(word.index()) ? high_ : -1.0; });
        } else {
            const RaySlabs slabs(ray_);
            const float begin = RaySlabs::rounded_down(low_), limit = RaySlabs::rounded_up(high_);
            for (std::uint32_t first = term.cut_first; first < term.cut_last; first += 8) {
                alignas(32) float near[8];
                std::uint32_t mask = slabs.meet(form_.cut_boxes[first / 8].bounds, begin, limit, near);
                for (; mask != 0; mask &= mask - 1)
                    if (!take(first + static_cast<std::uint32_t>(std::countr_zero(mask)))) return answer;
            }
        }
        return answer;
    }

    /// False: an end coincides with the end of the piece.
    bool add_cut(const FlatCut& cut, double in, double out)
    {
        const FlatLeaf& first = form_.leaves[cut.first];
        const auto keep = [&](const Crossing& from, const Crossing& until) {
            if (until.t < low_ || from.t > high_) return true;
            if (close(from.t, out) || close(until.t, in)) return false;
            scratch_.spans_[count_++] = {from, until};
            return true;
        };
        if (!first.convex) {
            Span memory[kFlatSpans + 1];
            SpanList spans(memory, kFlatSpans + 1);
            with_solid(store_, first.solid, [&](const auto& solid) { intersect(solid, ray_, spans); });
            for (const Span& span : spans)
                if (!keep(end(first, span.in.t, span.in.face), end(first, span.out.t, span.out.face))) return false;
            return true;
        }
        Interval own;
        if (!interval(first, own)) return true;
        Crossing from = end(first, own.entry, own.entry_face), until = end(first, own.exit, own.exit_face);
        for (std::uint32_t k = cut.first + 1; k < cut.first + cut.count; ++k) {
            const FlatLeaf& leaf = form_.leaves[k];
            own = Interval{};
            if (!interval(leaf, own)) return true;
            if (close(own.entry, from.t) || close(own.exit, until.t)) return false;
            if (own.entry > from.t) from = end(leaf, own.entry, own.entry_face);
            if (own.exit < until.t) until = end(leaf, own.exit, own.exit_face);
            if (close(from.t, until.t)) return false;
            if (from.t > until.t) return true;
        }
        return keep(from, until);
    }

    /// Moves the front out of every cut that covers it. `own` is the cut that it came from.
    Answer leave_cuts(Crossing& front, std::uint32_t own) const
    {
        const Span* cuts = scratch_.spans_.get();
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (i == own) continue;
            const double entry = cuts[i].in.t, exit = cuts[i].out.t;
            if (entry < front.t && exit > front.t) {
                if (close(entry, front.t) || close(exit, front.t)) return Answer::Undecided;
                front = cuts[i].out;
                own = i;
                i = static_cast<std::uint32_t>(-1);  // the rest are looked at again after a move
            } else if (close(entry, front.t) || close(exit, front.t)) {
                return Answer::Undecided;
            }
        }
        return Answer::Found;
    }

    /// Where the solid that the ray is in ends: the first cut that begins at `from` or after, or the piece's end.
    Answer find_end(double from, const Crossing& out, Crossing& found, std::uint32_t& cut) const
    {
        const Span* cuts = scratch_.spans_.get();
        found = out;
        cut = kNoCut;
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (cuts[i].in.t < from) continue;
            if (close(cuts[i].in.t, found.t)) return Answer::Undecided;
            if (cuts[i].in.t < found.t) found = cuts[i].in, cut = i;
        }
        return Answer::Found;
    }

    /// The first crossing of the piece at or after t_min. `enters`: the ray is in the solid behind it.
    Answer first_crossing(const Crossing& in, const Crossing& out, Crossing& found, bool& enters, std::uint32_t& cut) const
    {
        const Span* cuts = scratch_.spans_.get();
        cut = kNoCut;
        if (in.t >= t_min_) {
            found = in;
        } else {
            for (std::uint32_t i = 0; i < count_ && cut == kNoCut; ++i)
                if (cuts[i].in.t < t_min_ && cuts[i].out.t >= t_min_) cut = i;
            if (cut == kNoCut) {
                enters = false;
                return find_end(t_min_, out, found, cut);
            }
            found = cuts[cut].out;
        }
        enters = true;
        return enter(found, cut, out);
    }

    /// From a crossing that is covered, perhaps, to the one where the solid begins.
    Answer enter(Crossing& front, std::uint32_t own, const Crossing& out) const
    {
        if (leave_cuts(front, own) == Answer::Undecided || close(front.t, out.t)) return Answer::Undecided;
        return front.t > out.t ? Answer::Nothing : Answer::Found;
    }

    Answer nearest_of(const FlatTerm& term, Crossing& found)
    {
        return each_piece(term, [&](const Crossing& in, const Crossing& out) {
            bool enters = false;
            std::uint32_t cut = kNoCut;
            const Answer answer = first_crossing(in, out, found, enters, cut);
            if (answer == Answer::Found && !within(found.t)) return Answer::Nothing;
            return answer;
        });
    }

    template <class Emit>
    Answer crossings_of(const FlatTerm& term, Emit&& emit)
    {
        return each_piece(term, [&](const Crossing& in, const Crossing& out) {
            Crossing at;
            bool enters = false;
            std::uint32_t cut = kNoCut;
            Answer answer = first_crossing(in, out, at, enters, cut);
            while (answer == Answer::Found && within(at.t)) {
                emit(at);
                if (enters) {
                    answer = find_end(at.t, out, at, cut);
                    enters = false;
                } else {
                    if (cut == kNoCut) break;  // the piece's own end
                    at = scratch_.spans_[cut].out;
                    answer = enter(at, cut, out);
                    enters = true;
                }
            }
            return answer == Answer::Undecided ? answer : Answer::Nothing;
        });
    }

    const FlatForm& form_;
    const SolidStore& store_;
    const Ray& ray_;
    double t_min_, t_max_, reach_ = 0.0, low_ = 0.0, high_ = 0.0;
    Scratch& scratch_;
    Crossing in_, out_;
    std::uint32_t count_ = 0;
};

}  // namespace csg
