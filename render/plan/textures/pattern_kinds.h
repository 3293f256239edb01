#pragma once

#include "render/scene/base/povray.h"
#include "render/scene/textures/texture.h"
#include "render/texture/texture_set.h"

#include <optional>

namespace plan {

/// The pattern of a keyword, or nothing if it is not rendered yet.
std::optional<texture::PatternKind> pattern_kind(const std::string& keyword);

/// Modifiers and parameters in the precision that POV-Ray keeps them in (spec 4, 1.2). Warps are appended to `warps`.
/// `scene_generator` stands in for a pattern without its own; povray: whose rules it follows.
texture::Pattern compile_pattern(const scene::Pattern& description, const csg::Transform* by, texture::PatternKind kind,
                                 int scene_generator, scene::PovRay povray, std::vector<texture::Warp>& warps);
/// Its warps alone, for a pattern that is otherwise compiled.
void compile_warps(const scene::Pattern& description, const csg::Transform* by, texture::Pattern& out,
                   std::vector<texture::Warp>& warps);

}  // namespace plan
