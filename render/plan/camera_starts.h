#pragma once

#include "csg/base/types.h"
#include "render/plan/compiled_scene.h"

namespace plan {

inline bool blurred(const scene::Camera& camera) { return camera.aperture != 0.0 && camera.blur_samples > 0; }

/// Whether rays of the camera start at different places: then each asks what it is inside of (spec 2, 4.11).
inline bool starts_differ(const scene::Camera& camera)
{
    using Kind = scene::Camera::Kind;
    if (blurred(camera) || camera.kind == Kind::Orthographic || camera.kind == Kind::Mesh) return true;
    if (camera.functions && camera.functions->location[0]) return true;
    return camera.kind == Kind::Cylinder && camera.cylinder_type >= 3;
}

/// A box around the places from which rays of the camera start, those of samples beyond the picture's edge among them.
csg::Aabb camera_starts(const scene::Camera& camera, const MeshCamera* mesh);

/// Fills in camera_interiors, or start_holders where starts differ.
void find_camera_interiors(CompiledScene& scene);

}  // namespace plan
