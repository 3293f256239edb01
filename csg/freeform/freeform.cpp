#include "csg/freeform/freeform.h"

#include "csg/base/hit.h"
#include "csg/freeform/freeform_solid.h"

#include <array>
#include <type_traits>

namespace csg {
namespace {

template <class Kind>
Ray into(const Kind& kind, const Transform& frame, const Ray& ray)
{
    if constexpr (OfLastBits<Kind>) return {kind.into(frame, ray.origin), frame.inverse_vector(ray.direction)};
    else return local_ray(frame, ray);
}

template <class Kind>
glm::dvec3 into(const Kind& kind, const Transform& frame, const glm::dvec3& point)
{
    if constexpr (OfLastBits<Kind>) return kind.into(frame, point);
    else return frame.inverse_point(point);
}

}  // namespace

FreeformShape::~FreeformShape() = default;

Aabb FreeformShape::extent(const Transform& moved) const
{
    return std::visit(
        [&](const auto& form) {
            if constexpr (requires { form.extent(moved); }) return form.extent(moved);
            else if constexpr (requires { form.extent(); }) return transformed_box(moved, form.extent());
            else return transformed_box(moved, form.bounds());
        },
        kind);
}

bool Freeform::surface() const
{
    return std::visit([](const auto& kind) { return std::decay_t<decltype(kind)>::kSurface; }, shape->kind);
}

bool Freeform::has_open_surface() const
{
    return std::visit(
        [](const auto& kind) {
            return requires { std::decay_t<decltype(kind)>::kOpenSurface; };
        },
        shape->kind);
}

bool Freeform::round() const
{
    return std::visit(
        [](const auto& kind) {
            return requires { std::decay_t<decltype(kind)>::kRound; };
        },
        shape->kind);
}

bool Freeform::blends_normals() const
{
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.blends_normals(); }) return kind.blends_normals();
            else return false;
        },
        shape->kind);
}

bool Freeform::reports_touches() const
{
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.reports_touches(); }) return kind.reports_touches();
            else return std::decay_t<decltype(kind)>::kSurface;
        },
        shape->kind);
}

bool Freeform::one_way() const
{
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.one_way(); }) return kind.one_way();
            else return false;
        },
        shape->kind);
}

bool Freeform::closed() const
{
    return std::visit([](const auto& kind) { return std::decay_t<decltype(kind)>::kClosed; }, shape->kind);
}

bool Freeform::inverse_closed() const
{
    return std::visit([](const auto& kind) { return std::decay_t<decltype(kind)>::kInverseClosed; }, shape->kind);
}

void Freeform::intersect(const Ray& ray, IntersectionList& out) const
{
    std::visit(
        [&](const auto& kind) {
            const Ray local = into(kind, frame, ray);
            if constexpr (OfLastBits<std::decay_t<decltype(kind)>>) kind.intersect(local, out, !frame.identity());
            else kind.intersect(local, out);
        },
        shape->kind);
}

bool Freeform::intersects_many() const
{
    return std::visit(
        [](const auto& kind) {
            if constexpr (IntersectsMany<std::decay_t<decltype(kind)>>) return kind.intersects_many();
            else return false;
        },
        shape->kind);
}

void Freeform::intersect_many(RayBatch& batch) const
{
    std::visit(
        [&](const auto& kind) {
            using Kind = std::decay_t<decltype(kind)>;
            for (Ray& ray : batch.asked()) ray = into(kind, frame, ray);
            if constexpr (OfLastBits<Kind>) kind.intersect_many(batch.asked(), batch.records.data(), !frame.identity());
            else if constexpr (IntersectsMany<Kind>) kind.intersect_many(batch.asked(), batch.records.data());
            else
                for (std::size_t k = 0; k < batch.count; ++k) kind.intersect(batch.rays[k], batch.records[k]);
        },
        shape->kind);
}

void Freeform::spans(const Ray& ray, double from, double to, SpanList& out) const
{
    IntersectionList record(from, to, false);
    intersect(ray, record);
    record.each_span([&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
        out.push({{.t = in, .face = in_face}, {.t = end, .face = end_face}});
    });
}

bool Freeform::meets_no_more(const Ray& ray, double from, double to) const
{
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.meets_no_more(ray, from, to); })
                return kind.meets_no_more(local_ray(frame, ray), from, to);
            else return false;
        },
        shape->kind);
}

bool Freeform::contains(const glm::dvec3& p) const
{
    return std::visit([&](const auto& kind) { return kind.contains(into(kind, frame, p)); }, shape->kind);
}

bool Freeform::contains_inverted(const glm::dvec3& p) const
{
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.contains_inverted(p); })
                return kind.contains_inverted(frame.inverse_point(p));
            else return !kind.contains(into(kind, frame, p));
        },
        shape->kind);
}

glm::dvec3 Freeform::normal(const glm::dvec3& p, std::uint32_t face) const
{
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.world_gradient(frame, p, face); })
                return unit_or_x(kind.world_gradient(frame, frame.inverse_point(p), face));
            else return unit_or_x(frame.normal(kind.gradient(into(kind, frame, p), face)));
        },
        shape->kind);
}

void Freeform::normals(std::span<const glm::dvec3> points, std::span<const std::uint32_t> faces, glm::dvec3* out) const
{
    std::visit(
        [&](const auto& kind) {
            std::array<glm::dvec3, kTileRays> local;
            const auto into = [&] {
                for (std::size_t i = 0; i < points.size(); ++i) local[i] = frame.inverse_point(points[i]);
                return std::span<const glm::dvec3>(local.data(), points.size());
            };
            if constexpr (requires { kind.world_gradients(frame, points, faces, out); }) {
                kind.world_gradients(frame, into(), faces, out);
                for (std::size_t i = 0; i < points.size(); ++i) out[i] = unit_or_x(out[i]);
            } else if constexpr (requires { kind.gradients(points, faces, out); }) {
                kind.gradients(into(), faces, out);
                for (std::size_t i = 0; i < points.size(); ++i) out[i] = unit_or_x(frame.normal(out[i]));
            } else {
                for (std::size_t i = 0; i < points.size(); ++i) out[i] = normal(points[i], faces[i]);
            }
        },
        shape->kind);
}

glm::dvec2 Freeform::uv(const glm::dvec3& p, std::uint32_t face) const
{
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.uv(p, face); }) return kind.uv(frame.inverse_point(p), face);
            else return glm::dvec2(p);
        },
        shape->kind);
}

void Freeform::shares(const glm::dvec3& p, std::vector<Share>& out) const
{
    std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.shares(p, out); }) kind.shares(frame.inverse_point(p), out);
        },
        shape->kind);
}

Aabb Freeform::bounds() const
{
    return in_world(std::visit([](const auto& kind) { return kind.bounds(); }, shape->kind));
}

Aabb Freeform::drawn_bounds() const
{
    return in_world(std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.drawn_bounds(); }) return kind.drawn_bounds();
            else return kind.bounds();
        },
        shape->kind));
}

Aabb Freeform::space() const
{
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.space(); }) return kind.space();
            else return kind.bounds();
        },
        shape->kind);
}

Aabb Freeform::in_world(const Aabb& local) const
{
    return local.empty() || !local.finite() ? local : padded(transformed_box(frame, local));
}

}  // namespace csg
