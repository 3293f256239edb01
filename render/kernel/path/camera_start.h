#pragma once

#include "render/kernel/camera/camera_rays.h"
#include "render/kernel/camera/focal_blur.h"
#include "render/kernel/path/path_tracer.h"
#include "render/kernel/path/walk.h"
#include "render/kernel/interior/start_interiors.h"

#include <algorithm>

namespace trace::path {

/// The rays that paths begin with.
class CameraStart {
public:
    explicit CameraStart(const plan::CompiledScene& scene)
        : rays_(scene.camera, scene.options.width, scene.options.height,
                {scene.mesh_camera.get(), &scene.textures, scene.camera_normal, scene.camera_functions}),
          blur_(scene.camera, scene.textures, scene.bokeh), starts_(scene), nearest_(scene.tolerance.hit)
    {
        for (const std::uint32_t interior : scene.camera_interiors) around_.append(interior);
    }

    /// A ray may start inside of something that has an interior.
    bool may_be_inside() const { return !around_.empty() || starts_.asked(); }
    double farthest() const { return rays_.max_distance() > 0.0 ? rays_.max_distance() : numbers::kInfinity; }

    /// False: there is no ray.
    bool begin(const PathSample& sample, Draws& draws, QueuedRay& out)
    {
        csg::Ray ray;
        if (blur_.active()) {
            if (!blur_.ray(rays_, {sample.x, sample.y}, one_of(blur_.most_samples(), draws), ray)) return false;
        } else if (!rays_.ray(sample.x, sample.y, ray,
                              rays_.rays_per_sample() > 1 ? one_of(rays_.rays_per_sample(), draws) : 0)) {
            return false;
        }
        out.state = RayState();
        out.state.ray = ray;
        out.state.start = nearest_;
        starts_.find(0, ray.origin);
        out.state.interiors = starts_.asked() ? starts_.lists()[0] : around_;
        out.level = 1;
        return true;
    }

private:
    static int one_of(int count, Draws& draws) { return std::min(static_cast<int>(draws.one() * count), count - 1); }

    CameraRays rays_;
    FocalBlur blur_;
    StartInteriors starts_;
    InteriorList around_;
    double nearest_;
};

}  // namespace trace::path
