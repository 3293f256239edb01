#include "render/trace/shade/surface_traits.h"

#include "render/trace/air/even_fog.h"
#include "render/trace/shade/looking_patterns.h"
#include "render/trace/shade/pigment_batch.h"

#include <algorithm>

namespace trace {
namespace {

using texture::TextureSet;

bool any_uv(const TextureSet& set)
{
    const auto texture = [](const texture::Texture& t) { return t.kind == texture::Texture::Kind::Uv; };
    const auto pigment = [](const texture::Pigment& p) { return p.kind == texture::Pigment::Kind::Uv; };
    const auto normal = [](const texture::Normal& n) { return n.map == texture::Normal::Map::Uv; };
    const auto pattern = [](const texture::Pattern& p) { return p.kind == texture::PatternKind::Uv; };
    return std::any_of(set.textures.begin(), set.textures.end(), texture) ||
           std::any_of(set.pigments.begin(), set.pigments.end(), pigment) ||
           std::any_of(set.normals.begin(), set.normals.end(), normal) ||
           std::any_of(set.patterns.begin(), set.patterns.end(), pattern);
}

bool no_light(const scene::Color& c) { return c.filter == 0.0f && c.transmit == 0.0f; }

/// Whether weights of an average divide by a number.
bool has_weight(const TextureSet& set, std::uint32_t first, std::uint32_t count)
{
    float sum = 0.0f;
    for (std::uint32_t i = first; i < first + count; ++i) sum += set.keys[i];
    return sum > 0.0f;
}

/// No colour of the pigment lets light through, so that its pattern does not matter.
bool dark_pigment(const TextureSet& set, std::uint32_t index)
{
    using Kind = texture::Pigment::Kind;
    const texture::Pigment& pigment = set.pigments[index];
    if (pigment.kind == Kind::Image) return false;  // it may be missing
    if (pigment.kind == Kind::Solid) return no_light(pigment.color);
    if (pigment.kind == Kind::Average && !has_weight(set, pigment.first, pigment.count)) return false;
    const std::uint32_t count = pigment.kind == Kind::Uv ? 1 : pigment.count;
    for (std::uint32_t i = pigment.first; i < pigment.first + count; ++i)
        if (!(pigment.kind == Kind::ColorMap ? no_light(set.colors[i]) : dark_pigment(set, set.children[i])))
            return false;
    return count != 0;
}

/// The texture's filter is 0 wherever it is asked.
bool dark_texture(const TextureSet& set, std::uint32_t index)
{
    using Kind = texture::Texture::Kind;
    const texture::Texture& texture = set.textures[index];
    if (texture.kind == Kind::Layers) {
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i)
            if (dark_pigment(set, set.layers[i].pigment)) return true;
        return false;
    }
    if (texture.kind == Kind::Average && !has_weight(set, texture.first, texture.count)) return false;
    const std::uint32_t count = texture.kind == Kind::Uv ? 1 : texture.count;
    for (std::uint32_t i = texture.first; i < texture.first + count; ++i)
        if (!dark_texture(set, set.children[i])) return false;
    return count != 0;
}

/// As the layers are gone through for one crossing, so that the bits are the same.
bool plain_filter(const TextureSet& set, std::uint32_t index, glm::vec3& filter)
{
    if (dark_texture(set, index)) {
        filter = glm::vec3(0);
        return true;
    }
    const texture::Texture& texture = set.textures[index];
    if (texture.kind != texture::Texture::Kind::Layers) return false;
    filter = glm::vec3(1);
    for (std::uint32_t i = texture.count; i-- > 0;) {
        const texture::Pigment& pigment = set.pigments[set.layers[texture.first + i].pigment];
        if (pigment.kind != texture::Pigment::Kind::Solid) return false;
        filter *= pigment.color.filter * pigment.color.rgb() + pigment.color.transmit;
    }
    return true;
}

/// The light of its own side, without iridescence; grain: it may have some.
bool plain_light(const texture::Finish& finish, bool grain)
{
    return finish.diffuse_back == 0.0f && finish.irid == 0.0f && (grain || finish.crand == 0.0f);
}

/// Whether rows that are their hit's only ones find their grain in lanes: numbers are asked for in the order of the
/// lights, but not by nodes of lights, some of which may be dark.
bool grain_in_lanes(const plan::CompiledScene& scene)
{
    const auto& lights = scene.lights.lights;
    return !scene.options.grain_stream && std::none_of(lights.begin(), lights.end(), [](const light::Light& light) {
        return light.area_illumination;
    });
}

/// One layer that has no more than colour, diffuse light, highlights and either a bent normal or mirroring and
/// refraction. looks: some pattern of the scene does at normals; grain: it may have some.
SingleLayer single_layer(const TextureSet& set, std::uint32_t index, bool looks, bool grain)
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
        return texture.opaque && !finish.reflects() && !(looks && looks_at_bent(set, index))
                   ? SingleLayer{texture.first, false}
                   : SingleLayer{};
    if (!(finish.reflection_power > 0.0f)) return {};  // black would be raised to something
    return {texture.first, !texture.plain};
}

/// The texture itself if it has a map, or layers with patterns or bent normals, and few enough.
PatternedLayers patterned_layers(const TextureSet& set, std::uint32_t index, bool looks)
{
    if (index == texture::kNone) return {};
    const texture::Texture& texture = set.textures[index];
    looks = looks && looks_at_bent(set, index);
    if (texture.kind == texture::Texture::Kind::Map)
        return looks ? PatternedLayers{} : PatternedLayers{index, false, true};
    if (texture.kind != texture::Texture::Kind::Layers || texture.count > kPrefetchedLayers) return {};
    bool patterned = false, all_alone = true;
    for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) {
        const texture::Layer& layer = set.layers[i];
        const texture::Finish& finish = set.finishes[layer.finish];
        patterned |= set.pigments[layer.pigment].kind != texture::Pigment::Kind::Solid ||
                     layer.normal != texture::kNone;
        all_alone &= plain_light(finish, false) && !finish.reflects();
        if (looks && layer.normal != texture::kNone) return {};
    }
    return patterned ? PatternedLayers{index, all_alone} : PatternedLayers{};
}

bool one_layer(const TextureSet& set, std::uint32_t index)
{
    const texture::Texture& texture = set.textures[index];
    return texture.kind == texture::Texture::Kind::Layers && texture.count == 1;
}

/// Whether shadow rays have to meet a part from the point itself.
bool asks_own_rays(const plan::CompiledScene& scene, const SceneTraits& traits, const csg::WorldItem& item,
                   csg::PartId part)
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

std::vector<csg::Aabb> boxes_of_own_rays(const plan::CompiledScene& scene, const SceneTraits& traits)
{
    constexpr std::size_t kMost = 16;  // of more one box is made
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
        const csg::Aabb box = csg::drawn_bounds(world, item);
        if (boxes.size() < kMost) boxes.push_back(box);
        else boxes.front().include(box.lower), boxes.front().include(box.upper);
    }
    return boxes;
}

}  // namespace

SceneTraits scene_traits(const plan::CompiledScene& scene)
{
    SceneTraits traits;
    traits.scalar_rows = scene.options.scalar_light;
    traits.even_fog = scene.rainbows.empty() && scene.media.media.empty() &&
                      std::all_of(scene.fogs.begin(), scene.fogs.end(), even);
    const bool uv = any_uv(scene.textures), looks = any_looks(scene.textures), grain = grain_in_lanes(scene);
    traits.looked_around = uv || looks;
    std::vector<SurfaceTraits>& all = traits.surfaces;
    all.resize(scene.surfaces.size());
    for (const light::Light& light : scene.lights.lights) traits.grouped |= light.group != 0;
    for (const plan::Interior& interior : scene.interiors) {
        traits.fades |= interior.fade_distance != 0.0f;
        traits.media |= interior.media.extinguishes;
    }
    for (const csg::Freeform& solid : scene.geometry.store.all<csg::Freeform>())
        traits.has_open_surface |= solid.has_open_surface();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const plan::Surface& surface = scene.surfaces[i];
        traits.grouped |= surface.light_group != 0;
        traits.filters |= !surface.opaque && !surface.no_shadow;
        all[i].needs_uv = uv || surface.uv_mapping;
        all[i].batched = !all[i].needs_uv && !surface.blends();
        traits.all_batched &= all[i].batched;
        if (surface.blends()) continue;
        all[i].outer_patterned = patterned_layers(scene.textures, surface.texture, looks);
        all[i].inner_patterned = surface.interior_texture == plan::kNone
                                     ? all[i].outer_patterned
                                     : patterned_layers(scene.textures, surface.interior_texture, looks);
        if (surface.part_count != 0 && all[i].outer_patterned.map) all[i].outer_patterned = {};
        if (surface.part_count != 0 && all[i].inner_patterned.map) all[i].inner_patterned = {};
        if (surface.double_illuminate) {
            all[i].outer_patterned.alone = all[i].inner_patterned.alone = false;
        } else {
            all[i].outer = single_layer(scene.textures, surface.texture, looks, grain);
            all[i].inner = surface.interior_texture == plan::kNone
                               ? all[i].outer
                               : single_layer(scene.textures, surface.interior_texture, looks, grain);
        }
        const bool focused = surface.interior != plan::kNone &&
                             scene.interiors[surface.interior].caustics_power != 0.0f;
        if (surface.texture == plan::kNone) continue;
        if (surface.interior_texture != plan::kNone && surface.interior_texture != surface.texture) continue;
        const bool plain = plain_filter(scene.textures, surface.texture, all[i].filter);
        all[i].steady_filter = plain && !focused;
        all[i].focuses = plain && focused && !traits.scalar_rows && all[i].batched && surface.part_count == 0 &&
                         one_layer(scene.textures, surface.texture) &&
                         !(looks && looks_at_bent(scene.textures, surface.texture));
        traits.focuses |= all[i].focuses;
    }
    traits.own_rays = boxes_of_own_rays(scene, traits);
    return traits;
}

}  // namespace trace
