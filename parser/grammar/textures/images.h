#pragma once

#include "parser/grammar/core/rules.h"
#include "render/scene/textures/image_map.h"

/// Blocks that name a picture, a volume or an object that a pattern looks its values up in. The keyword has been taken.
namespace parser {

/// What stands first in an image's block: a kind and a file that must exist, a file whose name tells its kind, or
/// `function w, h { }`. The picture itself is not read.
scene::ImageSource read_image_source(SceneBuilder& build);
Form image_source_form();
using file_curve = pegtl::sor<any_token<Kind::Srgb, Kind::Bt709, Kind::Bt2020>, a_number>;
template <>
inline constexpr auto expected<file_curve> = "a number";
/// `gamma` with a number or a curve's name, of a state that has an image's source.
struct image_gamma : item<Kind::Gamma, file_curve> {
    template <class State>
    static void act(State& s)
    {
        scene::FileGamma& gamma = s.part(static_cast<scene::ImageSource*>(nullptr)).gamma.emplace();
        if (s.operands() != 0) {
            gamma.exponent = s.pop_float();
            return;
        }
        using Curve = scene::FileGamma::Kind;
        const Kind name = s.stream().taken_last().kind;
        gamma.kind = name == Kind::Srgb ? Curve::Srgb : name == Kind::Bt709 ? Curve::Bt709 : Curve::Bt2020;
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
