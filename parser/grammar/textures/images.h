#pragma once

#include "parser/grammar/core/rules.h"
#include "render/scene/textures/image_map.h"

/// Blocks that name a picture, a volume or an object that a pattern looks its values up in. The keyword has been taken.
namespace parser {

/// What stands first in an image's block: a kind and a file that must exist, a file whose name tells its kind, or
/// `function w, h { }`. The picture itself is not read.
scene::ImageSource read_image_source(SceneBuilder& build);
Form image_source_form();
/// `gamma` with a number or a curve's name, of a state that has an image's source.
struct image_gamma : item<Kind::Gamma, gamma_curve> {
    template <class State>
    static void act(State& s)
    {
        s.part(static_cast<scene::ImageSource*>(nullptr)).gamma = s.pop_curve();
    }
};
/// image_map, bump_map, image_pattern: the whole block. `colors`: filter and transmit may stand in it.
std::shared_ptr<const scene::ImageMap> read_image_block(SceneBuilder& build, bool colors);
/// `materials`: its textures.
std::shared_ptr<const scene::ImageMap> read_material_map(SceneBuilder& build, TextureMap& materials);
std::shared_ptr<const scene::DensityFile> read_density_file(SceneBuilder& build);
/// Stops before what the object's outside and inside have; close_list() takes the brace behind that.
std::shared_ptr<const scene::Object> read_object_pattern(SceneBuilder& build);
/// `potential`: the whole block.
std::shared_ptr<const scene::Object> read_potential(SceneBuilder& build);

}  // namespace parser
