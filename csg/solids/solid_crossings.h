#pragma once

#include "csg/mesh/mesh_query.h"
#include "csg/solids/solid.h"

#include <type_traits>

/// All crossings of one solid with a ray.
namespace csg {

/// A lone solid's crossings in [t_min, t_max]: f(t, face) for each drawn one, in POV-Ray's order of generation where
/// that decides ties. `nearest_only`: the others may be left out.
template <class T, class F>
inline void solid_crossings(const T& solid, const Ray& ray, double t_min, double t_max, bool nearest_only, F&& f)
{
    const auto offer = [&](double t, std::uint32_t face) {
        if (t >= t_min && t <= t_max && face != kUndrawnFace && t < kInfinity && t > -kInfinity) f(t, face);
    };
    if constexpr (std::is_same_v<T, Triangle>) {
        double t = 0.0;
        if (solid.crossing(ray, t)) offer(t, 0);
    } else if constexpr (std::is_same_v<T, Mesh>) {
        mesh_crossings(*solid.shape, local_ray(solid.frame, ray), t_min, t_max, [&](double t, std::uint32_t face) {
            offer(t, face);
            return t_max;
        });
    } else if constexpr (std::is_same_v<T, Freeform>) {
        IntersectionList record(t_min, t_max, nearest_only);
        solid.intersect(ray, record);
        record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
            offer(in, in_face);
            offer(out, out_face);
        });
        record.each_touching(offer);
    } else if constexpr (std::is_same_v<T, Extrusion>) {
        solid.each_span(
            ray,
            [&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                offer(in, in_face);
                offer(out, out_face);
            },
            t_min, t_max, nearest_only);
    } else if constexpr (std::is_same_v<T, Polynomial>) {
        solid.each_crossing(ray, t_min, t_max, nearest_only, [&](double t, bool) { offer(t, 0); });
    } else if constexpr (requires { solid.each_span(ray, [](double, std::uint32_t, double, std::uint32_t) {}); }) {
        solid.each_span(ray, [&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
            offer(in, in_face);
            offer(out, out_face);
        });
    } else if constexpr (std::is_same_v<T, Torus>) {
        double t[4];
        const int n = solid.roots(ray, t);
        for (int i = 0; i < n; ++i) offer(t[i], 0);
    } else if constexpr (requires { solid.intersect(ray, std::declval<SpanList&>()); }) {
        Span memory[4];
        SpanList spans(memory, 4);
        solid.intersect(ray, spans);
        for (const Span& span : spans) {
            offer(span.in.t, span.in.face);
            offer(span.out.t, span.out.face);
        }
    } else {
        Interval in;
        if (!solid.interval(ray, in)) return;
        offer(in.entry, in.entry_face);
        offer(in.exit, in.exit_face);
    }
}

}  // namespace csg
