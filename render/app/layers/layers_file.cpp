#include "render/app/layers/layers_file.h"

#include "render/app/run/memory.h"
#include "render/app/run/scene_file.h"
#include "render/layers/object_names.h"

#include <algorithm>
#include <filesystem>

namespace app {
namespace {

constexpr double kBytesPerPixel = 2 * 4 * 32.0;  // of all channels, twice while the colours are added

}  // namespace

LayersTask layers_task(const Run& run, const scene::Description& scene, const std::string& path)
{
    const Settings& settings = run.settings;
    LayersTask task;
    if (settings.layers.empty()) return task;
    task.kinds = layers::kinds_of(settings.layers);
    if (path.empty() || !settings.output_to_file)
        throw OptionError("--aov writes a file beside the picture's, and the picture has none");
    if (kBytesPerPixel * settings.width * settings.height > picture_memory(settings))
        throw OptionError("not enough memory is free for the layers of so large a picture");
    const auto text_of = [&run](const std::string& file) {
        return run.input ? *run.input : text_on_disk(file).value_or("");
    };
    if (std::find(task.kinds.begin(), task.kinds.end(), layers::Kind::Object) != task.kinds.end())
        task.names = layers::object_names(scene, text_of);
    return task;
}

bool write_layers(Run& run, const LayersTask& task, const plan::CompiledScene& scene, const image::Image& picture,
                  const image::FileSettings& file, const std::string& path, const trace::RenderOptions& options)
{
    const Settings& settings = run.settings;
    const bool many = scene.options.antialiasing.method != 0 || settings.sampled();
    auto channels = layers::make_layers(scene, task.kinds, task.names, options, many);
    if (!channels) return false;
    layers::add_picture(*channels, picture, file.encoding.curves.working);
    std::filesystem::path beside(path);
    beside.replace_extension(".layers.exr");
    run.files.write_channels(beside.string(), *channels);
    run.reporter.note("layers: " + beside.string());
    return true;
}

}  // namespace app
