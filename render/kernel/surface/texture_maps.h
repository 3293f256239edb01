#pragma once

#include "render/texture/map_points.h"
#include "render/texture/shown.h"
#include "render/kernel/tile/hit_mask.h"
#include "render/kernel/tile/layer_points.h"
#include "render/kernel/tile/row_page.h"

#include <bit>
#include <deque>
#include <vector>

namespace trace {

class DirectBatch;
struct Context;
struct HitContext;
using ColorSlot = std::uint32_t;

/// Which of the hits are hit k's.
inline std::size_t place_of(HitMask hits, std::size_t k)
{
    return static_cast<std::size_t>(std::popcount(hits & ((HitMask{1} << k) - 1)));
}

/// Texture maps of a tile's hits, looked up for all of them before they are gone through one by one: values of
/// patterns, and pigments and normals of the layers that the maps lead to. Every texture of a map takes the hits that
/// show it, which lie side by side.
class TextureMaps {
public:
    /// Forgets the tile before.
    void clear() { textures_.clear(), entries_.clear(), maps_used_ = layers_used_ = 0; }

    /// What the hits show of a texture with a map; p, around and normals (turned to the viewer) stand in their order.
    /// Its place among the textures.
    std::uint32_t look_up(const Context& context, std::uint32_t texture, HitMask hits, const texture::Points& p,
                          const texture::Around& around, const texture::Points& normals);

    /// Right after look_up(): rows of light for the hits that show nothing that rays go on from, which are returned.
    /// No layer may have more than colour, diffuse light and highlights (plan::PatternedLayers::alone).
    HitMask lay_rows(const Context& context, DirectBatch& batch, std::uint32_t at);

    /// Once all lights have been added: the colours of those hits.
    void mix(const Context& context, std::uint32_t at, TileColors& out) const;

    /// shade_texture() of hit `hit.lane` by what has been looked up; `at`: from look_up(). Its point is place `k` of
    /// `points`, and is read where something still asks for it.
    void shade(Context& context, DirectBatch& batch, HitContext& hit, std::uint32_t at, const texture::Points& points,
               std::size_t k, ColorSlot out) const;

private:
    /// A texture and the hits that show it.
    struct Place {
        std::uint32_t texture;
        HitMask hits;
        std::size_t first = 0;    ///< of maps: in maps_; of layers: the top one's, in layers_
        std::size_t entries = 0;  ///< of maps: the first one's, in entries_
        bool bent = false;        ///< of layers: normals are known too, at the same places
        bool asks_point = false;  ///< of layers: normals are yet to be bent, at a point
        HitMask open = 0;         ///< of layers: hits that light passes
        std::size_t page = 0;     ///< of layers: where the top one's rows lie
    };
    struct Map {
        texture::Points points;  ///< warped
        texture::BlendPoints blends;
    };
    /// Hits as patterns see them, in order.
    struct Seen {
        const texture::Points& points;
        const texture::Around& around;
        const texture::Points& normals;
        const texture::Texture* map = nullptr;  ///< whose space the normals are in; null: they are not to be bent
        bool nested = false;                    ///< in the map of another map: what was looked at before counts
    };
    struct Part;

    void mix_layers(const Context& context, const Place& place, std::uint32_t layers, TileColors& out) const;
    void begin_map(const texture::TextureSet& set, std::size_t at, const Seen& seen, texture::Points& q);
    static const texture::Texture* bent_within(const Context& context, const texture::Texture& map, const Seen& seen,
                                               texture::Points& normals);
    void look_up_average(const Context& context, std::size_t at, const Seen& seen);
    void look_up_map(const Context& context, std::size_t at, const Seen& seen);
    void look_up_layers(const Context& context, std::size_t at, const Seen& seen);
    std::uint32_t look_up(const Context& context, std::uint32_t texture, HitMask hits, const Seen& seen);
    static void bend(const texture::TextureSet& set, std::uint32_t normal, const Seen& seen, HitMask hits,
                     BentNormals& to);

    // Normals of layers in maps within maps (nested_normals.cpp).

    /// A texture's hits where its layers bend their normals: in the space of the maps around it.
    struct Within {
        texture::Points points, normals;
        texture::Around around;
    };
    /// A hit's way through the maps.
    struct Way {
        /// A texture of layers on it.
        struct Stop {
            std::uint32_t at;     ///< its place
            std::size_t i;        ///< the hit's place there
            std::size_t reached;  ///< so many of `maps` were looked at before
        };
        std::size_t lane = 0;
        glm::dvec3 normal{0};  ///< of the surface
        const texture::Surroundings* around = nullptr;
        std::uint32_t first = 0;  ///< place of the outermost map
        texture::Enclosing maps;
        std::vector<Stop> stops;
    };
    void bend_nested(const Context& context, std::uint32_t at, const Seen& seen);
    void enter(const texture::TextureSet& set, std::uint32_t at, const texture::Points& points, std::size_t k,
               Way& way);
    void bend_within(const texture::TextureSet& set, const Place& place, Within& within);
    void leave(const texture::TextureSet& set, const Way& way);

    std::vector<Place> textures_;
    std::vector<std::uint32_t> entries_;  ///< of maps: places of their textures, or texture::kNone
    std::deque<Map> maps_;                ///< so many of them in use, as of layers; they stay for the next tile
    std::vector<LayerPoints> layers_;
    std::vector<HitMask> asked_;  ///< by layer: hits that have a row of it
    std::vector<Within> within_;  ///< by place since the outermost map's
    std::vector<Way> ways_;       ///< by hit
    std::size_t maps_used_ = 0, layers_used_ = 0;
};

}  // namespace trace
