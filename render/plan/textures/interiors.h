#pragma once

#include "render/plan/interior.h"
#include "render/plan/textures/media_compiler.h"
#include "render/scene/object.h"

#include <memory>
#include <vector>

namespace plan {

/// Whether the top finish of a texture changes the interior by old keywords (spec 3, 8.7).
bool has_old_finish(const scene::Texture* texture);

/// Hands out one index per copy of an interior of the text.
class InteriorCompiler {
public:
    InteriorCompiler(std::vector<Interior>& out, MediaCompiler& media) : out_(out), media_(media) {}

    std::uint32_t interior(const scene::Interior& description, std::uint32_t copy);
    /// A new one, of a statement without an interior in the text.
    std::uint32_t automatic();
    /// Changes an interior to what the top finish of an object's texture says with old keywords (spec 3, 8.7).
    void take_finish(std::uint32_t index, const scene::Texture* texture);

private:
    static constexpr std::uint32_t kUnknown = 0xffffffffu;
    std::vector<Interior>& out_;
    MediaCompiler& media_;
    std::vector<std::uint32_t> known_;  ///< by copy
};

}  // namespace plan
