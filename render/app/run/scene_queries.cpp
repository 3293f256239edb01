#include "render/app/run/scene_queries.h"

#include "function/field/field.h"
#include "parser/parse.h"
#include "render/kernel/kernel.h"
#include "render/picture/kernel_module.h"

#include <algorithm>

namespace app {
namespace {

constexpr std::size_t kMostKept = 256;  // a loop that declares an object in every pass must not fill the memory

}  // namespace

plan::ObjectProbe& SceneQueries::probe(const ObjectPtr& object, const scene::Description& so_far)
{
    follow(so_far);
    if (object.get() == last_) return *last_probe_;
    auto known = objects_.find(object);
    if (known == objects_.end()) {
        if (objects_.size() >= kMostKept) objects_.clear();
        scene::GlobalSettings global;  // as many waves as functions have while the scene is read
        global.noise_generator = noise_generator_;
        known = objects_.emplace(object, std::make_unique<plan::ObjectProbe>(*object, global, so_far.povray)).first;
    }
    last_ = object.get();  // alive: the map holds it
    return *(last_probe_ = known->second.get());
}

parser::ObjectHit SceneQueries::trace(const ObjectPtr& object, const glm::dvec3& origin, const glm::dvec3& direction,
                                      const scene::Description& so_far)
{
    const auto answer = probe(object, so_far).trace(origin, direction);
    return {answer.hit, answer.point, answer.normal};
}

bool SceneQueries::inside(const ObjectPtr& object, const glm::dvec3& point, const scene::Description& so_far)
{
    return probe(object, so_far).inside(point);
}

glm::dvec3 SceneQueries::turbulence(const glm::dvec3& point, int octaves, double lambda, double omega)
{
    return plan::turbulence(point, octaves, lambda, omega);
}

csg::Aabb SceneQueries::extent(const ObjectPtr& object) { return plan::described_extent(*object); }

void SceneQueries::follow(const scene::Description& so_far)
{
    if (so_far.global.noise_generator == noise_generator_) return;
    noise_generator_ = so_far.global.noise_generator;
    functions_.clear();
    objects_.clear();
    last_ = nullptr;
}

const plan::FunctionProbe& SceneQueries::function_probe(const function::FunctionPtr& called,
                                                        const scene::Description& so_far)
{
    follow(so_far);
    if (functions_.size() >= kMostKept) functions_.clear();
    // The kernel that renders knows the processor better. It is loaded in the background meanwhile.
    if (functions_.empty()) function::use(trace::load_kernel(isa_).evaluators);
    auto& kept = functions_[called];
    if (!kept) kept = std::make_unique<plan::FunctionProbe>(called, so_far);
    return *kept;
}

function::Values SceneQueries::evaluate(const function::FunctionPtr& called, const double* arguments,
                                        const scene::Description& so_far)
{
    return function_probe(called, so_far).evaluate(arguments);
}

void SceneQueries::evaluate(const function::FunctionPtr& called, std::span<const glm::dvec3> points,
                            std::span<function::Values> values, const scene::Description& so_far)
{
    constexpr std::size_t kRun = 256;  // a granite takes microseconds
    const plan::FunctionProbe& probe = function_probe(called, so_far);
    threads_.each(0, (points.size() + kRun - 1) / kRun, [&](std::size_t run, int) {
        if (cancel_) throw parser::Cancelled();
        const std::size_t first = run * kRun, count = std::min(kRun, points.size() - first);
        probe.evaluate(points.subspan(first, count), values.subspan(first, count));
    });
}

}  // namespace app
