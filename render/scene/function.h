#pragma once

#include "function/program.h"
#include "render/scene/textures/texture.h"

/// Functions that evaluate something of the scene: `function { pattern { } }`, `function { pigment { } }`.
namespace scene {

struct PatternFunction final : function::External {
    explicit PatternFunction(Pattern p) : pattern(std::move(p)) {}
    Pattern pattern;
};

struct PigmentFunction final : function::External {
    explicit PigmentFunction(Pigment p) : pigment(std::move(p)) {}
    Pigment pigment;
};

}  // namespace scene
