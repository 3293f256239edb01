#include "render/kernel/air/sky.h"

#include "numbers/lanes.h"
#include "render/texture/evaluate_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace trace {
namespace {

/// color_of(i) is the colour of layer i.
template <class ColorOf>
scene::Color layered_sky(const texture::Sky& sky, bool see_through, ColorOf&& color_of)
{
    glm::vec3 sum(0), filter(1);
    for (std::size_t i = sky.layers.size(); i-- > 0;) {
        const scene::Color c = color_of(i);
        sum += c.rgb() * (1.0f - c.filter - c.transmit) * filter * sky.emission;
        filter *= c.rgb() * c.filter + c.transmit;
    }
    const scene::Color& b = sky.background;
    const float f = see_through ? b.filter : 0.0f, t = see_through ? b.transmit : 0.0f;
    sum += b.rgb() * (1.0f - f - t) * filter;
    filter *= b.rgb() * f + t;
    scene::Color out = scene::Color::of(sum);
    out.transmit = std::min(1.0f, std::abs(scene::grey(filter)));
    return out;
}

/// A colour, or one a lane.
template <class V>
struct Shade {
    V red, green, blue, filter, transmit;
};
Shade<float> shade_of(const scene::Color& c) { return {c.red, c.green, c.blue, c.filter, c.transmit}; }

/// Its red, green and blue; color_of(i) is the Shade of layer i.
template <class V, class ColorOf>
std::array<V, 3> legacy_sky(const texture::Sky& sky, ColorOf&& color_of)
{
    using std::abs;
    Shade<V> sum{V(0.0f), V(0.0f), V(0.0f), V(0.0f), V(0.0f)}, filter{V(1.0f), V(1.0f), V(1.0f), V(1.0f), V(1.0f)};
    V share(1.0f);
    for (std::size_t i = sky.layers.size(); i-- > 0;) {
        const Shade<V> c = color_of(i);
        const V own = share * (V(1.0f) - c.filter - c.transmit);
        sum.red = sum.red + c.red * own;
        sum.green = sum.green + c.green * own;
        sum.blue = sum.blue + c.blue * own;
        filter = {filter.red * c.red, filter.green * c.green, filter.blue * c.blue, filter.filter * c.filter,
                  filter.transmit * c.transmit};
        share = abs(filter.filter) + abs(filter.transmit);
    }
    const auto seen = [&](const V& own, float emission, float behind, const V& passed) {
        return own * V(emission) + V(behind) * (passed * filter.filter + filter.transmit);
    };
    const scene::Color& b = sky.background;
    return {seen(sum.red, sky.emission.x, b.red, filter.red), seen(sum.green, sky.emission.y, b.green, filter.green),
            seen(sum.blue, sky.emission.z, b.blue, filter.blue)};
}

/// What a ray sees of the sky with its layers in these colours.
template <class ColorOf>
scene::Color seen_sky(const texture::Sky& sky, bool mirrored, ColorOf&& color_of)
{
    const bool see_through = sky.alpha_output && !mirrored;
    if (sky.layers.empty() && !see_through) return scene::Color::of(sky.background.rgb());
    if (!sky.legacy) return layered_sky(sky, see_through, color_of);
    if (see_through) return {0, 0, 0, 0, 1};
    const auto [red, green, blue] = legacy_sky<float>(sky, [&](std::size_t i) { return shade_of(color_of(i)); });
    return {red, green, blue, 0, 0};
}

}  // namespace

scene::Color sky_color(const Context& context, const csg::Ray& ray, bool mirrored)
{
    const texture::Sky& sky = context.scene.sky;
    const texture::Surroundings around{{}, {}, ray.direction};
    return seen_sky(sky, mirrored, [&](std::size_t i) {
        return texture::pigment_color(context.scene.textures, sky.layers[i], ray.direction, around);
    });
}

namespace {

constexpr std::size_t kMostLayers = 32;  ///< looked up together
using LayerColors = std::array<texture::ColorPoints, kMostLayers>;

/// layered_sky() of many rays of one kind.
void layered_skies(const texture::Sky& sky, bool see_through, const LayerColors& colors, texture::ColorPoints& out)
{
    texture::ColorPoints filter;
    out.fill({});
    filter.fill({1, 1, 1, 0, 0});
    const scene::Color& b = sky.background;
    const float f = see_through ? b.filter : 0.0f, t = see_through ? b.transmit : 0.0f;
    const auto add = [](float* sum, float* left, const auto& color, const auto& own, const auto& passes, float emission,
                        bool emits) {
        for (std::size_t k = 0; k < csg::kTileRays; ++k) {
            const float seen = color(k) * own(k) * left[k];
            sum[k] += emits ? seen * emission : seen;
            left[k] *= passes(k);
        }
    };
    const auto channel = [&](std::array<float, csg::kTileRays> texture::ColorPoints::*of, float emission, float back) {
        float *sum = (out.*of).data(), *left = (filter.*of).data();
        for (std::size_t i = sky.layers.size(); i-- > 0;) {
            const texture::ColorPoints& c = colors[i];
            const float* color = (c.*of).data();
            add(
                sum, left, [=](std::size_t k) { return color[k]; },
                [&c](std::size_t k) { return 1.0f - c.filter[k] - c.transmit[k]; },
                [&c, color](std::size_t k) { return color[k] * c.filter[k] + c.transmit[k]; }, emission, true);
        }
        add(
            sum, left, [=](std::size_t) { return back; }, [=](std::size_t) { return 1.0f - f - t; },
            [=](std::size_t) { return back * f + t; }, 1.0f, false);
    };
    channel(&texture::ColorPoints::red, sky.emission.x, b.red);
    channel(&texture::ColorPoints::green, sky.emission.y, b.green);
    channel(&texture::ColorPoints::blue, sky.emission.z, b.blue);
    for (std::size_t k = 0; k < csg::kTileRays; ++k) {
        const float clear = std::abs(scene::grey({filter.red[k], filter.green[k], filter.blue[k]}));
        out.transmit[k] = clear < 1.0f ? clear : 1.0f;
    }
}

/// legacy_sky() of the first `count` rays.
void legacy_skies(const texture::Sky& sky, std::size_t count, const LayerColors& colors, texture::ColorPoints& out)
{
    using numbers::lanes::FloatPart;
    out.fill_clear(0.0f);
    for (std::size_t k = 0; k < count; k += numbers::lanes::kFloatPart) {
        const auto load = [k](const auto& of) { return FloatPart::load_aligned(of.data() + k); };
        const auto [red, green, blue] = legacy_sky<FloatPart>(sky, [&](std::size_t i) {
            const texture::ColorPoints& c = colors[i];
            return Shade<FloatPart>{load(c.red), load(c.green), load(c.blue), load(c.filter), load(c.transmit)};
        });
        red.store_aligned(out.red.data() + k);
        green.store_aligned(out.green.data() + k);
        blue.store_aligned(out.blue.data() + k);
    }
}

/// Skies with layers, of rays enough to be looked up together.
void patterned_skies(const Context& context, const SegmentTile& tile, HitMask missed, scene::Color* out)
{
    const texture::Sky& sky = context.scene.sky;
    const bool looks = context.traits.sky_looks_around;
    texture::Points directions;
    auto& around = context.scratch.shade.patterns.around;  // those of hits have been used
    texture::Around each_around;
    HitMask mirrored = 0;
    for_each_hit(missed, [&](std::size_t k) {
        const glm::dvec3 direction = tile.rays.ray(static_cast<int>(k)).direction;
        const std::size_t n = directions.size();
        if (looks) around[n] = {{}, {}, direction};
        each_around[n] = &around[n];
        if (tile.kind(k) != plan::RayKind::Image) mirrored |= HitMask{1} << n;
        directions.add(direction);
    });
    directions.pad();
    LayerColors colors;
    for (std::size_t i = 0; i < sky.layers.size(); ++i)
        texture::pigment_colors(context.scene.textures, sky.layers[i], directions, each_around, colors[i]);
    std::size_t n = 0;
    const bool all_mirrored = mirrored == first_hits(directions.count);
    if (!sky.alpha_output || all_mirrored || (mirrored == 0 && !sky.legacy)) {
        texture::ColorPoints seen;
        if (sky.legacy) legacy_skies(sky, directions.size(), colors, seen);
        else layered_skies(sky, sky.alpha_output && mirrored == 0, colors, seen);
        for_each_hit(missed, [&](std::size_t k) { out[k] = seen.at(n++); });
        return;
    }
    for_each_hit(missed, [&](std::size_t k) {
        out[k] = seen_sky(sky, has(mirrored, n), [&](std::size_t i) { return colors[i].at(n); });
        ++n;
    });
}

}  // namespace

void sky_colors(const Context& context, const SegmentTile& tile, HitMask missed, scene::Color* out)
{
    constexpr int kFewest = 3;  // rays whose pigments are worth being asked for together
    const texture::Sky& sky = context.scene.sky;
    if (!sky.layers.empty() && sky.layers.size() <= kMostLayers && std::popcount(missed) >= kFewest)
        return patterned_skies(context, tile, missed, out);
    for_each_hit(missed, [&](std::size_t k) {
        const bool mirrored = tile.kind(k) != plan::RayKind::Image;
        out[k] = sky.layers.empty() ? seen_sky(sky, mirrored, [](std::size_t) { return scene::Color(); })
                                    : sky_color(context, tile.rays.ray(static_cast<int>(k)), mirrored);
    });
}

}  // namespace trace
