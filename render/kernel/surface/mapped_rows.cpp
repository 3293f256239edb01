#include "numbers/lane_equal.h"
#include "render/kernel/light/direct_batch.h"
#include "render/kernel/surface/prefetch_pigments.h"
#include "render/kernel/surface/texture_maps.h"

#include <algorithm>

/// Rows of light of a tile's texture maps, and the mixtures of their colours, all hits at once.
namespace trace {
namespace {

using texture::Texture;

/// Entries of a map that hits show, by hit.
struct LaneBlends {
    HitMask blended = 0;  ///< those that show two of them
    alignas(64) std::array<std::uint32_t, csg::kTileRays> lower{}, upper{};
    alignas(64) TileLanes share{};
};

/// The mixture of two entries; both infinite are infinite too (RayQueue's nodes).
void mix_entries(const LaneBlends& blends, const TileColors& upper, TileColors& out)
{
    for (TileFloats TileColors::*channel : kChannels) {
        TileFloats& low = out.*channel;
        const TileFloats& high = upper.*channel;
        alignas(64) TileFloats moved;
        each_part_of(blends.blended, [&](std::size_t i, FloatMask blended) {
            const FloatPart own = part(low, i);
            (part(high, i) - own).store_aligned(&moved[i]);
            for (std::size_t k = i; k < i + kFloatPart; ++k)
                moved[k] = static_cast<float>(blends.share[k] * static_cast<double>(moved[k]));
            const FloatPart mixed = xsimd::select(own == part(high, i), own, own + part(moved, i));
            blended.chosen(mixed, own).store_aligned(&low[i]);
        });
    }
}

/// Takes the colours of these hits.
void take_colors(HitMask hits, const TileColors& from, TileColors& to)
{
    for (TileFloats TileColors::*channel : kChannels)
        each_part_of(hits, [&](std::size_t i, FloatMask here) {
            here.chosen(part(from.*channel, i), part(to.*channel, i)).store_aligned(&(to.*channel)[i]);
        });
}

}  // namespace

HitMask TextureMaps::lay_rows(const Context& context, DirectBatch& batch, std::uint32_t at)
{
    const auto& set = context.scene.textures;
    const auto bailout = static_cast<float>(context.adc_bailout);
    HitMask closed = textures_[at].hits;
    for (std::size_t i = at; i < textures_.size(); ++i) closed &= ~textures_[i].open;
    for (std::size_t i = at; i < textures_.size(); ++i) {
        Place& place = textures_[i];
        const Texture& texture = set.textures[place.texture];
        HitMask left = place.hits & closed;
        if (texture.kind != Texture::Kind::Layers || left == 0) continue;
        place.page = batch.room(left, texture.count);
        TileColors filter;
        filter.fill(1.0f);
        for (std::uint32_t depth = 0; depth < texture.count && left != 0; ++depth) {
            const texture::Layer& layer = set.layers[texture.first + texture.count - 1 - depth];
            const LayerPoints& known = layers_[place.first + depth];
            LayerPoints placed;
            std::size_t from = 0;
            for_each_hit(place.hits, [&](std::size_t k) { placed.colors.set(k, known.colors.at(from++)); });
            if (layer.normal != texture::kNone) {
                from = 0;
                for_each_hit(place.hits, [&](std::size_t k) { placed.normals.set(k, known.normals.at(from++)); });
            }
            batch.lay(place.page + depth, left, layer, filter, texture.plain, placed.colors, placed.normals);
            asked_[place.first + depth] = left;
            if (depth + 1 < texture.count) left &= pass_layer(placed.colors, filter, bailout);
        }
    }
    return closed;
}

void TextureMaps::mix(const Context& context, std::uint32_t at, TileColors& out) const
{
    const auto& set = context.scene.textures;
    const Place& place = textures_[at];
    const Texture& texture = set.textures[place.texture];
    if (texture.kind == Texture::Kind::Layers) return mix_layers(context, place, texture.count, out);
    const std::uint32_t* entries = entries_.data() + place.entries;
    TileColors found, upper;
    if (texture.kind == Texture::Kind::Average) {
        out.fill(0.0f);
        float weights = 0.0f;
        for (std::uint32_t entry = 0; entry < texture.count; ++entry) {
            const float weight = set.keys[texture.first + entry];
            weights += weight;
            mix(context, entries[entry], found);
            for (TileFloats TileColors::*channel : kChannels)
                each_part_of(place.hits, [&](std::size_t i, FloatMask) {
                    (part(out.*channel, i) + FloatPart(weight) * part(found.*channel, i))
                        .store_aligned(&(out.*channel)[i]);
                });
        }
        for (TileFloats TileColors::*channel : kChannels)
            each_part_of(place.hits, [&](std::size_t i, FloatMask) {
                (part(out.*channel, i) / FloatPart(weights)).store_aligned(&(out.*channel)[i]);
            });
        return;
    }
    const auto shown = [](std::uint32_t entry) { return entry != texture::kNone; };
    const std::uint32_t* const end = entries + texture.count;
    const std::uint32_t* const only = std::find_if(entries, end, shown);
    if (std::find_if(only + 1, end, shown) == end) return mix(context, *only, out);
    const Map& map = maps_[place.first];
    LaneBlends blends;
    std::size_t from = 0;
    for_each_hit(place.hits, [&](std::size_t k) {
        blends.lower[k] = map.blends.lower[from];
        blends.upper[k] = map.blends.upper[from];
        blends.share[k] = map.blends.share[from++];
        if (blends.lower[k] != blends.upper[k]) blends.blended |= HitMask{1} << k;
    });
    out.fill(0.0f);
    upper.fill(0.0f);
    for (std::uint32_t i = 0; i < texture.count; ++i) {
        if (entries[i] == texture::kNone) continue;
        mix(context, entries[i], found);
        take_colors(place.hits & numbers::lanes::equal(blends.lower, i), found, out);
        take_colors(blends.blended & numbers::lanes::equal(blends.upper, i), found, upper);
    }
    mix_entries(blends, upper, out);
}

/// The sum of a texture's rows.
void TextureMaps::mix_layers(const Context& context, const Place& place, std::uint32_t layers, TileColors& out) const
{
    for (std::uint32_t depth = 0; depth < layers; ++depth) {
        const HitMask asked = asked_[place.first + depth];
        if (asked == 0) return;
        const RowPage& page = context.scratch.shade.rows.pages[place.page + depth];
        for (TileFloats TileColors::*channel : kChannels)
            each_part_of(asked, [&](std::size_t i, FloatMask here) {
                const FloatPart own = part(page.glow.*channel, i) + part(page.gained.*channel, i),
                                row = here.kept(part(page.filter.*channel, i) * own);
                (depth == 0 ? row : part(out.*channel, i) + row).store_aligned(&(out.*channel)[i]);
            });
    }
}

}  // namespace trace
