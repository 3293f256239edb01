#pragma once

#include "parser/base/queries.h"
#include "render/plan/geometry/extent.h"
#include "render/plan/probe.h"
#include "render/picture/render.h"
#include "render/picture/threads.h"

#include <atomic>
#include <unordered_map>

namespace app {

/// Answers the parser's questions with the renderer's own parts. Objects and functions asked once are kept compiled.
class SceneQueries final : public parser::SceneQueries {
public:
    /// \param threads  that answer many questions
    /// \param cancel  when set, many questions end with parser::Cancelled
    /// \param isa  of the kernel that evaluates functions
    SceneQueries(int threads, const std::atomic<bool>& cancel, trace::Isa isa)
        : threads_(threads), cancel_(cancel), isa_(isa)
    {}
    parser::ObjectHit trace(const ObjectPtr& object, const glm::dvec3& origin, const glm::dvec3& direction,
                            const scene::Description& so_far) override;
    bool inside(const ObjectPtr& object, const glm::dvec3& point, const scene::Description& so_far) override;
    glm::dvec3 turbulence(const glm::dvec3& point, int octaves, double lambda, double omega) override;
    csg::Aabb extent(const ObjectPtr& object) override;
    function::Values evaluate(const function::FunctionPtr& called, const double* arguments,
                              const scene::Description& so_far) override;
    void evaluate(const function::FunctionPtr& called, std::span<const glm::dvec3> points,
                  std::span<function::Values> values, const scene::Description& so_far) override;

private:
    const plan::FunctionProbe& function_probe(const function::FunctionPtr& called, const scene::Description& so_far);
    plan::ObjectProbe& probe(const ObjectPtr& object, const scene::Description& so_far);
    void follow(const scene::Description& so_far);  ///< forgets what was made with another noise generator
    trace::Threads threads_;
    const std::atomic<bool>& cancel_;
    trace::Isa isa_;
    std::unordered_map<ObjectPtr, std::unique_ptr<plan::ObjectProbe>> objects_;
    const scene::Object* last_ = nullptr;  ///< asked last: questions come in rows
    plan::ObjectProbe* last_probe_ = nullptr;
    std::unordered_map<function::FunctionPtr, std::unique_ptr<plan::FunctionProbe>> functions_;
    int noise_generator_ = 0;  ///< that what is kept was made with
};

}  // namespace app
