#pragma once

#include "function/points/evaluate.h"
#include "function/field/field.h"
#include "render/texture/evaluate.h"

namespace texture {

/// What functions ask of the scene, answered from the texture set. Slots are indices of its patterns and pigments.
class FunctionHost final : public function::Host {
public:
    explicit FunctionHost(const TextureSet& set) : set_(set) {}

    double noise(const glm::dvec3& p, int generator) const override;
    double pattern(std::uint32_t slot, const glm::dvec3& p) const override;
    std::array<double, 5> pigment(std::uint32_t slot, const glm::dvec3& p) const override;
    void noises(const double* x, const double* y, const double* z, int generator, double* out) const override;
    void patterns(std::uint32_t slot, const double* x, const double* y, const double* z, std::size_t count,
                  double* out) const override;
    void pigments(std::uint32_t slot, const double* x, const double* y, const double* z, std::size_t count,
                  const std::array<double*, 5>& out) const override;
    const void* texture_set() const override { return &set_; }

private:
    const TextureSet& set_;
};

/// Functions by this build of function/ and render/texture, whoever made the host.
function::Evaluators evaluators();

}  // namespace texture
