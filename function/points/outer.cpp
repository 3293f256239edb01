#include "function/points/outer.h"

namespace function {

std::array<double, 5> outer_value(const SceneReference& what, const double* a, const Host& host)
{
    if (const auto* spline = std::get_if<std::shared_ptr<const Spline>>(&what)) return (*spline)->at(a[0]);
    const glm::dvec3 p(a[0], a[1], a[2]);
    if (const auto* transform = std::get_if<csg::Transform>(&what)) {
        const glm::dvec3 q = transform->point(p);
        return {q.x, q.y, q.z, 0.0, 0.0};
    }
    const auto& use = std::get<SceneUse>(what);
    if (use.kind == SceneUse::Kind::Pigment) return host.pigment(use.slot, p);
    return {host.pattern(use.slot, p), 0.0, 0.0, 0.0, 0.0};
}

}  // namespace function
