#pragma once

#include "render/plan/textures/interior.h"
#include "render/plan/textures/media_compiler.h"
#include "render/scene/object.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace plan {

/// Hands out one index per interior of the text: equal pointers share, a null pointer makes a new default interior.
class InteriorCompiler {
public:
    InteriorCompiler(std::vector<Interior>& out, MediaCompiler& media) : out_(out), media_(media) {}

    /// `texture` is the object's own: its top finish may carry the legacy `ior` and `caustics` (spec 3, 8.7).
    std::uint32_t interior(const std::shared_ptr<const scene::Interior>& description, const scene::Texture* texture);

private:
    std::vector<Interior>& out_;
    MediaCompiler& media_;
    std::unordered_map<const scene::Interior*, std::uint32_t> known_;
};

}  // namespace plan
