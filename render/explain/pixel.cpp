#include "render/explain/pixel.h"

#include "render/picture/kernel_module.h"
#include "render/picture/passes/passes.h"

namespace explain {
namespace {

scene::Color through_air(const trace::RecordedRay& ray, const scene::Color& color)
{
    return ray.air.empty() ? color : ray.air.back().so_far(color);
}

/// Rows `first` to `last` as the viewer sees them.
glm::vec3 seen_light(const trace::RecordedRay& ray, std::size_t first, std::size_t last)
{
    glm::vec3 sum(0);
    for (std::size_t i = first; i < last; ++i) sum += ray.rows[i].filter * light_of(ray.rows[i]);
    return sum;
}

/// Colours of all rays from the shares of their layers, put together by the rule of the kernel's queue.
std::vector<scene::Color> add_up(const trace::Record& record)
{
    trace::RayQueue queue;
    queue.colors.resize(record.slots);
    for (const trace::RecordedRay& ray : record.rays) {
        scene::Color color;
        if (ray.ends) color = ray.met.found() ? scene::Color::of(seen_light(ray, 0, ray.rows.size())) : ray.seen;
        queue.colors[ray.slot] = through_air(ray, color);
    }
    queue.begin_tile();
    queue.nodes = record.nodes;
    queue.terms = record.terms;
    for (std::size_t i = 0; i < record.nodes.size(); ++i) {
        const trace::RecordedOwner& owner = record.owners[i];
        if (owner.last > owner.first) queue.nodes[i].own = seen_light(record.rays[owner.ray], owner.first, owner.last);
    }
    queue.fold();
    return queue.colors;
}

/// The mean of the camera's rays, as samples of a lens are summed.
glm::vec3 mean_of(const trace::Record& record, const std::vector<scene::Color>& colors)
{
    if (record.camera.empty()) return glm::vec3(0);
    if (record.camera.size() == 1 && record.without_ray == 0) return colors[record.camera.front()].rgb();
    glm::vec3 sum(0);
    for (const trace::ColorSlot slot : record.camera) sum += colors[slot].rgb();
    return sum / static_cast<float>(record.camera.size() + static_cast<std::size_t>(record.without_ray));
}

}  // namespace

glm::vec3 light_of(const trace::RecordedRow& row)
{
    glm::dvec3 gained(0);
    for (const trace::RecordedGain& gain : row.gains) gained += gain.sum;
    return row.glow + glm::vec3(gained);
}

Pixel explain_pixel(plan::CompiledScene& scene, const trace::RenderOptions& asked, int x, int y)
{
    Pixel out;
    out.x = x;
    out.y = y;
    scene.options.antialiasing.method = 0;
    trace::RenderOptions options = asked;
    std::shared_ptr<const trace::IndirectLight> light;
    if (options.indirect == nullptr) {
        light = trace::run_passes(scene, options);
        options.indirect = light.get();
    }
    const trace::KernelTable& kernel = trace::load_kernel(options.isa);
    function::use(kernel.evaluators);
    const std::unique_ptr<trace::BlockTracer, void (*)(trace::BlockTracer*)> tracer(
        kernel.make(scene, options.indirect, options.cancel), kernel.free);
    kernel.record(*tracer, &out.record);
    scene::Color color;
    const bool done = kernel.trace(*tracer, {x, y, 1, 1}, &color);
    kernel.record(*tracer, nullptr);
    if (!done) return out;
    out.rendered = color.rgb();
    out.colors = add_up(out.record);
    out.sum = mean_of(out.record, out.colors);
    return out;
}

}  // namespace explain
