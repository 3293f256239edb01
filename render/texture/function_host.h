#pragma once

#include "function/evaluate.h"
#include "render/texture/evaluate.h"

namespace texture {

/// What functions ask of the scene, answered from the texture set. Slots are indices of its patterns and pigments.
class FunctionHost final : public function::Host {
public:
    explicit FunctionHost(const TextureSet& set) : set_(set) {}

    double noise(const glm::dvec3& p, int generator) const override;
    double pattern(std::uint32_t slot, const glm::dvec3& p) const override;
    std::array<double, 5> pigment(std::uint32_t slot, const glm::dvec3& p) const override;

private:
    const TextureSet& set_;
};

}  // namespace texture
