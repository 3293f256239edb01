#include "render/plan/traits/find_traits.h"

#include "render/plan/textures/dark_texture.h"
#include "render/plan/traits/looking_patterns.h"
#include "render/texture/finish.h"

#include <algorithm>

namespace plan {
namespace {

using texture::TextureSet;

/// As the layers are gone through for one crossing, so that the bits are the same. dark: of the texture.
bool plain_filter(const TextureSet& set, std::uint32_t index, bool dark, glm::vec3& filter)
{
    if (dark) {
        filter = glm::vec3(0);
        return true;
    }
    const texture::Texture& texture = set.textures[index];
    if (texture.kind != texture::Texture::Kind::Layers) return false;
    filter = glm::vec3(1);
    for (std::uint32_t i = texture.count; i-- > 0;) {
        const texture::Pigment& pigment = set.pigments[set.layers[texture.first + i].pigment];
        if (pigment.kind != texture::Pigment::Kind::Solid) return false;
        filter *= texture::passed(pigment.color);
    }
    return true;
}

/// What the textures that a surface shows look at.
LookedAt looked_at(const CompiledScene& scene, const Surface& surface, const TextureInputs& looks)
{
    LookedAt out = looks.of_texture(surface.texture);
    out |= looks.of_texture(surface.interior_texture);
    for (const std::uint32_t corner : surface.corner_textures) out |= looks.of_texture(corner);
    for (std::uint32_t k = 0; k < surface.part_count; ++k)
        out |= looks.of_texture(scene.part_textures[surface.first_part + k]);
    return out;
}

/// The light of its own side, without iridescence; grain: it may have some.
bool plain_light(const texture::Finish& finish, bool grain)
{
    return finish.diffuse_back == 0.0f && finish.irid == 0.0f && !finish.own_light && (grain || finish.crand == 0.0f);
}

/// Whether rows that are their hit's only ones find their grain in lanes: numbers are asked for in the order of the
/// lights, but not by nodes of lights, some of which may be dark.
bool grain_in_lanes(const CompiledScene& scene)
{
    const auto& lights = scene.lights.lights;
    return !scene.options.grain_stream && std::none_of(lights.begin(), lights.end(), [](const light::Light& light) {
        return light.area_illumination;
    });
}

/// One layer that has no more than colour, diffuse light, highlights and either a bent normal or mirroring and
/// refraction. bent: LookedAt::bent of the texture; grain: it may have some.
SingleLayer single_layer(const TextureSet& set, std::uint32_t index, bool bent, bool grain)
{
    if (index == texture::kNone) return {};
    const texture::Texture& texture = set.textures[index];
    if (texture.kind != texture::Texture::Kind::Layers || texture.count != 1) return {};
    const texture::Layer& layer = set.layers[texture.first];
    const texture::Finish& finish = set.finishes[layer.finish];
    if (set.pigments[layer.pigment].kind != texture::Pigment::Kind::Solid && !texture.opaque)
        return {};  // it may be missing
    if (!plain_light(finish, grain)) return {};
    if (layer.normal != texture::kNone)
        return texture.opaque && !finish.reflects() && !bent ? SingleLayer{texture.first, false} : SingleLayer{};
    if (!(finish.reflection_power > 0.0f)) return {};  // black would be raised to something
    return {texture.first, !texture.plain};
}

/// See SingleLayer::clear. interior: what the surface closes.
bool lets_all_through(const TextureSet& set, const SingleLayer& single, const Interior& interior)
{
    const texture::Layer& layer = set.layers[single.index];
    const texture::Pigment& pigment = set.pigments[layer.pigment];
    const texture::Finish& finish = set.finishes[layer.finish];
    return pigment.kind == texture::Pigment::Kind::Solid && !finish.reflects() && finish.dull() &&
           texture::opacity(pigment.color, set.legacy_opacity) == 0.0f &&
           texture::past_layer(glm::vec3(1), pigment.color, finish, glm::vec3(0)) == glm::vec3(1) &&
           interior.transmission == 1.0f && interior.fade_distance == 0.0f;
}

/// Whether textures, and all that their maps lead to, have layers of nothing but colour, diffuse light and highlights.
class PlainMaps {
public:
    explicit PlainMaps(const TextureSet& set) : set_(set), known_(set.textures.size(), Known::No) {}

    bool of(std::uint32_t index)
    {
        Known& known = known_[index];
        if (known == Known::No) known = find(set_.textures[index]) ? Known::Plain : Known::Other;
        return known == Known::Plain;
    }

private:
    enum class Known : std::uint8_t { No, Plain, Other };

    bool find(const texture::Texture& texture)
    {
        using Kind = texture::Texture::Kind;
        const auto all = [&texture](auto&& is_plain) {
            for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i)
                if (!is_plain(i)) return false;
            return true;
        };
        if (texture.kind == Kind::Map || texture.kind == Kind::Average)
            return all([this](std::uint32_t i) { return of(set_.children[i]); });
        return texture.kind == Kind::Layers && all([this](std::uint32_t i) {
                   const texture::Layer& layer = set_.layers[i];
                   const texture::Finish& finish = set_.finishes[layer.finish];
                   return plain_light(finish, false) && !finish.reflects();
               });
    }

    const TextureSet& set_;
    std::vector<Known> known_;
};

/// Which textures bend normals, by index; what is inside of a map stands before it.
std::vector<bool> bending_textures(const TextureSet& set)
{
    using Kind = texture::Texture::Kind;
    std::vector<bool> out;
    for (const texture::Texture& texture : set.textures) {
        const auto bends = [&](std::uint32_t i) {
            return texture.kind == Kind::Layers ? set.layers[i].normal != texture::kNone : out[set.children[i]];
        };
        const std::uint32_t count = texture.kind == Kind::Uv ? 1 : texture.count;
        bool any = false;
        for (std::uint32_t i = texture.first; i < texture.first + count; ++i) any = any || bends(i);
        out.push_back(any);
    }
    return out;
}

/// The texture itself if it has a map, or layers with patterns or bent normals, and few enough. bent: something of it
/// looks at normals that it has bent.
PatternedLayers patterned_layers(const TextureSet& set, std::uint32_t index, bool bent, PlainMaps& plain_maps)
{
    if (index == texture::kNone) return {};
    const texture::Texture& texture = set.textures[index];
    using Kind = texture::Texture::Kind;
    if (texture.kind == Kind::Map || texture.kind == Kind::Average)
        // Normals of another length are lit one by one.
        return bent ? PatternedLayers{} : PatternedLayers{index, plain_maps.of(index) && !texture.no_bump_scale, true};
    if (texture.kind != Kind::Layers || texture.count > kPrefetchedLayers) return {};
    bool patterned = false, all_alone = true;
    for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) {
        const texture::Layer& layer = set.layers[i];
        const texture::Finish& finish = set.finishes[layer.finish];
        patterned |= set.pigments[layer.pigment].kind != texture::Pigment::Kind::Solid ||
                     layer.normal != texture::kNone;
        all_alone &= plain_light(finish, false) && !finish.reflects();
        if (bent && layer.normal != texture::kNone) return {};
    }
    return patterned ? PatternedLayers{index, all_alone} : PatternedLayers{};
}

/// Layers that ask for no place on their object.
bool layers_filter(const TextureSet& set, std::uint32_t index)
{
    const texture::Texture& texture = set.textures[index];
    if (texture.kind != texture::Texture::Kind::Layers) return false;
    return std::none_of(
        set.layers.begin() + texture.first, set.layers.begin() + texture.first + texture.count,
        [&](const texture::Layer& layer) { return set.pigments[layer.pigment].kind == texture::Pigment::Kind::Uv; });
}

/// Whether shadow rays have to meet a part from the point itself.
bool asks_own_rays(const CompiledScene& scene, const SceneTraits& traits, const csg::WorldItem& item, csg::PartId part)
{
    const csg::SolidStore& store = scene.geometry.store;
    const bool one_way = csg::kind_of(part) == csg::SolidKind::Freeform &&
                         store.all<csg::Freeform>()[csg::index_of(part)].one_way();
    if (item.all_opaque) return one_way && item.solid == csg::kNoPart;  // a clip may open it
    if (one_way) return true;
    if (csg::kind_of(part) == csg::SolidKind::Mesh) return true;  // of many surfaces
    const csg::SurfaceId surface = store.surface(part);
    if (surface >= scene.surfaces.size()) return false;  // it only clips
    return !scene.surfaces[surface].opaque && !scene.surfaces[surface].no_shadow &&
           !traits.surfaces[surface].steady_filter;
}

/// Of more than a few one box is made.
void add_box(std::vector<csg::Aabb>& boxes, const csg::Aabb& box)
{
    constexpr std::size_t kMost = 16;
    if (boxes.size() < kMost) boxes.push_back(box);
    else boxes.front().include(box.lower), boxes.front().include(box.upper);
}

std::vector<csg::Aabb> boxes_of_own_rays(const CompiledScene& scene, const SceneTraits& traits)
{
    const csg::WorldData& world = scene.geometry;
    std::vector<csg::Aabb> boxes;
    const auto& freeforms = world.store.all<csg::Freeform>();
    const bool one_way =
        std::any_of(freeforms.begin(), freeforms.end(), [](const csg::Freeform& f) { return f.one_way(); });
    for (const csg::WorldItem& item : world.items) {
        if (item.all_opaque && !one_way) continue;
        bool asks = false;
        if (item.instance != csg::Hit::kNoInstance) {
            asks = traits.filters;
        } else if (item.solid != csg::kNoPart) {
            asks = asks_own_rays(scene, traits, item, item.solid);
        } else {
            for (const csg::Node& node : world.programs[item.program].nodes)
                asks = asks || (node.op == csg::Op::Leaf && asks_own_rays(scene, traits, item, node.solid));
        }
        if (!asks) continue;
        add_box(boxes, csg::drawn_bounds(world, item));
    }
    return boxes;
}

Slab slab_around(const csg::Aabb& box, const std::vector<light::Light>& lights)
{
    Slab out;
    if (box.empty()) return out;
    double farthest = 0.0;
    for (const light::Light& light : lights)
        for (int axis = 0; axis < 3; ++axis) {
            const double at = light.location[axis], apart = std::max(box.lower[axis] - at, at - box.upper[axis]);
            if (!(apart > farthest)) continue;
            constexpr double kRoom = 1e-9;  // for the rounding of where rays are, of the coordinate
            farthest = apart;
            out = {axis, box.lower[axis] - kRoom * std::abs(box.lower[axis]),
                   box.upper[axis] + kRoom * std::abs(box.upper[axis])};
        }
    return out;
}

void find_slabs(const CompiledScene& scene, SceneTraits& traits)
{
    if (!traits.filters && traits.own_rays.empty()) return;  // shadow rays ask for no more anyhow
    csg::Aabb clear;
    for (const csg::Aabb& box : traits.own_rays) clear.include(box);
    traits.own_rays_slab = slab_around(clear, scene.lights.lights);
    for (const csg::WorldItem& item : scene.geometry.items)
        if (!item.all_opaque) clear.include(csg::drawn_bounds(scene.geometry, item));
    traits.clear_slab = slab_around(clear, scene.lights.lights);
}

}  // namespace

SceneTraits find_traits(const CompiledScene& scene)
{
    SceneTraits traits;
    traits.scalar_rows = scene.options.scalar_light;
    traits.even_fog = scene.rainbows.empty() && scene.media.media.empty() &&
                      std::all_of(scene.fogs.begin(), scene.fogs.end(), texture::even);
    const auto& finishes = scene.textures.finishes;
    traits.fresnel = std::any_of(finishes.begin(), finishes.end(), [](const auto& finish) { return finish.fresnel; });
    const TextureInputs texture_looks(scene.textures);
    const std::vector<bool> dark = dark_textures(scene.textures);
    PlainMaps plain_maps(scene.textures);
    const std::vector<bool> bending = bending_textures(scene.textures);
    const bool grain = grain_in_lanes(scene);
    const bool every_detail = !scene.options.lean.takes(LeanStep::HitDetails);
    traits.clear_surfaces = scene.options.lean.takes(LeanStep::ClearSurfaces) && !scene.options.grain_stream &&
                            scene.textures.extensions.empty();
    for (const std::uint32_t layer : scene.sky.layers) {
        const LookedAt looks = texture_looks.of_pigment(layer);
        traits.sky_looks_around |= looks.uv || looks.around || every_detail;
    }
    std::vector<SurfaceTraits>& all = traits.surfaces;
    all.resize(scene.surfaces.size());
    for (const light::Light& light : scene.lights.lights) traits.grouped |= light.group != 0;
    for (const Interior& interior : scene.interiors) {
        traits.dimming.push_back(interior.dims() ? 1 : 0);
        traits.fades |= interior.fade_distance != 0.0f;
        traits.media |= interior.media.extinguishes;
        traits.interior_media |= !interior.media.empty();
    }
    for (const csg::Freeform& solid : scene.geometry.store.all<csg::Freeform>())
        traits.has_open_surface |= solid.has_open_surface();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Surface& surface = scene.surfaces[i];
        traits.grouped |= surface.light_group != 0;
        traits.filters |= !surface.opaque && !surface.no_shadow;
        const LookedAt looks = looked_at(scene, surface, texture_looks);
        all[i].looked_around = looks.uv || looks.around || every_detail;
        all[i].needs_uv = looks.uv || surface.uv_mapping || every_detail;
        all[i].batched = !all[i].needs_uv && !surface.blends();
        if (!all[i].batched) traits.not_batched.push_back(static_cast<csg::SurfaceId>(i));
        if (surface.blends()) continue;
        const std::uint32_t inner = surface.texture_of(true);
        const auto looks_at_bent = [&](std::uint32_t texture) {
            return texture != texture::kNone && bending[texture] && texture_looks.of_texture(texture).bent;
        };
        const bool bent = looks_at_bent(surface.texture), inner_bent = looks_at_bent(inner);
        all[i].outer_patterned = patterned_layers(scene.textures, surface.texture, bent, plain_maps);
        all[i].inner_patterned = patterned_layers(scene.textures, inner, inner_bent, plain_maps);
        if (surface.part_count != 0 && all[i].outer_patterned.map) all[i].outer_patterned = {};
        if (surface.part_count != 0 && all[i].inner_patterned.map) all[i].inner_patterned = {};
        if (surface.double_illuminate) {
            all[i].outer_patterned.alone = all[i].inner_patterned.alone = false;
        } else {
            all[i].outer = single_layer(scene.textures, surface.texture, bent, grain);
            all[i].inner = single_layer(scene.textures, inner, inner_bent, grain);
        }
        for (SingleLayer* single : {&all[i].outer, &all[i].inner}) {
            if (!traits.clear_surfaces || single->index == kNone || !single->goes_on) continue;
            single->dull = scene.textures.finishes[scene.textures.layers[single->index].finish].dull();
            single->clear = surface.interior != kNone &&
                            lets_all_through(scene.textures, *single, scene.interiors[surface.interior]);
        }
        const bool focused = surface.interior != kNone && scene.interiors[surface.interior].caustics_power != 0.0f;
        if (surface.texture == kNone) continue;
        if (inner != surface.texture) continue;
        const bool plain = plain_filter(scene.textures, surface.texture, dark[surface.texture], all[i].filter);
        all[i].steady_filter = plain && !focused;
        const bool dimmed = surface.interior != kNone && traits.dimming[surface.interior] != 0;
        all[i].filters_alone = all[i].steady_filter && !dimmed;
        all[i].filters_together = !surface.opaque && !all[i].steady_filter && !traits.scalar_rows && all[i].batched &&
                                  surface.part_count == 0 && layers_filter(scene.textures, surface.texture) &&
                                  !texture_looks.of_texture(surface.texture).bent;
        traits.filters_together |= all[i].filters_together;
    }
    traits.own_rays = boxes_of_own_rays(scene, traits);
    find_slabs(scene, traits);
    if (!scene.options.lean.takes(LeanStep::Interiors)) traits.grouped = traits.fades = traits.media = true;
    return traits;
}

}  // namespace plan
