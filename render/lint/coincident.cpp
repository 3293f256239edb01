#include "render/lint/findings.h"
#include "render/lint/walk.h"
#include "render/plan/geometry/extent.h"
#include "render/plan/probe.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

// Two solids share a part of their surfaces if both change from inside to outside at the same points, to the same side.
// Points of the one's surface are found by rays and asked of both, a hair before and behind: that holds for any two
// solids, and faces that merely cross are met by almost no ray.
namespace lint {
namespace {

constexpr int kRaysAlong = 12;  ///< on a side of the box, a way through it: 6 * 12 * 12 rays
constexpr double kHair = 1e-7;  ///< of the size of what is cut
constexpr int kEnough = 3;      ///< shared points: a tangent line may give one
constexpr std::size_t kMostPairs = 2000;
constexpr double kMostSeconds = 5;

/// A box of the size that rays are sent through: what is outside of the first operand is not seen anyway.
std::optional<csg::Aabb> common_box(const scene::Object& first, const scene::Object& other)
{
    csg::Aabb box = plan::described_extent(first).intersected(plan::described_extent(other));
    constexpr double kUnbounded = 1e9;
    for (int axis = 0; axis < 3; ++axis)
        if (box.lower[axis] < -kUnbounded || box.upper[axis] > kUnbounded || !(box.lower[axis] <= box.upper[axis]))
            return {};
    return box;
}

int shared_points(plan::ObjectProbe& first, plan::ObjectProbe& other, const csg::Aabb& box)
{
    const glm::dvec3 size = box.upper - box.lower;
    const double length = glm::length(size), hair = kHair * length;
    int shared = 0;
    for (int side = 0; side < 6 && shared < kEnough; ++side) {
        const int axis = side / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
        glm::dvec3 direction(0);
        direction[axis] = side % 2 == 0 ? 1.0 : -1.0;
        for (int i = 0; i < kRaysAlong * kRaysAlong && shared < kEnough; ++i) {
            // Irrational steps: a ray along an edge says nothing.
            glm::dvec3 origin;
            origin[u] = box.lower[u] + size[u] * std::fmod((i + 0.5) * 0.7548776662466927, 1.0);
            origin[v] = box.lower[v] + size[v] * std::fmod((i + 0.5) * 0.5698402909980532, 1.0);
            origin[axis] = (side % 2 == 0 ? box.lower[axis] : box.upper[axis]) -
                           direction[axis] * (0.1 * length + 1e-3);
            const plan::ObjectProbe::Answer hit = other.trace(origin, direction);
            if (!hit.hit || glm::length(hit.normal) == 0) continue;
            const glm::dvec3 step = glm::normalize(hit.normal) * (hair + 1e-12 * glm::length(hit.point));
            const bool before = other.inside(hit.point - step), behind = other.inside(hit.point + step);
            if (before == behind) continue;
            shared += first.inside(hit.point - step) == before && first.inside(hit.point + step) == behind;
        }
    }
    return shared;
}

}  // namespace

void check_coincident(Findings& out, const scene::Description& description)
{
    if (!out.wants("coincident-faces")) return;
    std::size_t pairs = 0;
    const auto start = std::chrono::steady_clock::now();
    walk(description, [&](const Visited& at) {
        const auto* cut = std::get_if<scene::Csg>(&at.object.shape);
        if (!cut || cut->op != scene::CsgOp::Difference || !cut->operands || cut->operands->size() < 2) return;
        const scene::Object& first = cut->operands->front();
        if (scene::is_light(first)) return;
        std::unique_ptr<plan::ObjectProbe> first_probe;
        for (std::size_t i = 1; i < cut->operands->size(); ++i) {
            const scene::Object& other = (*cut->operands)[i];
            const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
            if (scene::is_light(other) || ++pairs > kMostPairs || spent.count() > kMostSeconds) continue;
            const std::optional<csg::Aabb> box = common_box(first, other);
            if (!box) continue;
            if (!first_probe) first_probe = std::make_unique<plan::ObjectProbe>(first, description.global);
            plan::ObjectProbe probe(other, description.global);
            if (shared_points(*first_probe, probe, *box) >= kEnough)
                out.add("coincident-faces", other.source,
                        fmt::format("a face of this {} lies in a face of the {} that it is cut from", name_of(other),
                                    name_of(first)),
                        {{first.source, "cut from this"}});
        }
    });
}

}  // namespace lint
