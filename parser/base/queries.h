#pragma once

#include "function/points/evaluate.h"
#include "render/scene/description.h"

#include <optional>
#include <span>

namespace parser {

struct ObjectHit {
    bool hit = false;
    glm::dvec3 point{0}, normal{0};
};

/// Questions to the scene while it is read: the parser knows neither geometry nor textures, so whoever starts it
/// answers (Options::queries). Answers may throw std::runtime_error with the reason of a refusal. What depends on
/// global settings, as the noise of an isosurface does, is answered with those read so far.
class SceneQueries {
public:
    using ObjectPtr = std::shared_ptr<const scene::Object>;
    virtual ~SceneQueries() = default;

    /// The first crossing of the object's surface; `direction` of unit length.
    virtual ObjectHit trace(const ObjectPtr& object, const glm::dvec3& origin, const glm::dvec3& direction,
                            const scene::Description& so_far) = 0;
    virtual bool inside(const ObjectPtr& object, const glm::dvec3& point, const scene::Description& so_far) = 0;
    /// Sum of vector noise over the octaves, as the turbulence of patterns has it.
    virtual glm::dvec3 turbulence(const glm::dvec3& point, int octaves, double lambda, double omega) = 0;
    /// The box that min_extent() and max_extent() tell.
    virtual csg::Aabb extent(const ObjectPtr& object) = 0;
    /// A function that asks for noise, patterns or pigments, with the global settings read so far.
    virtual function::Values evaluate(const function::FunctionPtr& called, const double* arguments,
                                      const scene::Description& so_far) = 0;
    /// The same at many points; `values` has as many.
    virtual void evaluate(const function::FunctionPtr& called, std::span<const glm::dvec3> points,
                          std::span<function::Values> values, const scene::Description& so_far) = 0;
};

}  // namespace parser
