#pragma once

#include "parser/grammar/core/values.h"
#include "render/scene/effects.h"
#include "render/scene/media.h"
#include "render/scene/mesh_camera.h"
#include "render/scene/rainbow.h"

/// Blocks of light that is not direct, of what fills space, and of what a camera may hold. Each function begins at the
/// opening brace, the keyword being taken, and fails with a located message (parser::Error).
namespace parser {

class SceneBuilder;

scene::Media read_media(SceneBuilder& build);
scene::Density read_density(SceneBuilder& build);
scene::Rainbow read_rainbow(SceneBuilder& build);
scene::RadiositySettings read_global_radiosity(SceneBuilder& build);
/// What the block leaves out gets its default, but radii in media stay those of `before` (spec 6, 3.1).
scene::PhotonSettings read_global_photons(SceneBuilder& build, const scene::PhotonSettings& before);
scene::SubsurfaceSettings read_global_subsurface(SceneBuilder& build);
/// `before`: what the object has already, null: nothing; items change it.
std::shared_ptr<const scene::PhotonFlags> read_photon_flags(SceneBuilder& build, bool of_light,
                                                            const scene::PhotonFlags* before);
/// The importance of an object, above 0 to 1; nothing: not written.
std::optional<double> read_object_radiosity(SceneBuilder& build);
std::shared_ptr<const scene::Subsurface> read_finish_subsurface(SceneBuilder& build);
std::shared_ptr<const scene::MeshCamera> read_mesh_camera(SceneBuilder& build);
scene::Bokeh read_bokeh(SceneBuilder& build);

}  // namespace parser
