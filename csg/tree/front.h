#pragma once

// Continues evaluate.h: the queries that callers use.
#include "csg/tree/evaluate.h"
#include "csg/tree/product_front.h"

namespace csg {

/// The nearest crossing seen with t_min <= t <= t_max; `part` is kNoPart when there is none. `slabs` of the ray, if
/// they are known.
inline Crossing nearest_visible(const Program& program, const SolidStore& store, const Ray& ray, double t_min,
                                double t_max, Scratch& scratch, const RaySlabs* slabs = nullptr)
{
    Crossing found{.t = kInfinity};
    if (program.nodes.empty()) return found;
    if (program.products.usable()) {
        const auto answer = ProductFront(program.products, store, ray, slabs, t_min, t_max, scratch).nearest(found);
        if (answer == ProductFront::Answer::Found) return found;
        if (answer == ProductFront::Answer::Nothing) return {.t = kInfinity};
    }
    return Evaluation(program, store, ray, t_min, t_max, scratch).nearest();
}

/// All crossings seen with t_min <= t <= t_max, nearest first, in scratch: valid until its next use.
inline std::pair<const Crossing*, const Crossing*> visible_crossings(const Program& program, const SolidStore& store,
                                                                     const Ray& ray, double t_min, double t_max,
                                                                     Scratch& scratch)
{
    if (program.nodes.empty()) return {nullptr, nullptr};
    return Evaluation(program, store, ray, t_min, t_max, scratch).crossings();
}

/// f(Crossing) for all crossings seen with t_min <= t <= t_max, each once, in any order. f may not use scratch.
template <class F>
inline void each_crossing(const Program& program, const SolidStore& store, const Ray& ray, double t_min, double t_max,
                          Scratch& scratch, const RaySlabs* slabs, F&& f)
{
    if (program.nodes.empty()) return;
    if (program.products.usable()) {
        ProductFront front(program.products, store, ray, slabs, t_min, t_max, scratch);
        if (program.products.terms.size() == 1 &&
            program.products.terms[0].plain()) {  // decided before it emits anything
            if (front.crossings(f) != ProductFront::Answer::Undecided) return;
        } else {
            scratch.prepare(program);
            if (front.crossings([&](const Crossing& c) { scratch.add_once(c); }) != ProductFront::Answer::Undecided) {
                const auto [first, last] = scratch.crossings();
                for (const Crossing* c = first; c != last; ++c) f(*c);
                return;
            }
        }
    }
    const auto [first, last] = Evaluation(program, store, ray, t_min, t_max, scratch).crossings();
    for (const Crossing* c = first; c != last; ++c) f(*c);
}

/// The spans of the ray inside the solid, whole line, in scratch: valid until its next use.
inline SpanList inside_spans(const Program& program, const SolidStore& store, const Ray& ray, Scratch& scratch)
{
    if (program.nodes.empty()) return {};
    return Evaluation(program, store, ray, -kInfinity, kInfinity, scratch).inside();
}

}  // namespace csg
