#include "render/texture/function_host.h"

#include "render/texture/noise.h"

namespace texture {

double FunctionHost::noise(const glm::dvec3& p, int generator) const
{
    return texture::noise(p, generator == 0 ? set_.noise_generator : generator);
}

double FunctionHost::pattern(std::uint32_t slot, const glm::dvec3& p) const
{
    const Pattern& pattern = set_.patterns[slot];
    return pattern_value(set_, pattern, warp_point(set_, pattern, p), {});
}

std::array<double, 5> FunctionHost::pigment(std::uint32_t slot, const glm::dvec3& p) const
{
    const scene::Color c = pigment_color(set_, slot, p, {});
    return {static_cast<double>(c.red), static_cast<double>(c.green), static_cast<double>(c.blue), static_cast<double>(c.filter),
            static_cast<double>(c.transmit)};
}

}  // namespace texture
