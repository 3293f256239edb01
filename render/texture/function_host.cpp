#include "render/texture/function_host.h"

#include "function/evaluate.h"
#include "function/intervals/interval.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/noise_points.h"

#include <algorithm>

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
    return {static_cast<double>(c.red), static_cast<double>(c.green), static_cast<double>(c.blue),
            static_cast<double>(c.filter), static_cast<double>(c.transmit)};
}

void FunctionHost::noises(const double* x, const double* y, const double* z, int generator, double* out) const
{
    Points points;
    points.count = function::kLanes;
    std::copy_n(x, function::kLanes, points.x.data());
    std::copy_n(y, function::kLanes, points.y.data());
    std::copy_n(z, function::kLanes, points.z.data());
    Values values;
    noise_points(points, generator == 0 ? set_.noise_generator : generator, values);
    std::copy_n(values.data(), function::kLanes, out);
}

namespace {

/// f with a host of this build in the place of the given one, if that has a texture set.
template <class F>
auto here(const function::Host& host, F&& f)
{
    if (const void* set = host.texture_set()) return f(FunctionHost(*static_cast<const TextureSet*>(set)));
    return f(host);
}

}  // namespace

function::Evaluators evaluators()
{
    using function::Function;
    using function::Host;
    return {[](const Function& called, const double* a, const Host& host) {
                return here(host, [&](const Host& own) { return function::evaluate(called, a, own); });
            },
            [](const Function& called, const double* a, const Host& host) {
                return here(host, [&](const Host& own) { return function::evaluate_all(called, a, own); });
            },
            [](const Function& called, const double(*a)[8], const Host& host, double* out) {
                here(host, [&](const Host& own) { function::evaluate_lanes(called, a, own, out); });
            },
            function::evaluate_intervals};  // which ask nothing of the scene
}

}  // namespace texture
