#pragma once

#include "csg/packet/shaft.h"
#include "render/trace/queue/row_page.h"
#include "render/trace/queue/hit_mask.h"
#include "render/trace/shade/shade_context.h"

#include <optional>
#include <vector>

/// Shadows of an area light on the hits of a tile. Compiled once per instruction set.
namespace trace {

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

    /// What reaches the hits, in `out`; others' places are anything.
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
    void want_all(int i1, int j1, int i2, int j2, int depth);
    void want(int i, int j);
    const TileColors& value(int i, int j) const;
    void ask(HitMask hits);
    void ask(std::uint32_t node, HitMask hits);
    void rectangle(int i1, int j1, int i2, int j2, int depth, HitMask hits, TileColors& out);
    void trace_samples();
    void make_rays();
    void place_on_light();
    void jitter(TileLanes& row, TileLanes& column) const;
    void project();
    void keep(std::size_t first, std::size_t last);
    [[gnu::noinline]] void keep_rests(std::size_t first, std::size_t last);
    [[gnu::noinline]] void keep_filtered(std::size_t first, std::size_t last, HitMask hits, TileColors& value);
    glm::vec3 sample_color(std::size_t ray);

    Context& context_;
    ShadeScratch& scratch_;
    AreaScratch& area_;
    const light::Light& light_;
    const InteriorList* const* interiors_;
    std::optional<csg::Shaft> shaft_;
    bool by_hit_ = false;      ///< the rays of a hit are closer to each other than those to a node
    std::size_t samples_ = 0;  ///< waiting for their shadow rays
    alignas(64) std::array<std::uint32_t, kRays> node_, hit_;  ///< of each
    alignas(64) TileLanes from_;                               ///< where shadow rays of a hit begin
    alignas(64) TileLanes x_, y_, z_, distance_;  ///< of each sample: its offset on the light, then the direction to it
    TileColors color_;                            ///< before shadows
    std::array<light::AreaAxes, kRays> axes_;     ///< by hit, where the light turns to it
    std::array<Rest, kRays> rests_;               ///< by hit, where the light is dimmed (Light::atmosphere)
};

}  // namespace trace
