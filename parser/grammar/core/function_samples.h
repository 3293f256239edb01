#pragma once

#include "parser/grammar/core/scene_builder.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace parser {

/// 1 for a function of one component, 4 for a pigment's (red, green, blue, opacity).
std::size_t sampled_channels(const function::Function& called);

/// A function over the unit square as the 16-bit picture that POV-Ray makes of it (spec 4, 12.6; 5b, 10.1), row by row
/// from y = 0: numbers wrap round, colours are cut off. Nothing if the function asks the scene and nobody answers.
/// columns, rows >= 1.
std::optional<std::vector<std::uint16_t>> sampled_levels(SceneBuilder& build, const function::FunctionPtr& called,
                                                         std::uint32_t columns, std::uint32_t rows);

}  // namespace parser
