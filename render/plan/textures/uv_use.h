#pragma once

#include "render/scene/textures/texture.h"

#include <unordered_map>

namespace plan {

/// Which textures look at uv coordinates.
class UvUse {
public:
    bool of(const scene::TexturePtr& texture) { return texture && uses(*texture); }

private:
    bool uses(const scene::Pattern& pattern);
    bool uses(const scene::Pigment& pigment);
    bool uses(const scene::Normal& normal);
    bool uses(const scene::Texture& texture);
    /// Of what is inside of something, found once: declared textures share it, at every depth.
    template <class Part>
    bool inside(const std::shared_ptr<const Part>& part);
    template <class Entries>
    bool any_inside(const Entries& entries);

    std::unordered_map<const void*, bool> known_;  ///< of parts, which the description keeps
};

}  // namespace plan
