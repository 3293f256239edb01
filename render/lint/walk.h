#pragma once

#include "render/scene/description.h"

#include <functional>

namespace lint {

/// An object of the scene, whole or an operand.
struct Visited {
    const scene::Object& object;
    const scene::Object& top;  ///< that it is a part of
    const csg::Transform& parent_to_world;
    const scene::Texture* texture;  ///< its own or its parents'; null: the default one
    bool takes_cut_texture =
        false;  ///< stands below `cutaway_textures`: without a texture it shows that of what it cuts
};

/// Calls for each object, parents first. A shared list of operands is visited where it stands first only. At most half
/// a million objects.
void walk(const scene::Description& description, const std::function<void(const Visited&)>& visit);

/// Whether light passes through some of it.
bool lets_light_through(const scene::Texture& texture);

/// Whether it shines without a light.
bool glows(const scene::Texture& texture);

/// A word for messages: "sphere".
std::string_view name_of(const scene::Object& object);

}  // namespace lint
