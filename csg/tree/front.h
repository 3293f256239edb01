#pragma once

// Continues evaluate.h: the queries that callers use.
#include "csg/tree/evaluate.h"

namespace csg {

/// The nearest crossing seen with t_min <= t <= t_max; `part` is kNoPart when there is none.
inline Crossing nearest_visible(const Program& program, const SolidStore& store, const Ray& ray, double t_min,
                                double t_max, Scratch& scratch)
{
    if (program.nodes.empty()) return {.t = kInfinity};
    return Evaluation(program, store, ray, t_min, t_max, scratch).nearest();
}

/// All crossings seen with t_min <= t <= t_max, each once, in any order, in scratch: valid until its next use.
inline std::pair<Crossing*, Crossing*> each_visible(const Program& program, const SolidStore& store, const Ray& ray,
                                                    double t_min, double t_max, Scratch& scratch)
{
    if (program.nodes.empty()) return {nullptr, nullptr};
    return Evaluation(program, store, ray, t_min, t_max, scratch).crossings();
}

/// The same, nearest first.
inline std::pair<const Crossing*, const Crossing*> visible_crossings(const Program& program, const SolidStore& store,
                                                                     const Ray& ray, double t_min, double t_max,
                                                                     Scratch& scratch)
{
    const auto [begin, end] = each_visible(program, store, ray, t_min, t_max, scratch);
    for (Crossing* a = begin; a != end; ++a)  // few of them, and nearly sorted
        for (Crossing* b = a; b != begin && b->t < (b - 1)->t; --b) std::swap(*b, *(b - 1));
    return {begin, end};
}

/// f(Crossing) for all crossings seen with t_min <= t <= t_max, each once, in any order. f may not use scratch.
template <class F>
inline void each_crossing(const Program& program, const SolidStore& store, const Ray& ray, double t_min, double t_max,
                          Scratch& scratch, F&& f)
{
    const auto [first, last] = each_visible(program, store, ray, t_min, t_max, scratch);
    for (const Crossing* c = first; c != last; ++c) f(*c);
}

/// The spans of the ray inside the solid, whole line, in scratch: valid until its next use.
inline SpanList inside_spans(const Program& program, const SolidStore& store, const Ray& ray, Scratch& scratch)
{
    if (program.nodes.empty()) return {};
    return Evaluation(program, store, ray, -kInfinity, kInfinity, scratch).inside();
}

}  // namespace csg
