#include "render/kernel/surface/texture_maps.h"

#include "render/kernel/context/context.h"

#include <algorithm>
#include <bit>
#include <utility>

/// Normals of layers in maps within maps. A normal goes out through the space of every map that its hit has looked at
/// before, up to sixteen of them, each of which waits for the one before: the layers of a hit go side by side.
namespace trace {

using texture::Texture;

void TextureMaps::bend_nested(const Context& context, std::uint32_t at, const Seen& seen)
{
    const texture::TextureSet& set = context.scene.textures;
    bool asks = false;
    for (std::size_t i = at; i < textures_.size(); ++i) {
        const Texture::Kind kind = set.textures[textures_[i].texture].kind;
        if (kind != Texture::Kind::Layers && kind != Texture::Kind::Map && kind != Texture::Kind::Average) return;
        asks |= textures_[i].asks_point;
    }
    if (!asks) return;
    within_.resize(std::max(within_.size(), textures_.size() - at));
    ways_.resize(csg::kTileRays);
    std::size_t count = 0;
    for_each_hit(textures_[at].hits, [&](std::size_t lane) {
        Way& way = ways_[count];
        way.lane = lane;
        way.normal = seen.normals.at(count);
        way.around = seen.around[count];
        way.first = at;
        way.maps.leave_all();
        way.stops.clear();
        enter(set, at, seen.points, count++, way);
    });
    for (std::size_t i = at; i < textures_.size(); ++i)
        if (textures_[i].asks_point) bend_within(set, textures_[i], within_[i - at]);
    for (std::size_t i = 0; i < count; ++i) leave(set, ways_[i]);
    for (std::size_t i = at; i < textures_.size(); ++i) {
        Place& place = textures_[i];
        place.bent |= place.asks_point;
        place.asks_point = false;
    }
}

/// Goes the way that shade() goes, from the texture at `at` on; the hit's point is place k of `points`.
void TextureMaps::enter(const texture::TextureSet& set, std::uint32_t at, const texture::Points& points, std::size_t k,
                        Way& way)
{
    const Place& place = textures_[at];
    const Texture& texture = set.textures[place.texture];
    const std::size_t i = place_of(place.hits, way.lane);
    if (texture.kind == Texture::Kind::Layers) {
        if (!place.asks_point) return;
        Within& within = within_[at - way.first];
        within.points.set(i, points.at(k));
        within.normals.set(i, way.maps.into(set, way.normal));
        within.around[i] = way.around;
        way.stops.push_back({at, i, way.maps.count});
        return;
    }
    way.maps.enter(place.texture);
    const Map& map = maps_[place.first];
    const auto entry = [&](std::uint32_t of) { enter(set, entries_[place.entries + of], map.points, i, way); };
    if (texture.kind == Texture::Kind::Average) {
        for (std::uint32_t of = 0; of < texture.count; ++of) entry(of);
        return;
    }
    entry(map.blends.upper[i]);
    if (map.blends.lower[i] != map.blends.upper[i]) entry(map.blends.lower[i]);
}

/// The layers of a texture bend the normals of its hits, which stay in the space of the maps around them.
void TextureMaps::bend_within(const texture::TextureSet& set, const Place& place, Within& within)
{
    const Texture& texture = set.textures[place.texture];
    within.points.count = within.normals.count = std::popcount(place.hits);
    within.points.pad();
    within.normals.pad();
    for (std::uint32_t depth = 0; depth < (texture.plain ? 1 : texture.count); ++depth) {
        const std::uint32_t normal = set.layers[texture.first + texture.count - 1 - depth].normal;
        if (normal == texture::kNone) continue;
        texture::Points n;
        n.take(within.normals);
        perturb_points(set, normal, within.points, within.around, n);
        texture::normalize_points(n);
        BentNormals& to = layers_[place.first + depth].normals;
        std::copy_n(n.x.data(), n.size(), to.x.data());
        std::copy_n(n.y.data(), n.size(), to.y.data());
        std::copy_n(n.z.data(), n.size(), to.z.data());
    }
}

/// The hit's normals go out through the maps that were looked at before each.
void TextureMaps::leave(const texture::TextureSet& set, const Way& way)
{
    texture::Points n;
    texture::Values reached;
    std::array<std::pair<BentNormals*, std::size_t>, texture::kMostPoints> to;
    const auto run = [&] {
        if (n.count == 0) return;
        for (std::size_t i = n.size(); i % 8 != 0; ++i) reached[i] = reached[n.size() - 1];
        n.pad();
        texture::normals_out_of(set, {way.maps.textures.data(), way.maps.count}, reached, n);
        for (std::size_t i = 0; i < n.size(); ++i) {
            const auto [normals, k] = to[i];
            normals->set(k, n.at(i));
        }
        n.count = 0;
    };
    for (const Way::Stop& stop : way.stops) {
        const Place& place = textures_[stop.at];
        const Texture& texture = set.textures[place.texture];
        for (std::uint32_t depth = 0; depth < (texture.plain ? 1 : texture.count); ++depth) {
            if (set.layers[texture.first + texture.count - 1 - depth].normal == texture::kNone) continue;
            BentNormals& normals = layers_[place.first + depth].normals;
            reached[n.size()] = static_cast<double>(stop.reached);
            to[n.size()] = {&normals, stop.i};
            n.add(normals.at(stop.i));
            if (n.count == texture::kMostPoints) run();
        }
    }
    run();
}

}  // namespace trace
