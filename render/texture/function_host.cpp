#include "render/texture/function_host.h"

#include "function/points/evaluate.h"
#include "function/intervals/interval.h"
#include "function/line/along_line.h"
#include "render/texture/evaluate_points.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/noise_points.h"

#include <algorithm>

namespace texture {
namespace {

void put_eight(const double* x, const double* y, const double* z, Points& out)
{
    out.count = function::kLanes;
    std::copy_n(x, function::kLanes, out.x.data());
    std::copy_n(y, function::kLanes, out.y.data());
    std::copy_n(z, function::kLanes, out.z.data());
}

/// Of points that are on no surface.
const Around& nowhere()
{
    static const Surroundings none;
    static const Around all = [] {
        Around around;
        around.fill(&none);
        return around;
    }();
    return all;
}

}  // namespace

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
    noise_eight(x, y, z, generator == 0 ? set_.noise_generator : generator, out);
}

void FunctionHost::patterns(std::uint32_t slot, const double* x, const double* y, const double* z, double* out) const
{
    const Pattern& pattern = set_.patterns[slot];
    Points points;
    put_eight(x, y, z, points);
    warp_points(set_, pattern, points, kAllLive);
    Values values;
    pattern_values(set_, pattern, points, nowhere(), values);
    std::copy_n(values.data(), function::kLanes, out);
}

void FunctionHost::pigments(std::uint32_t slot, const double* x, const double* y, const double* z,
                            const std::array<double*, 5>& out) const
{
    Points points;
    put_eight(x, y, z, points);
    ColorPoints colors;
    pigment_colors(set_, slot, points, nowhere(), colors);
    for (std::size_t i = 0; i < function::kLanes; ++i) {
        out[0][i] = static_cast<double>(colors.red[i]);
        out[1][i] = static_cast<double>(colors.green[i]);
        out[2][i] = static_cast<double>(colors.blue[i]);
        out[3][i] = static_cast<double>(colors.filter[i]);
        out[4][i] = static_cast<double>(colors.transmit[i]);
    }
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
            [](const Function& called, const double(*a)[8], const Host& host, std::uint32_t components, double* out) {
                here(host, [&](const Host& own) { function::evaluate_lanes(called, a, own, components, out); });
            },
            function::evaluate_intervals, function::evaluate_along};  // which ask nothing of the scene
}

}  // namespace texture
