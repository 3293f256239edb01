#pragma once

#include "csg/base/hit.h"
#include "render/plan/mesh_camera.h"
#include "render/scene/description.h"
#include "render/texture/texture_set.h"

namespace trace {

/// From a sample position to a ray (spec 2, sections 4 and 5).
/// A position counts pixels from the top left; whole numbers are pixel centres.
class CameraRays {
public:
    /// What some cameras ask of the compiled scene, which outlives them. A mesh camera without its mesh has no rays.
    struct Extras {
        const plan::MeshCamera* mesh = nullptr;
        const texture::TextureSet* textures = nullptr;
        std::uint32_t normal = texture::kNone;  ///< bends the rays; index into textures->normals
        /// Of a user-defined camera's rays (plan::CompiledScene::camera_functions).
        std::array<std::uint32_t, 6> functions{texture::kNone, texture::kNone, texture::kNone,
                                               texture::kNone, texture::kNone, texture::kNone};
    };

    CameraRays(const scene::Camera& camera, int width, int height, const Extras& extras);
    CameraRays(const scene::Camera& camera, int width, int height) : CameraRays(camera, width, height, Extras{}) {}

    /// False for a sample without a ray (outside a fisheye's circle): it is black with transmit 1.
    /// k: which of the rays_per_sample() rays.
    bool ray(double px, double py, csg::Ray& out, int k = 0) const;

    /// A mesh camera may average several rays for one sample, and some of them may be missing; all others have one.
    int rays_per_sample() const { return extras_.mesh ? extras_.mesh->rays_per_pixel : 1; }

    /// Asks memory for what ray() will read of a mesh.
    void fetch(double px, double py, int k) const;

    /// The same with a direction of any length, 0 too.
    bool unscaled_ray(double px, double py, csg::Ray& out) const;

    /// Directions of a perspective camera's samples at (px[i], py[i]), i < rays.count, in vector lanes; the same bits
    /// as from ray(). Reads up to a multiple of 8. False if one of them has no length.
    bool perspective(const double* px, const double* py, csg::RayTile& rays) const;

    /// Whole rays of an orthographic camera without a normal, in the same way.
    bool parallel(const double* px, const double* py, csg::RayTile& rays) const;
    bool is_parallel() const
    {
        return camera_.kind == scene::Camera::Kind::Orthographic && extras_.normal == texture::kNone;
    }

    /// Directions of any length of a perspective camera's samples, in vector lanes; the same bits as from
    /// unscaled_ray(). Reads and writes up to a multiple of 8.
    void unscaled_perspective(const double* px, const double* py, int count, double* dx, double* dy, double* dz) const;
    bool is_perspective() const { return camera_.kind == scene::Camera::Kind::Perspective; }

    /// All rays start in the eye: a tile of them is a beam.
    bool common_origin() const { return common_origin_; }

    /// What is farther counts as sky; 0: nothing does.
    double max_distance() const { return extras_.mesh ? extras_.mesh->max_distance : 0.0; }

    /// Perspective with its directions in one half space: neighbours stay neighbours in every plane through the eye.
    bool flat_projection() const
    {
        return camera_.kind == scene::Camera::Kind::Perspective && common_origin_ && extras_.normal == texture::kNone;
    }

private:
    // `place` is where a normal of the camera is evaluated (spec 2, section 6).
    bool project(double px, double py, int k, csg::Ray& out, glm::dvec2& place) const;
    bool fisheye(double u, double v, csg::Ray& out, glm::dvec2& place) const;
    bool omnimax(double u, double v, csg::Ray& out, glm::dvec2& place) const;
    void cylinder(double u, double v, csg::Ray& out, glm::dvec2& place) const;
    void spherical(double u, double v, csg::Ray& out, glm::dvec2& place) const;
    void user_defined(double u, double v, csg::Ray& out) const;
    void panoramic(double px, double v, csg::Ray& out, glm::dvec2& place) const;
    /// The direction at `theta` from the axis, towards the polar angle of (a, b) in the picture.
    glm::dvec3 polar(double theta, double a, double b) const;

    scene::Camera camera_;
    Extras extras_;
    double width_, height_;
    glm::dvec3 unit_direction_, unit_right_, unit_up_;
    double length_right_, length_up_;
    double angle_, angle2_;  ///< radians
    bool common_origin_;
};

}  // namespace trace
