#include "render/app/layers/layers_file.h"

#include "render/app/run/memory.h"
#include "render/app/run/scene_file.h"
#include "render/image/codecs/write/row_sink.h"
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
    if (settings.shards > 0 && std::find(task.kinds.begin(), task.kinds.end(), layers::Kind::Time) != task.kinds.end())
        throw OptionError("the layer time is that of one run: a part has none, name the other layers");
    if (path.empty() || !settings.output_to_file)
        throw OptionError("--aov writes a file beside the picture's, and the picture has none");
    const double bytes = kBytesPerPixel * settings.width * settings.height;
    if (!has_memory_for(settings, bytes))
        throw OptionError("not enough memory is free for the layers of so large a picture");
    const auto text_of = [&run](const std::string& file) {
        return run.input ? *run.input : text_on_disk(file).value_or("");
    };
    if (std::find(task.kinds.begin(), task.kinds.end(), layers::Kind::Object) != task.kinds.end())
        task.names = layers::object_names(scene, text_of);
    return task;
}

std::optional<image::Channels> make_layers(const Run& run, const LayersTask& task, const plan::CompiledScene& scene,
                                           const trace::RenderOptions& options, layers::Rows rows)
{
    const bool many = scene.options.antialiasing.method != 0 || run.settings.sampled();
    return layers::make_layers(scene, task.kinds, task.names, options, many, rows);
}

std::string layers_path(const std::string& picture)
{
    return std::filesystem::path(picture).replace_extension(".layers.exr").string();
}

bool write_layers(Run& run, const LayersTask& task, const plan::CompiledScene& scene, const image::Image& picture,
                  const image::FileSettings& file, const std::string& path, const trace::RenderOptions& options)
{
    auto channels = make_layers(run, task, scene, options, {0, run.settings.height});
    if (!channels) return false;
    layers::add_picture(*channels, picture, file.encoding.curves.working);
    channels->attributes.emplace_back(image::kFingerprintKey, file.fingerprint);
    run.files.write_channels(layers_path(path), *channels);
    run.reporter.note("layers: " + layers_path(path));
    return true;
}

}  // namespace app
