#pragma once

#include "csg/base/hit.h"
#include "render/plan/mesh_camera.h"

namespace trace {

/// The ray `k` of a sample position in a picture of that size (spec 2, section 5; spec 7d, 6); false: there is none.
bool mesh_camera_ray(const plan::MeshCamera& camera, double px, double py, int width, int height, int k, csg::Ray& out);

/// Asks memory for what mesh_camera_ray() reads: a mesh of many rays a pixel is larger than caches.
void fetch_mesh_camera_ray(const plan::MeshCamera& camera, double px, double py, int width, int height, int k);

}  // namespace trace
