#include "render/explain/pixel.h"

#include "render/kernel/camera/camera_rays.h"
#include "render/kernel/gather/indirect_light.h"

namespace explain {

Pixel explain_pixel(const scene::Description& description, plan::CompiledScene& scene,
                    const trace::RenderOptions& options, int x, int y)
{
    Pixel out;
    out.x = x;
    out.y = y;
    out.width = scene.options.width;
    out.height = scene.options.height;
    plan::Options& o = scene.options;
    o.antialiasing.method = 0;
    o.start_column = o.end_column = x;
    o.start_row = o.end_row = y;
    image::Image picture{o.width, o.height, {}, 0};
    picture.hold(y, 1);
    trace::render(scene, options, picture);
    const float* rgb = picture.at(x, y);
    out.rendered = {rgb[0], rgb[1], rgb[2]};

    const trace::CameraRays rays(scene.camera, o.width, o.height,
                                 {scene.mesh_camera.get(), &scene.textures, scene.camera_normal});
    RayTree tree(description, scene);
    out.left_out = tree.left_out();
    csg::Ray ray;
    if (rays.ray(x, y, ray)) out.tree = tree.explain(ray);
    return out;
}

}  // namespace explain
