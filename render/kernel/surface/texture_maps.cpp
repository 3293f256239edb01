#include "render/kernel/surface/texture_maps.h"

#include "render/kernel/surface/mix_textures.h"
#include "render/kernel/surface/prefetch_pigments.h"
#include "render/kernel/surface/shade_surface.h"
#include "render/texture/entries.h"

#include <algorithm>

namespace trace {
namespace {

using texture::Texture;

/// Whether a map's textures bend normals, and every one of them has layers, so that no other map carries normals.
bool bends_flat(const texture::TextureSet& set, const Texture& map)
{
    bool bends = false;
    for (std::uint32_t i = map.first; i < map.first + map.count; ++i) {
        const Texture& entry = set.textures[set.children[i]];
        if (entry.kind != Texture::Kind::Layers) return false;
        for (std::uint32_t k = entry.first; k < entry.first + entry.count; ++k)
            bends |= set.layers[k].normal != texture::kNone;
    }
    return bends;
}

}  // namespace

/// Some of the hits.
struct TextureMaps::Part {
    texture::Points points, normals;
    texture::Around around;

    Part(const Seen& of, HitMask picked)
    {
        for_each_hit(picked, [&](std::size_t i) {
            around[points.size()] = of.around[i];
            points.add(of.points.at(i));
            if (of.map != nullptr) normals.add(of.normals.at(i));
        });
        points.pad();
        if (of.map != nullptr) normals.pad();
    }
};

std::uint32_t TextureMaps::look_up(const Context& context, std::uint32_t texture, HitMask hits,
                                   const texture::Points& p, const texture::Around& around,
                                   const texture::Points& normals)
{
    const Seen seen{p, around, normals};
    const std::uint32_t at = look_up(context, texture, hits, seen);
    bend_nested(context, at, seen);
    return at;
}

std::uint32_t TextureMaps::look_up(const Context& context, std::uint32_t texture, HitMask hits, const Seen& seen)
{
    const std::size_t at = textures_.size();
    textures_.push_back({texture, hits});
    const Texture::Kind kind = context.scene.textures.textures[texture].kind;
    if (kind == Texture::Kind::Map) look_up_map(context, at, seen);
    else if (kind == Texture::Kind::Average) look_up_average(context, at, seen);
    else if (kind == Texture::Kind::Layers) look_up_layers(context, at, seen);
    return static_cast<std::uint32_t>(at);
}

/// Room for a map and its entries; its points are warped into `q`.
void TextureMaps::begin_map(const texture::TextureSet& set, std::size_t at, const Seen& seen, texture::Points& q)
{
    const Texture& texture = set.textures[textures_[at].texture];
    if (maps_used_ == maps_.size()) maps_.emplace_back();
    textures_[at].first = maps_used_++;
    textures_[at].entries = entries_.size();
    entries_.resize(entries_.size() + texture.count, texture::kNone);
    q.take(seen.points);
    warp_points(set, set.patterns[texture.pattern], q, texture::kAllLive);
    maps_[textures_[at].first].points.take(q);
}

/// The map, with the hits' normals as they are within it, if its textures' normals are bent for all hits together.
const Texture* TextureMaps::bent_within(const Context& context, const Texture& map, const Seen& seen,
                                        texture::Points& normals)
{
    const auto& set = context.scene.textures;
    if (seen.nested || !bends_flat(set, map)) return nullptr;
    normals.take(seen.normals);
    texture::normals_into(set, set.patterns[map.pattern], map.no_bump_scale, normals);
    return &map;
}

void TextureMaps::look_up_average(const Context& context, std::size_t at, const Seen& seen)
{
    const auto& set = context.scene.textures;
    const Texture& texture = set.textures[textures_[at].texture];
    texture::Points q, normals;
    begin_map(set, at, seen, q);
    const Seen within{q, seen.around, normals, bent_within(context, texture, seen, normals), true};
    for (std::uint32_t i = 0; i < texture.count; ++i) {
        const std::uint32_t place = look_up(context, set.children[texture.first + i], textures_[at].hits, within);
        entries_[textures_[at].entries + i] = place;
    }
}

void TextureMaps::look_up_map(const Context& context, std::size_t at, const Seen& seen)
{
    const auto& set = context.scene.textures;
    const Texture& texture = set.textures[textures_[at].texture];
    const texture::Pattern& pattern = set.patterns[texture.pattern];
    const HitMask hits = textures_[at].hits;
    texture::Points q, normals;
    texture::Values values;
    begin_map(set, at, seen, q);
    pattern_values(set, pattern, q, seen.around, values);
    texture::BlendPoints& blends = maps_[textures_[at].first].blends;
    map_blends(set, texture.first, texture.count, values, q.size(), blends);
    const Seen within{q, seen.around, normals, bent_within(context, texture, seen, normals), true};
    const HitMask all = first_hits(q.count);
    texture::each_entry(blends, texture.count, q.size(), [&](std::uint32_t entry, HitMask picked) {
        const HitMask those = deposited(picked, hits);
        std::uint32_t place;
        if (picked == all) {
            place = look_up(context, set.children[texture.first + entry], those, within);
        } else {
            const Part part(within, picked);
            place = look_up(context, set.children[texture.first + entry], those,
                            {part.points, part.around, part.normals, within.map, true});
        }
        entries_[textures_[at].entries + entry] = place;
    });
}

void TextureMaps::look_up_layers(const Context& context, std::size_t at, const Seen& seen)
{
    const auto& set = context.scene.textures;
    const Texture& texture = set.textures[textures_[at].texture];
    textures_[at].first = layers_used_;
    textures_[at].bent = seen.map != nullptr;
    layers_used_ += texture.count;
    if (layers_.size() < layers_used_) layers_.resize(layers_used_);
    asked_.resize(layers_used_);
    std::fill(asked_.begin() + static_cast<std::ptrdiff_t>(textures_[at].first), asked_.end(), 0);
    const HitMask all = first_hits(seen.points.count);
    const auto bailout = static_cast<float>(context.adc_bailout);
    TileColors filter;
    if (!texture.plain) filter.fill(1.0f);
    HitMask open = all;
    for (std::uint32_t depth = 0; depth < texture.count && open != 0; ++depth) {
        const texture::Layer& layer = set.layers[texture.first + texture.count - 1 - depth];
        textures_[at].asks_point |= seen.map == nullptr && layer.normal != texture::kNone;
        LayerPoints& to = layers_[textures_[at].first + depth];
        if (open == all) {
            pigment_colors(set, layer.pigment, seen.points, seen.around, to.colors);
            bend(set, layer.normal, seen, open, to.normals);
        } else {
            const Part part(seen, open);
            texture::ColorPoints found;
            pigment_colors(set, layer.pigment, part.points, part.around, found);
            std::size_t i = 0;
            for_each_hit(open, [&](std::size_t k) { to.colors.set(k, found.at(i++)); });
            bend(set, layer.normal, {part.points, part.around, part.normals, seen.map}, open, to.normals);
        }
        open = texture.plain ? 0 : open & pass_layer(to.colors, filter, bailout);
    }
    textures_[at].open = deposited(open, textures_[at].hits);
}

/// As a layer's normal is bent within its map, of unit length; `hits`: where in `to`.
void TextureMaps::bend(const texture::TextureSet& set, std::uint32_t normal, const Seen& seen, HitMask hits,
                       BentNormals& to)
{
    if (normal == texture::kNone || seen.map == nullptr) return;
    texture::Points n;
    n.take(seen.normals);
    perturb_points(set, normal, seen.points, seen.around, n);
    texture::normalize_points(n);
    texture::normals_out_of(set, set.patterns[seen.map->pattern], seen.map->no_bump_scale, n);
    std::size_t i = 0;
    for_each_hit(hits, [&](std::size_t k) { to.set(k, n.at(i++)); });
}

void TextureMaps::shade(Context& context, DirectBatch& batch, HitContext& hit, std::uint32_t at,
                        const texture::Points& points, std::size_t k, ColorSlot out) const
{
    const auto& set = context.scene.textures;
    const Place& place = textures_[at];
    const Texture& texture = set.textures[place.texture];
    const std::size_t i = place_of(place.hits, hit.lane);
    if (texture.kind == Texture::Kind::Layers) {
        const PrefetchedPigments known{place.texture, texture.count, layers_.data() + place.first, i, place.bent};
        hit.prefetched = &known;
        shade_layers(context, batch, hit, texture, place.asks_point ? points.at(k) : glm::dvec3(0), out);
        hit.prefetched = nullptr;
        return;
    }
    const bool average = texture.kind == Texture::Kind::Average;
    if (texture.kind != Texture::Kind::Map && !average)
        return shade_texture(context, batch, hit, place.texture, points.at(k), out);
    hit.enclosing.enter(place.texture);
    const Map& map = maps_[place.first];
    const auto shade_entry = [&](std::uint32_t entry, ColorSlot slot) {
        shade(context, batch, hit, entries_[place.entries + entry - texture.first], map.points, i, slot);
    };
    if (average) average_textures(context, texture, out, shade_entry);
    else
        mix_textures(context,
                     {texture.first + map.blends.lower[i], texture.first + map.blends.upper[i], map.blends.share[i]},
                     out, shade_entry);
}

}  // namespace trace
