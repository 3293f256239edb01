#pragma once

#include "render/kernel/context/context.h"

/// Rows that go through the lights one by one (defined in shade_light.cpp).
namespace trace {

/// Light of a row of DirectBatch whose lights are looked up one by one (spec 3, 7.4). grains: numbers of `crand` asked
/// for so far.
struct ScalarRow {
    const HitPlace& hit;
    const texture::Finish& finish;
    const scene::Color& pigment;
    const glm::dvec3& normal;
    double alpha;
    const LightSample* samples;  ///< by light
    std::uint32_t& grains;
};

/// Sum over the lights for one row (spec 3, 7.4).
glm::vec3 direct_light(Context& context, const ScalarRow& row);

/// Iridescence of light from `l` (spec 3, 7.11).
glm::vec3 film_color(const Context& context, const HitPlace& hit, const texture::Finish& finish,
                     const glm::dvec3& normal, const glm::dvec3& l);

}  // namespace trace
