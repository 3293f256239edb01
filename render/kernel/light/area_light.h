#pragma once

#include "csg/packet/shaft.h"
#include "render/kernel/tile/row_page.h"
#include "render/kernel/tile/hit_mask.h"
#include "render/kernel/context/context.h"

#include <array>
#include <bit>
#include <optional>
#include <vector>

/// Shadows of an area light on the hits of a tile.
namespace trace {

class MediaShadows;

/// The nodes of the area light at hand, for all hits of a tile at once; reused from light to light.
struct AreaScratch {
    std::vector<HitMask> known;        ///< by node that some hit asked for, as below: hits that have been told
    std::vector<HitMask> lit;          ///< of them, those that see it, through nothing
    std::vector<HitMask> mixed;        ///< of them, those that see it through something that filters light
    std::vector<TileColors> filtered;  ///< what reaches those; shorter than the others where nothing does
    std::vector<double> row, column;
    std::vector<glm::dvec3> at;         ///< where it lies on the light, if that is the same for all hits
    std::vector<std::uint32_t> place;   ///< by i * size2 + j: the node, or kNone
    std::vector<std::uint32_t> wanted;  ///< nodes asked for next
    struct Rectangle {
        int i1, j1, i2, j2, depth;  ///< corners; how often it was divided before
        HitMask hits;               ///< that ask for it
    };
    std::vector<Rectangle> level, next_level;
    static constexpr std::uint32_t kNone = 0xffffffffu;
};

/// POV-Ray divides the grid of nodes in four wherever those at its corners differ (spec 3, 12.6). The division is the
/// same for all hits: it is walked once, with the hits as lanes, and every rectangle is divided for those of them that
/// ask for it. The nodes of all four quarters are asked for together, as full tiles of shadow rays. The sums are those
/// of a hit alone in the same order.
class AreaLight {
public:
    /// met: the tile's hits. interiors: by hit, what its shadow rays start inside of. Colours before shadows are in
    /// ShadeScratch::lit_colors.
    AreaLight(Context& context, const light::Light& light, const csg::HitTile& met,
              const InteriorList* const* interiors);

    /// What reaches the hits, in `out`; others' places are anything. Once for a light.
    void shadows(HitMask hits, TileColors& out);

    /// Where the shadow ray of a hit that was asked last has left its last surface behind, and where it ends: for
    /// lights that what fills the scene dims.
    struct Rest {
        glm::dvec3 direction;
        double from, to;
    };
    const Rest& rest(std::size_t k) const { return rests_[k]; }

private:
    static constexpr std::size_t kRays = csg::kTileRays;

    void find_shaft(HitMask hits);
    Rest rest_to_corner(std::size_t k) const;
    bool scattered(HitMask hits) const;
    HitMask bright(HitMask hits) const;
    void refine(HitMask hits);
    template <class F>
    auto with_corners(int i1, int j1, int i2, int j2, HitMask hits, F&& f) const;
    template <class Corners>
    HitMask divided(int i1, int j1, int i2, int j2, int depth, HitMask hits, const Corners& corners) const;
    void want_all(int i1, int j1, int i2, int j2, int depth);
    void want(int i, int j);
    void want_corners(const std::array<int, 4>& quarter);
    struct Quarters;
    std::uint32_t place(int i, int j) const;
    /// What reaches the hits from the four corners of a rectangle.
    struct LitCorners;
    struct MixedCorners;
    template <class Corners>
    void rectangle(int i1, int j1, int i2, int j2, int depth, HitMask hits, const Corners& corners, bool add,
                   TileColors& out);
    void ask(HitMask hits);
    void ask_nodes(HitMask hits);
    void ask(std::uint32_t node, HitMask hits);
    /// Puts the mean over a rectangle into `out`, or adds it to what is there.
    void rectangle(int i1, int j1, int i2, int j2, int depth, HitMask hits, bool add, TileColors& out);
    void trace_samples();
    void make_rays();
    glm::dvec3 node_place(int i, int j) const;
    void place_on_light();
    void jitter(TileLanes& row, TileLanes& column) const;
    void project();
    /// Samples of one node, which wait side by side: for these hits, in order.
    struct Asked {
        HitMask hits;
        std::uint32_t node, first;
        std::size_t last() const { return first + static_cast<std::size_t>(std::popcount(hits)); }
    };
    [[gnu::noinline]] void keep_rests(const Asked& asked);
    [[gnu::noinline]] void find_filters(HitMask samples);
    [[gnu::noinline]] void keep_filtered(const Asked& asked, HitMask hits);
    [[gnu::noinline]] void dim_by_media();
    glm::vec3 sample_color(std::size_t ray);

    Context& context_;
    ShadeScratch& scratch_;
    AreaScratch& area_;
    const light::Light& light_;
    const InteriorList* const* interiors_;
    MediaShadows* later_ = nullptr;  ///< receives, by sample, stretches of media between the hits and the light
    std::optional<csg::Shaft> shaft_;
    bool by_hit_ = false;      ///< the rays of a hit are closer to each other than those to a node
    bool same_places_;         ///< of a node, whatever hit asks
    bool by_level_ = false;    ///< all nodes are asked for by levels of rectangles before any is summed up
    std::size_t samples_ = 0;  ///< waiting for their shadow rays
    std::size_t lanes_ = 0;    ///< as many, up to a multiple of 8: those behind the last are like the first
    std::size_t asked_count_ = 0;
    std::array<Asked, kRays> asked_;                        ///< they belong to
    alignas(64) std::array<std::uint32_t, kRays> hit_;      ///< of each sample
    std::array<std::uint32_t, kRays> node_;                 ///< of each sample whose light is filtered
    alignas(64) std::array<std::uint64_t, kRays> purpose_;  ///< of its first random number, of lights with jitter
    alignas(64) TileLanes row_, column_;                    ///< of its node
    alignas(64) TileLanes from_;                            ///< where shadow rays of a hit begin
    alignas(64) TileLanes x_, y_, z_, distance_;  ///< of each sample: its offset on the light, and how far it is
    TileColors color_;                            ///< before shadows
    HitMask bright_ = 0;                          ///< hits where all of it is a difference to refine
    bool grey_ = false;                        ///< its channels are alike, and nothing filters it: they are summed once
    std::array<light::AreaAxes, kRays> axes_;  ///< by hit, where the light turns to it
    std::array<Rest, kRays> rests_;            ///< by hit, where the light is dimmed (Light::atmosphere)
};

}  // namespace trace
