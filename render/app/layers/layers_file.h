#pragma once

#include "render/app/run/run.h"
#include "render/layers/layers.h"
#include "render/scene/description.h"

#include <string>
#include <vector>

namespace app {

/// What --aov asks for, with what is known before a scene's description is gone.
struct LayersTask {
    std::vector<layers::Kind> kinds;  ///< empty: it was not given
    std::vector<std::string> names;   ///< of the objects, where they are asked for
};

/// Throws OptionError where the picture has no file to stand beside or does not fit the memory with its layers.
/// \param path of the picture
LayersTask layers_task(const Run& run, const scene::Description& scene, const std::string& path);

/// The rows of the layers that --aov asks for. Nothing: cancelled.
std::optional<image::Channels> make_layers(const Run& run, const LayersTask& task, const plan::CompiledScene& scene,
                                           const trace::RenderOptions& options, layers::Rows rows);

/// Where the layers of a picture go.
std::string layers_path(const std::string& picture);

/// Writes PICTURE.layers.exr beside the picture. False: cancelled.
bool write_layers(Run& run, const LayersTask& task, const plan::CompiledScene& scene, const image::Image& picture,
                  const image::FileSettings& file, const std::string& path, const trace::RenderOptions& options);

}  // namespace app
