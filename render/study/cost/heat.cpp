#include "render/study/cost/heat.h"

#include "render/study/cost/sampled_run.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"
#include "render/scene/base/thread_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace study {
namespace {

constexpr int kSide = 8;  // of a tile of rays

/// Five rows of three bits for each character that a scale needs.
constexpr std::array<std::uint8_t, 5> glyph(char c)
{
    switch (c) {
    case '0': return {7, 5, 5, 5, 7};
    case '1': return {2, 6, 2, 2, 7};
    case '2': return {7, 1, 7, 4, 7};
    case '3': return {7, 1, 7, 1, 7};
    case '4': return {5, 5, 7, 1, 1};
    case '5': return {7, 4, 7, 1, 7};
    case '6': return {7, 4, 7, 5, 7};
    case '7': return {7, 1, 1, 1, 1};
    case '8': return {7, 5, 7, 5, 7};
    case '9': return {7, 5, 7, 1, 7};
    case 'n': return {0, 6, 5, 5, 5};
    case 's': return {0, 3, 4, 1, 6};
    case 'r': return {0, 5, 6, 4, 4};
    case 'a': return {0, 3, 5, 5, 3};
    case 'y': return {0, 5, 5, 2, 4};
    case '.': return {0, 0, 0, 0, 2};
    default: return {};
    }
}

/// Of the thread, at least a nanosecond: its clock may stand still, or go back, while it changes processors.
double since(double begun) { return std::max(scene::thread_seconds() - begun, 1e-9); }

/// Black, blue, red, yellow, white, at even steps.
std::array<float, 3> false_color(float share)
{
    constexpr std::array<std::array<float, 3>, 5> kColors{
        {{0, 0, 0}, {0.1f, 0.1f, 0.7f}, {0.9f, 0.15f, 0.1f}, {1, 0.9f, 0.1f}, {1, 1, 1}}};
    const float at = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(kColors.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), kColors.size() - 2);
    const float f = at - static_cast<float>(i);
    std::array<float, 3> out{};
    for (std::size_t c = 0; c < 3; ++c) out[c] = (1 - f) * kColors[i][c] + f * kColors[i + 1][c];
    return out;
}

void set(image::Raster& to, int x, int y, const std::array<float, 3>& color)
{
    if (x < 0 || x >= to.width || y < 0 || y >= to.height) return;
    for (std::size_t c = 0; c < 3; ++c) to.at(x, y)[c] = static_cast<std::uint16_t>(std::lround(255.0f * color[c]));
}

void write_text(image::Raster& to, int x, int y, const std::string& text)
{
    for (const char c : text) {
        const auto rows = glyph(c);
        for (int row = 0; row < 5; ++row)
            for (int column = 0; column < 3; ++column)
                if ((rows[static_cast<std::size_t>(row)] >> (2 - column) & 1) != 0)
                    set(to, x + column, y + row, {1, 1, 1});
        x += 4;
    }
}

/// Below it lie 99.5 % of the values, so that a few do not darken all others.
float top_of(std::vector<float> values)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(values.size() - 1) * 0.995);
    std::nth_element(values.begin(), at, values.end());
    return std::max(*at, 1.0f);
}

/// A scale of logarithms from 1 to `top` over the width: a value's share of it.
float share_of(float value, float top) { return top > 1.0f ? std::log(std::max(value, 1.0f)) / std::log(top) : 0.0f; }

void panel(image::Raster& to, int left, const Heat& heat, const std::vector<float>& values, const std::string& unit)
{
    constexpr int kBar = 8;
    const float top = std::max(top_of(values), 2.0f);
    for (int y = 0; y < heat.height; ++y)
        for (int x = 0; x < heat.width; ++x)
            set(to, left + x, y,
                false_color(share_of(values[static_cast<std::size_t>(y) * static_cast<std::size_t>(heat.width) +
                                            static_cast<std::size_t>(x)],
                                     top)));
    for (int x = 0; x < heat.width; ++x)
        for (int y = 0; y < kBar; ++y)
            set(to, left + x, heat.height + 2 + y,
                false_color(static_cast<float>(x) / static_cast<float>(std::max(1, heat.width - 1))));
    const int line = heat.height + kBar + 4;
    write_text(to, left, line, "1");
    const std::string half = fmt::format("{:.0f}", std::sqrt(top)), last = fmt::format("{:.0f} {}", top, unit);
    if (heat.width >= 64) write_text(to, left + heat.width / 2 - 2 * static_cast<int>(half.size()), line, half);
    write_text(to, left + heat.width - 4 * static_cast<int>(last.size()), line, last);
}

}  // namespace

Heat measure_heat(const plan::CompiledScene& scene, const trace::RenderOptions& render)
{
    const trace::KernelTable& kernel = trace::load_kernel(render.isa);
    const auto indirect = trace::run_passes(scene, render);
    const OwnTracer tracer = make_tracer(kernel, scene, indirect.get(), render.cancel);
    Heat heat;
    heat.width = scene.options.width;
    heat.height = scene.options.height;
    const auto pixels = static_cast<std::size_t>(heat.width) * static_cast<std::size_t>(heat.height);
    heat.ns.resize(pixels);
    heat.rays.resize(pixels);
    std::array<scene::Color, kSide * kSide> colors;
    std::vector<trace::SamplePosition> tile;
    std::vector<std::size_t> at;
    for (int top = 0; top < heat.height; top += kSide)
        for (int left = 0; left < heat.width; left += kSide) {
            tile.clear();
            at.clear();
            for (int y = top; y < std::min(top + kSide, heat.height); ++y)
                for (int x = left; x < std::min(left + kSide, heat.width); ++x) {
                    tile.emplace_back(x, y);
                    at.push_back(static_cast<std::size_t>(y) * static_cast<std::size_t>(heat.width) +
                                 static_cast<std::size_t>(x));
                }
            double begun = scene::thread_seconds(), alone = 0.0;
            if (!kernel.sample(*tracer, tile, colors.data())) return {};
            const double together = since(begun);
            for (std::size_t k = 0; k < tile.size(); ++k) {
                const double rays = ray_count(kernel.counts(*tracer));
                begun = scene::thread_seconds();
                if (!kernel.sample(*tracer, {&tile[k], 1}, colors.data())) return {};
                const double took = since(begun);
                alone += took;
                heat.ns[at[k]] = static_cast<float>(1e9 * took);
                heat.rays[at[k]] = static_cast<float>(ray_count(kernel.counts(*tracer)) - rays);
            }
            const auto share = static_cast<float>(together / alone);
            for (const std::size_t pixel : at) heat.ns[pixel] *= share;
        }
    return heat;
}

image::Raster heat_picture(const Heat& heat)
{
    constexpr int kGap = 4, kScale = 20;
    image::Raster out;
    out.width = 2 * heat.width + kGap;
    out.height = heat.height + kScale;
    out.channels = 3;
    out.bits = 8;
    out.samples.assign(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height), 0);
    panel(out, 0, heat, heat.ns, "ns");
    panel(out, heat.width + kGap, heat, heat.rays, "rays");
    return out;
}

image::Image heat_values(const Heat& heat)
{
    image::Image out;
    out.width = heat.width;
    out.height = heat.height;
    out.hold(0, heat.height);
    for (int y = 0; y < heat.height; ++y)
        for (int x = 0; x < heat.width; ++x) {
            const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(heat.width) +
                            static_cast<std::size_t>(x);
            out.at(x, y)[0] = heat.ns[at];
            out.at(x, y)[1] = heat.rays[at];
        }
    return out;
}

}  // namespace study
