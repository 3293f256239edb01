#include "csg/world/inside_index.h"
#include "numbers/functions/functions.h"
#include "numbers/remainder.h"
#include "render/texture/points/angle.h"
#include "render/texture/evaluate.h"
#include "render/texture/function_host.h"
#include "render/texture/patterns/patterns.h"
#include "render/texture/patterns/turning.h"

#include <cmath>

namespace texture {
namespace {

/// fmod(v, kModulus), which is exact: a difference is too as long as it is below the modulus.
double folded(double v)
{
    const double size = std::abs(v);
    if (size < kModulus) return v;
    return size < 2.0 * kModulus ? std::copysign(size - kModulus, v) : numbers::fmod(v, kModulus);
}

double wave(const Pattern& pattern, double v)
{
    switch (pattern.wave) {
    case scene::WaveForm::Ramp:
    case scene::WaveForm::Raw: return v;
    case scene::WaveForm::Sine: return (1.0 + cycle(v)) / 2.0;
    case scene::WaveForm::Triangle: return triangle(v);
    case scene::WaveForm::Scallop: return std::abs(cycle(v / 2.0));
    case scene::WaveForm::Cubic: return v * v * (3.0 - 2.0 * v);
    case scene::WaveForm::Poly: return pattern.poly_exponent == 2.0 ? v * v : numbers::pow(v, pattern.poly_exponent);
    }
    return v;
}

double grey_of(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p, const Surroundings& around)
{
    return static_cast<double>(scene::grey(pigment_color(set, pattern.pigment, p, around).rgb()));
}

double function_value(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p)
{
    const double at[] = {p.x, p.y, p.z};
    return wrapped_value(function::evaluate(*set.functions[pattern.function], at, FunctionHost(set)));
}

}  // namespace

double raw_pattern(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p, const Surroundings& around)
{
    switch (pattern.kind) {
    case PatternKind::Average:
    case PatternKind::UserDefined:
    case PatternKind::Uv:
    case PatternKind::Facets: return 0.0;  // not functions of a point: whoever holds the map handles them
#define PATTERN(keyword, enumerator, value)                                                                            \
    case PatternKind::enumerator:                                                                                      \
        return value;
#include "render/texture/pattern_table.inc"
#undef PATTERN
    }
    return 0.0;
}

double waved(const Pattern& pattern, double raw)
{
    if (pattern.wave == scene::WaveForm::Raw) return raw;
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
