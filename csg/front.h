#pragma once

// Continues evaluate.h: the nearest crossing of a flat convex program, and the queries callers use.
#include "csg/evaluate.h"

namespace csg {

/// Nearest crossing of an intersection of convex solids and inverted convex solids, without spans: latest entry,
/// earliest exit, then the front moves through the subtrahends that cover it. Where two ends coincide it gives up:
/// the general evaluation knows what is drawn there.
class Front {
public:
    enum class Answer { Found, Nothing, Undecided };

    Front(const Program& program, const SolidStore& store, const Ray& ray, double t_min, double t_max, Scratch& scratch)
        : program_(program), store_(store), ray_(ray), t_min_(t_min), t_max_(t_max), scratch_(scratch)
    {
        const glm::dvec3 o = glm::abs(ray.origin), d = glm::abs(ray.direction);
        reach_ = glm::max(o.x, glm::max(o.y, o.z)) / glm::max(d.x, glm::max(d.y, d.z));
    }

    Answer nearest(Crossing& out)
    {
        const Answer kept = intersect_minuends();
        if (kept != Answer::Found) return kept;
        scratch_.prepare(program_);
        const Answer cut = collect_subtrahends();
        return cut == Answer::Found ? advance(out) : cut;
    }

private:
    bool close(double a, double b) const { return std::abs(a - b) <= kCoincidence * (std::abs(a) + reach_); }

    static bool interval(const SolidStore& store, PartId part, const Ray& ray, Interval& out)
    {
        return with_solid(store, part, [&](const auto& solid) {
            if constexpr (requires { solid.interval(ray, out); })
                return solid.interval(ray, out);
            else
                return false;  // never in a flat convex program
        });
    }

    Answer intersect_minuends()
    {
        in_ = {.t = -kInfinity};
        out_ = {.t = kInfinity};
        for (std::size_t k = first_operand(); k < program_.nodes.size(); ++k) {
            const Node& node = program_.nodes[k];
            if (node.inverted) continue;
            Interval own;
            if (!interval(store_, node.solid, ray_, own)) return Answer::Nothing;
            if (close(own.entry, in_.t) || close(own.exit, out_.t)) return Answer::Undecided;
            if (own.entry > in_.t) in_ = {.t = own.entry, .part = node.solid, .face = own.entry_face};
            if (own.exit < out_.t) out_ = {.t = own.exit, .part = node.solid, .face = own.exit_face};
            if (close(in_.t, out_.t)) return Answer::Undecided;
            if (in_.t > out_.t || in_.t > t_max_ || out_.t < t_min_) return Answer::Nothing;
        }
        return Answer::Found;
    }

    Answer collect_subtrahends()
    {
        count_ = 0;
        for (std::size_t k = first_operand(); k < program_.nodes.size(); ++k) {
            const Node& node = program_.nodes[k];
            if (!node.inverted) continue;
            Interval own;
            if (!interval(store_, node.solid, ray_, own) || own.exit < in_.t || own.entry > out_.t) {
                if (close(own.exit, in_.t) || close(own.entry, out_.t)) return Answer::Undecided;
                continue;
            }
            Span& cut = scratch_.spans_[count_++];
            cut.in = {.t = own.entry, .part = node.solid, .face = own.entry_face, .inverted = true};
            cut.out = {.t = own.exit, .part = node.solid, .face = own.exit_face, .inverted = true};
        }
        return Answer::Found;
    }

    /// Moves `front` out of every subtrahend that covers it; used ones leave the list.
    Answer leave_subtrahends(Crossing& front)
    {
        for (std::uint32_t i = 0; i < count_;) {
            Span* cuts = scratch_.spans_.get();
            const double entry = cuts[i].in.t, exit = cuts[i].out.t;
            if (close(entry, front.t) || close(exit, front.t)) return Answer::Undecided;
            if (entry < front.t && exit > front.t) {
                front = cuts[i].out;
                cuts[i] = cuts[--count_];
                i = 0;  // the rest are looked at again after a move
            } else if (exit < front.t) {
                cuts[i] = cuts[--count_];
            } else {
                ++i;
            }
        }
        return Answer::Found;
    }

    Answer advance(Crossing& found)
    {
        Crossing front = in_;
        for (;;) {
            if (leave_subtrahends(front) == Answer::Undecided || close(front.t, out_.t)) return Answer::Undecided;
            if (front.t > out_.t || front.t > t_max_) return Answer::Nothing;
            if (front.t >= t_min_) {
                found = front;
                return Answer::Found;
            }
            // The solid begins before the range: it ends at the next subtrahend, or where the minuend does.
            Crossing end = out_;
            std::uint32_t next = count_;
            for (std::uint32_t i = 0; i < count_; ++i) {
                const Crossing& cut = scratch_.spans_[i].in;
                if (close(cut.t, end.t)) return Answer::Undecided;
                if (cut.t < end.t) end = cut, next = i;
            }
            if (end.t > t_max_) return Answer::Nothing;
            if (end.t >= t_min_) {
                found = end;
                return Answer::Found;
            }
            if (next == count_) return Answer::Nothing;
            front = scratch_.spans_[next].out;
            scratch_.spans_[next] = scratch_.spans_[--count_];
        }
    }

    std::size_t first_operand() const { return program_.nodes[0].op == Op::Leaf ? 0 : 1; }

    const Program& program_;
    const SolidStore& store_;
    const Ray& ray_;
    double t_min_, t_max_, reach_ = 0.0;
    Scratch& scratch_;
    Crossing in_, out_;
    std::uint32_t count_ = 0;
};

/// The nearest crossing seen with t_min <= t <= t_max; `part` is kNoPart when there is none.
inline Crossing nearest_visible(const Program& program, const SolidStore& store, const Ray& ray, double t_min,
                                double t_max, Scratch& scratch)
{
    Crossing found{.t = kInfinity};
    if (program.nodes.empty()) return found;
    if (program.flat_convex) {
        const Front::Answer answer = Front(program, store, ray, t_min, t_max, scratch).nearest(found);
        if (answer != Front::Answer::Undecided) return found;
    }
    return Evaluation(program, store, ray, t_min, t_max, scratch).nearest();
}

/// All crossings seen with t_min <= t <= t_max, nearest first, in scratch: valid until its next use.
inline std::pair<const Crossing*, const Crossing*> visible_crossings(const Program& program, const SolidStore& store,
                                                                     const Ray& ray, double t_min, double t_max,
                                                                     Scratch& scratch)
{
    if (program.nodes.empty()) return {nullptr, nullptr};
    const auto [begin, end] = Evaluation(program, store, ray, t_min, t_max, scratch).crossings();
    for (Crossing* a = begin; a != end; ++a)  // few of them, and nearly sorted
        for (Crossing* b = a; b != begin && b->t < (b - 1)->t; --b) std::swap(*b, *(b - 1));
    return {begin, end};
}

/// The spans of the ray inside the solid, whole line, in scratch: valid until its next use.
inline SpanList inside_spans(const Program& program, const SolidStore& store, const Ray& ray, Scratch& scratch)
{
    if (program.nodes.empty()) return {};
    return Evaluation(program, store, ray, -kInfinity, kInfinity, scratch).inside();
}

}  // namespace csg
