#pragma once

#include "render/kernel/path/directions.h"
#include "render/kernel/context/context.h"
#include "render/plan/shines_on.h"

/// Area lights as faces that paths meet behind mirrors and bodies that bend light: caustics.
namespace trace::path {

/// Whether a body bends what goes through its surface. What it lets through then finds lamps by paths alone.
inline bool bends(const plan::CompiledScene& scene, const plan::Surface& surface)
{
    return surface.interior != plan::kNone && scene.interiors[surface.interior].ior != 1.0f;
}

/// A path since the last surface that scattered it.
struct Chain {
    const plan::Surface* from = nullptr;  ///< that surface; null: the camera, which sees no lamps
    double begin = 0;                     ///< length of the path there
    bool turned = false;                  ///< mirrored or bent since: no shadow ray tells of the lamps it meets
};

class LampFaces {
public:
    /// \param lights after plan::free_light(), which outlive it; null: none is met
    explicit LampFaces(const light::LightSet* lights);

    bool any() const { return !faces_.empty(); }
    bool has(const light::Light& light) const;

    /// Radiance of the lamps that the ray meets before `end`. way: of the chain, up to the ray's start. dim(t): share
    /// of the light that a way of t along the ray leaves
    template <class Dim>
    glm::vec3 met(const csg::Ray& ray, double start, double end, double way, const plan::Surface& lit, Dim&& dim) const
    {
        glm::vec3 sum(0);
        for (const Face& face : faces_) {
            if (!shines_on(*face.light, lit)) continue;
            const double facing = glm::dot(ray.direction, face.normal);
            if (facing == 0.0) continue;
            const double t = glm::dot(face.light->location - ray.origin, face.normal) / facing;
            if (!(t > start) || !(t < end)) continue;
            const double density = face.density(ray.at(t));
            if (density > 0.0) sum += radiance(face, ray, t, way, density / std::abs(facing)) * dim(t);
        }
        return sum;
    }

private:
    struct Face {
        const light::Light* light;
        glm::dvec3 normal;          ///< unit
        glm::dvec3 along1, along2;  ///< the dot product with these tells how far along the light's axes a place is
        double half1, half2;        ///< of the face, in axes
        double area;                ///< of the rectangle

        /// Of plan::free_light()'s places of the lamp, by area; 0: beside the face.
        double density(const glm::dvec3& place) const;
    };
    static glm::vec3 radiance(const Face& face, const csg::Ray& ray, double t, double way, double density);

    std::vector<Face> faces_;
};

}  // namespace trace::path
