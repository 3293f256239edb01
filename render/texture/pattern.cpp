#include "render/texture/angle.h"
#include "render/texture/evaluate.h"
#include "render/texture/function_host.h"
#include "render/texture/patterns/patterns.h"

#include <cmath>

namespace texture {
namespace {

/// fmod(v, kModulus), which is exact: a difference is too as long as it is below the modulus.
double folded(double v)
{
    const double size = std::abs(v);
    if (size < kModulus) return v;
    return size < 2.0 * kModulus ? std::copysign(size - kModulus, v) : std::fmod(v, kModulus);
}

double wave(const Pattern& pattern, double v)
{
    switch (pattern.wave) {
    case scene::WaveForm::Ramp: return v;
    case scene::WaveForm::Sine: return (1.0 + cycle(v)) / 2.0;
    case scene::WaveForm::Triangle: return triangle(v);
    case scene::WaveForm::Scallop: return std::abs(cycle(v / 2.0));
    case scene::WaveForm::Cubic: return v * v * (3.0 - 2.0 * v);
    case scene::WaveForm::Poly: return std::pow(v, pattern.poly_exponent);
    }
    return v;
}

double grey_of(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p, const Surroundings& around)
{
    return static_cast<double>(scene::grey(pigment_color(set, pattern.pigment, p, around).rgb()));
}

/// A user function; what is above 1 counts from 0 again (spec 4, 5.2).
double function_value(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p)
{
    const double at[] = {p.x, p.y, p.z};
    const double v = function::evaluate(*set.functions[pattern.function], at, FunctionHost(set));
    return v > 1.0 ? std::fmod(v, 1.0) : v;
}

}  // namespace

double raw_pattern(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p, const Surroundings& around)
{
    switch (pattern.kind) {
    case PatternKind::Average:
    case PatternKind::Uv:
    case PatternKind::Facets: return 0.0;  // not functions of a point: whoever holds the map handles them
    case PatternKind::Agate: return agate(pattern, p);
    case PatternKind::Aoi: return aoi(around);
    case PatternKind::Boxed: return boxed(p);
    case PatternKind::Bozo:
    case PatternKind::Bumps: return bozo(pattern, p);
    case PatternKind::Brick: return brick(pattern, p);
    case PatternKind::Cells: return cells(p);
    case PatternKind::Checker: return checker(p);
    case PatternKind::Crackle: return crackle(pattern, p);
    case PatternKind::Cubic: return cubic(p);
    case PatternKind::Cylindrical: return cylindrical(p);
    case PatternKind::Dents: return dents(pattern, p);
    case PatternKind::DensityFile: return density(pattern, *set.volumes[pattern.data], p);
    case PatternKind::Function: return function_value(set, pattern, p);
    case PatternKind::Gradient: return gradient(pattern, p);
    case PatternKind::Granite: return granite(pattern, p);
    case PatternKind::Hexagon: return hexagon(p);
    case PatternKind::Image: return image_value(set.images[pattern.data], p);
    case PatternKind::Julia: return julia(pattern, p);
    case PatternKind::Leopard: return leopard(p);
    case PatternKind::MagnetJulia: return magnet_julia(pattern, p);
    case PatternKind::MagnetMandel: return magnet_mandel(pattern, p);
    case PatternKind::Mandel: return mandel(pattern, p);
    case PatternKind::Marble: return marble(pattern, p);
    case PatternKind::Object: return set.objects[pattern.data]->holds(p) ? 1.0 : 0.0;
    case PatternKind::Onion: return onion(p);
    case PatternKind::Pavement: return pavement(pattern, p);
    case PatternKind::PigmentPattern: return grey_of(set, pattern, p, around);
    case PatternKind::Planar: return planar(p);
    case PatternKind::Quilted: return quilted(pattern, p);
    case PatternKind::Radial: return radial(p);
    case PatternKind::Ripples: return ripples(set, pattern, p);
    case PatternKind::Slope: return slope(pattern, p, around);
    case PatternKind::Spherical: return spherical(p);
    case PatternKind::Spiral1: return spiral1(pattern, p);
    case PatternKind::Spiral2: return spiral2(pattern, p);
    case PatternKind::Square: return square(p);
    case PatternKind::Tiling: return tiling(pattern, p);
    case PatternKind::Triangular: return triangular(p);
    case PatternKind::Waves: return waves(set, pattern, p);
    case PatternKind::Wood: return wood(pattern, p);
    case PatternKind::Wrinkles: return wrinkles(pattern, p);
    }
    return 0.0;
}

double waved(const Pattern& pattern, double raw)
{
    double v = raw;
    if (pattern.folds) v = folded(v * pattern.frequency + pattern.phase);
    if (v < 0.0) v -= std::floor(v);
    return wave(pattern, v);
}

double pattern_value(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p, const Surroundings& around)
{
    return waved(pattern, raw_pattern(set, pattern, p, around));
}

}  // namespace texture
