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

static_assert(kMostPoints == function::kMostTogether);

void put(const double* x, const double* y, const double* z, std::size_t count, Points& out)
{
    out.count = static_cast<int>(count);
    std::copy_n(x, count, out.x.data());
    std::copy_n(y, count, out.y.data());
    std::copy_n(z, count, out.z.data());
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

void FunctionHost::patterns(std::uint32_t slot, const double* x, const double* y, const double* z, std::size_t count,
                            double* out) const
{
    const Pattern& pattern = set_.patterns[slot];
    Points points;
    put(x, y, z, count, points);
    warp_points(set_, pattern, points, kAllLive);
    Values values;
    pattern_values(set_, pattern, points, nowhere(), values);
    std::copy_n(values.data(), count, out);
}

void FunctionHost::pigments(std::uint32_t slot, const double* x, const double* y, const double* z, std::size_t count,
                            const std::array<double*, 5>& out) const
{
    Points points;
    put(x, y, z, count, points);
    ColorPoints colors;
    pigment_colors(set_, slot, points, nowhere(), colors);
    const auto tell = [count](const std::array<float, kMostPoints>& of, double* to) {
        for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<double>(of[i]);
    };
    tell(colors.red, out[0]);
    tell(colors.green, out[1]);
    tell(colors.blue, out[2]);
    tell(colors.filter, out[3]);
    tell(colors.transmit, out[4]);
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
            [](const Function& called, const double* const* a, std::size_t count, const Host& host,
               std::uint32_t components, double* const* out) {
                here(host, [&](const Host& own) { function::evaluate_lanes(called, a, count, own, components, out); });
            },
            function::evaluate_intervals, function::evaluate_along};  // which ask nothing of the scene
}

}  // namespace texture
