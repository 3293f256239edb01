#pragma once

#include "function/points/evaluate.h"
#include "csg/world/inside_index.h"
#include "render/plan/compiled_scene.h"
#include "render/scene/base/povray.h"

#include <memory>
#include <optional>
#include <span>

namespace plan {

/// One object by itself, asked while the scene is read: trace() and inside() of the language (spec 5a, 12). Uses the
/// compiler and the geometry that pictures are made with. Not for several threads at once.
class ObjectProbe {
public:
    /// \param global noise and waves of the object's own functions
    /// \param povray whose last bits answers have, if anybody's
    explicit ObjectProbe(const scene::Object& object, const scene::GlobalSettings& global = {},
                         std::optional<scene::PovRay> povray = {});
    ~ObjectProbe();

    struct Answer {
        bool hit = false;
        glm::dvec3 point{0}, normal{0};
    };
    /// `direction` of unit length. The normal is raw: it is not turned toward the ray.
    Answer trace(const glm::dvec3& origin, const glm::dvec3& direction);
    bool inside(const glm::dvec3& point) const;  ///< may be asked from many threads at once
    const csg::InsideIndex& inside_index() const { return inside_; }

    csg::World world() const { return compiled_.world(); }  ///< of that object alone; lives as long as this

private:
    CompiledScene compiled_;
    csg::InsideIndex inside_;
    std::unique_ptr<csg::Scratch> scratch_;
};

/// The sum of vector noise behind vturbulence().
glm::dvec3 turbulence(const glm::dvec3& point, int octaves, double lambda, double omega);

/// A function that asks for noise, patterns or pigments, evaluated while the scene is read: at full quality and with 10
/// waves whatever the scene says (spec 4, 17).
class FunctionProbe {
public:
    /// Throws std::runtime_error if it needs a pattern that cannot be evaluated.
    FunctionProbe(const function::FunctionPtr& called, const scene::Description& so_far);

    function::Values evaluate(const double* arguments) const;
    /// Of a function of at most three parameters, at each point.
    void evaluate(std::span<const glm::dvec3> points, std::span<function::Values> values) const;

private:
    texture::TextureSet set_;
};

}  // namespace plan
