#include "python/binding/scene_bodies.h"

#include "function/field/field.h"
#include "render/app/run/stage_options.h"
#include "render/layers/object_names.h"
#include "render/picture/kernel_module.h"

#include <fmt/format.h>

namespace python {

SceneBodies::SceneBodies(Source& source, const Asked& asked, const std::atomic<bool>& cancel)
    : settings_(settings_of(asked.words)), kernel_(trace::load_kernel(app::isa_of(settings_))),
      read_(source.read(settings_, cancel))
{
    function::use(kernel_.evaluators);
    const scene::Description& scene = read_->scene;
    const std::vector<std::string> names =
        layers::object_names(scene, [&](const std::string& file) { return source.text_of(file); });
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        if (!scene::is_light(scene.objects[i]) && (asked.object.empty() || names[i] == asked.object))
            objects_.push_back({names[i], &scene.objects[i]});
    if (objects_.empty() && !asked.object.empty())
        throw app::OptionError(
            fmt::format("the scene has no object '{}'; it has {}", asked.object, fmt::join(names, ", ")));
}

}  // namespace python
