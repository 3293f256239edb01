#pragma once

// Continues program.h: what one leaf's solid tells of one ray, inline, since each kernel has its own.
#include "csg/mesh/mesh_query.h"
#include "csg/tree/node_box.h"

namespace csg {

/// A leaf of a program, and what is known already along the ray at hand.
struct AskedLeaf {
    const SolidStore& store;
    const Node* nodes;
    std::uint32_t leaf;
    const FetchedSpans& fetched;
};

/// Calls f(t, face, t, face) for where the ray goes into a solid and out of it, nearest first; right between t_min and
/// t_max. The list is memory for what solids tell. A mesh tells of what lies outside of it if `inverted`, all others
/// are asked as they are.
template <class T, class F>
inline void each_span_of(const T& solid, const Ray& ray, bool inverted, double t_min, double t_max, double reach,
                         const AskedLeaf& of, SpanList list, F&& f)
{
    if constexpr (std::is_same_v<T, Triangle>) {
        return;  // bounds nothing
    } else if constexpr (std::is_same_v<T, Extrusion>) {
        // Wider than what coincides with an end of the range.
        const auto room = [reach](double t) { return 2.0 * kCoincidence * (std::abs(t) + reach); };
        solid.each_span(ray, f, t_min - room(t_min), t_max + room(t_max));
    } else if constexpr (requires { solid.intersect(ray, list); }) {
        if constexpr (std::is_same_v<T, Freeform>) {
            if (solid.surface()) return;
            if (of.fetched.each_span(of.nodes + of.leaf, t_min, t_max, f)) return;
            Stretch part{t_min, t_max};
            narrow_to_deciding(of.store, of.nodes, of.leaf, ray, part);
            solid.spans(ray, part.from, part.to, list);
        } else if constexpr (std::is_same_v<T, Mesh>) {
            solid.spans(ray, inverted, list);
        } else {
            solid.intersect(ray, list);
        }
        for (const Span& span : list) f(span.in.t, span.in.face, span.out.t, span.out.face);
    } else {
        Interval in;
        if (solid.interval(ray, in) && in.entry <= in.exit) f(in.entry, in.entry_face, in.exit, in.exit_face);
    }
}

/// Calls f(t, face) for what a leaf draws that ends no span.
template <class F>
inline void each_touch_of(const SolidStore& store, PartId part, const Ray& ray, double t_min, double t_max, F&& f)
{
    switch (kind_of(part)) {
    case SolidKind::Triangle: {
        double t = 0.0;
        if (store.all<Triangle>()[index_of(part)].crossing(ray, t)) f(t, 0u);
        break;
    }
    case SolidKind::Mesh: {  // every face is drawn, whether it bounds a span or not
        const Mesh& mesh = store.all<Mesh>()[index_of(part)];
        std::uint32_t left = mesh.most_crossings();
        mesh_crossings(*mesh.shape, local_ray(mesh.frame, ray), t_min, t_max, [&](double t, std::uint32_t face) {
            f(t, face);
            return --left > 0 ? t_max : -kInfinity;
        });
        break;
    }
    case SolidKind::Freeform: {
        IntersectionList record(t_min, t_max, false);
        store.all<Freeform>()[index_of(part)].intersect(ray, record);
        record.each_touching(f);
        break;
    }
    case SolidKind::Torus: {
        double t[2];
        const int n = store.all<Torus>()[index_of(part)].inner_sheet(ray, t);
        for (int i = 0; i < n; ++i) f(t[i], 0u);
        break;
    }
    default: break;
    }
}

}  // namespace csg
