#include "render/texture/noise/noise.h"
#include "render/trace/air/even_fog.h"
#include "render/trace/shade/shade_context.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

/// Mean density of ground fog along a segment between two heights (spec 2, 16.2).
double mean_density(double a, double b)
{
    if (a <= 0.0 && b <= 0.0) return 1.0;
    if (a <= 0.0) return (std::atan(b) - a) / (b - a);
    if (b <= 0.0) return (std::atan(a) - b) / (a - b);
    return std::abs(a - b) <= kNearlyZero ? 1.0 / (1.0 + a * a) : (std::atan(a) - std::atan(b)) / (a - b);
}

constexpr double kUnseen = 0x1p-55;  // less than half of the last bit of 1

/// What the turbulence of a fog, times its depth, does not exceed: no octave has more than 1.5.
double most_turbulence(const texture::Fog& fog)
{
    double sum = 0.0, share = 1.5;
    for (int k = 0; k < fog.turbulence.octaves; ++k, share *= std::abs(fog.turbulence.omega)) sum += share;
    return std::max(1.0, std::abs(fog.turb_depth) * sum);
}

double fog_transmission(const Context& context, const texture::Fog& fog, const csg::Ray& ray, double length)
{
    if (even(fog)) return trace::fog_transmission(fog, length);
    double effective = length;
    // Far behind the fog's distance no noise is large enough to change 1.
    if (const double near = fog.turbulent ? std::exp(-length / fog.distance) : 0.0;
        near * most_turbulence(fog) > kUnseen) {
        const glm::dvec3 p = ray.at(length / 2.0) * fog.turbulence.amount;
        const double n = texture::scalar_turbulence(p, fog.turbulence.octaves, fog.turbulence.lambda,
                                                    fog.turbulence.omega, context.scene.textures.noise_generator);
        effective = length * (1.0 - near * std::min(1.0, fog.turb_depth * n));
    }
    double density = 1.0;
    if (fog.ground) {
        const double a = (glm::dot(ray.origin, fog.up) - fog.offset) / fog.altitude;
        const double b = (glm::dot(ray.at(length), fog.up) - fog.offset) / fog.altitude;
        density = mean_density(a, b);
    }
    return std::max(std::exp(-effective * density / fog.distance), static_cast<double>(fog.color.transmit));
}

}  // namespace

glm::vec3 fog_share(const Context& context, const csg::Ray& ray, double length)
{
    glm::vec3 share(1);
    for (const texture::Fog& fog : context.scene.fogs)
        share *= static_cast<float>(fog_transmission(context, fog, ray, length)) *
                 ((1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb());
    return share;
}

Air fog_air(const Context& context, const csg::Ray& ray, double length)
{
    Air air;
    for (const texture::Fog& fog : context.scene.fogs) {
        const auto a = static_cast<float>(fog_transmission(context, fog, ray, length));
        air.glow += (1.0f - a) * fog.color.rgb();
        air.share *= a * ((1.0f - fog.color.filter) + fog.color.filter * fog.color.rgb());
    }
    air.clear = scene::grey(air.share);
    return air;
}

}  // namespace trace
