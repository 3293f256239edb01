#pragma once

// Continues evaluate.h: the queries that callers use.
#include "csg/flat_front.h"

namespace csg {

/// The nearest crossing seen with t_min <= t <= t_max; `part` is kNoPart when there is none.
inline Crossing nearest_visible(const Program& program, const SolidStore& store, const Ray& ray, double t_min,
                                double t_max, Scratch& scratch)
{
    Crossing found{.t = kInfinity};
    if (program.nodes.empty()) return found;
    if (program.flat.usable()) {
        const auto answer = FlatFront(program.flat, store, ray, t_min, t_max, scratch).nearest(found);
        if (answer == FlatFront::Answer::Found) return found;
        if (answer == FlatFront::Answer::Nothing) return {.t = kInfinity};
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

/// All crossings seen with t_min <= t <= t_max, each once, in any order, in scratch: valid until its next use.
inline std::pair<const Crossing*, const Crossing*> unordered_crossings(const Program& program, const SolidStore& store,
                                                                       const Ray& ray, double t_min, double t_max,
                                                                       Scratch& scratch)
{
    if (program.nodes.empty()) return {nullptr, nullptr};
    if (program.flat.usable()) {
        scratch.prepare(program);
        const auto answer = FlatFront(program.flat, store, ray, t_min, t_max, scratch).crossings([&](const Crossing& c) {
            scratch.add_once(c);
        });
        if (answer != FlatFront::Answer::Undecided) return scratch.crossings();
    }
    return Evaluation(program, store, ray, t_min, t_max, scratch).crossings();
}

/// The spans of the ray inside the solid, whole line, in scratch: valid until its next use.
inline SpanList inside_spans(const Program& program, const SolidStore& store, const Ray& ray, Scratch& scratch)
{
    if (program.nodes.empty()) return {};
    return Evaluation(program, store, ray, -kInfinity, kInfinity, scratch).inside();
}

}  // namespace csg
