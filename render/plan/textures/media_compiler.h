#pragma once

#include "render/plan/quality.h"
#include "render/plan/media.h"
#include "render/plan/textures/textures.h"

#include <memory>
#include <unordered_map>

namespace plan {

/// Compiles the media of interiors and of the whole scene, shared ones once. Whatever is black in every way is left
/// out.
class MediaCompiler {
public:
    /// quality: without effects nothing fills space. drop_black: what neither glows nor dims is left out.
    MediaCompiler(TextureCompiler& textures, const Quality& quality, bool drop_black, scene::PovRay povray,
                  MediaSet& out)
        : textures_(textures), drawn_(quality.effects), drop_black_(drop_black), povray_(povray), out_(out)
    {}

    MediaList list(const std::vector<std::shared_ptr<const scene::Media>>& media);
    /// Statements left out as all of their media are black.
    std::uint64_t dropped() const { return dropped_; }

private:
    std::uint32_t medium(const std::shared_ptr<const scene::Media>& media);

    TextureCompiler& textures_;
    bool drawn_, drop_black_;
    scene::PovRay povray_;
    std::uint64_t dropped_ = 0;
    MediaSet& out_;
    std::unordered_map<std::shared_ptr<const scene::Media>, std::uint32_t> known_;
};

/// Whether the place matters for some density.
bool depends_on_place(const scene::Media& media);

}  // namespace plan
