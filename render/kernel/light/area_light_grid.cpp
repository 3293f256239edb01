#include "render/kernel/light/area_light.h"

#include "numbers/lane_equal.h"
#include "numbers/float_mask.h"
#include "render/kernel/tile/tile_parts.h"

#include <cmath>
#include <utility>

// How the grid of an area light's nodes is divided, and what its parts sum up to.
namespace trace {
namespace {

constexpr float kRefined = 0.1f;  // neighbouring samples that differ by more are refined (spec 3, 12.6)

/// The hits whose colours in a and b differ by more than kRefined. Other hits of the same rows of the tile may be set
/// too.
HitMask differ(HitMask hits, const TileColors& a, const TileColors& b)
{
    alignas(64) std::array<std::uint32_t, csg::kTileRays> far{};
    for (std::size_t first = 0; first < csg::kTileRays; first += csg::kTileSide) {
        if ((hits >> first & 0xff) == 0) continue;
        for (std::size_t k = first; k < first + csg::kTileSide; ++k) {
            const float d = std::abs(a.red[k] - b.red[k]) + std::abs(a.green[k] - b.green[k]) +
                            std::abs(a.blue[k] - b.blue[k]);
            far[k] = d > kRefined ? 1u : 0u;
        }
    }
    return numbers::lanes::equal(far, 1u);
}

}  // namespace

/// Wants all nodes down to the level that is divided in any case (`adaptive`).
void AreaLight::want_all(int i1, int j1, int i2, int j2, int depth)
{
    want(i1, j1), want(i2, j1), want(i1, j2), want(i2, j2);
    if (depth >= light_.adaptive || !(i2 - i1 > 1 || j2 - j1 > 1)) return;
    const int i_low = (i1 + i2) / 2, i_high = (i1 + i2 + 1) / 2, j_low = (j1 + j2) / 2, j_high = (j1 + j2 + 1) / 2;
    want_all(i1, j1, i_low, j_low, depth + 1);
    want_all(i_high, j1, i2, j_low, depth + 1);
    want_all(i1, j_high, i_low, j2, depth + 1);
    want_all(i_high, j_high, i2, j2, depth + 1);
}

/// The four parts of a rectangle, which share no nodes where there are enough.
struct AreaLight::Quarters {
    std::array<std::array<int, 4>, 4> of;

    Quarters(int i1, int j1, int i2, int j2)
    {
        const int i_low = (i1 + i2) / 2, i_high = (i1 + i2 + 1) / 2, j_low = (j1 + j2) / 2, j_high = (j1 + j2 + 1) / 2;
        of = {{{i1, j1, i_low, j_low}, {i_high, j1, i2, j_low}, {i1, j_high, i_low, j2}, {i_high, j_high, i2, j2}}};
    }
};

void AreaLight::want_corners(const std::array<int, 4>& q)
{
    want(q[0], q[1]), want(q[2], q[1]), want(q[0], q[3]), want(q[2], q[3]);
}

/// The corners of a rectangle that each hit sees either fully or not at all: masks are enough.
struct AreaLight::LitCorners {
    const TileColors& color;
    std::array<HitMask, 4> lit;

    HitMask differing(HitMask, HitMask bright) const
    {
        return bright & ((lit[0] ^ lit[1]) | (lit[0] ^ lit[2]) | (lit[3] ^ lit[1]) | (lit[3] ^ lit[2]));
    }
    /// f(channel number, its mean) for a register of hits.
    template <class F>
    void mean(std::size_t first, std::size_t channels, F&& f) const
    {
        const FloatMask a(lit[0] >> first), b(lit[1] >> first), c(lit[2] >> first), d(lit[3] >> first);
        for (std::size_t n = 0; n < channels; ++n) {
            const FloatPart v = FloatPart::load_aligned((color.*kChannels[n]).data() + first);
            f(n, (a.kept(v) + b.kept(v) + c.kept(v) + d.kept(v)) * FloatPart(0.25f));
        }
    }
};

/// The corners of a rectangle where something filters the light on its way to some hit: colours.
struct AreaLight::MixedCorners {
    std::array<TileColors, 4> of;

    HitMask differing(HitMask hits, HitMask) const
    {
        return differ(hits, of[0], of[1]) | differ(hits, of[0], of[2]) | differ(hits, of[3], of[1]) |
               differ(hits, of[3], of[2]);
    }
    template <class F>
    void mean(std::size_t first, std::size_t channels, F&& f) const
    {
        for (std::size_t n = 0; n < channels; ++n) {
            const auto at = [&](std::size_t c) {
                return FloatPart::load_aligned((of[c].*kChannels[n]).data() + first);
            };
            f(n, (at(0) + at(1) + at(2) + at(3)) * FloatPart(0.25f));
        }
    }
};

/// Calls f with the rectangle's LitCorners, or with its MixedCorners if light is filtered for one of these hits.
template <class F>
auto AreaLight::with_corners(int i1, int j1, int i2, int j2, HitMask hits, F&& f) const
{
    const std::array<std::uint32_t, 4> nodes = {place(i1, j1), place(i2, j1), place(i1, j2), place(i2, j2)};
    LitCorners corners{color_, {}};
    HitMask mixed = 0;
    for (std::size_t c = 0; c < nodes.size(); ++c) {
        corners.lit[c] = area_.lit[nodes[c]];
        mixed |= area_.mixed[nodes[c]];
    }
    if ((mixed & hits) == 0) return f(corners);
    MixedCorners values;
    each_part(hits, [&](std::size_t first) {
        for (std::size_t c = 0; c < nodes.size(); ++c) {
            const HitMask through = area_.mixed[nodes[c]] >> first;
            const FloatMask lit(corners.lit[c] >> first), filtered(through);
            for (const auto channel : kChannels) {
                FloatPart v = lit.kept(FloatPart::load_aligned((color_.*channel).data() + first));
                if (through != 0)
                    v = filtered.chosen(FloatPart::load_aligned((area_.filtered[nodes[c]].*channel).data() + first), v);
                v.store_aligned((values.of[c].*channel).data() + first);
            }
        }
    });
    return f(values);
}

/// The hits for which the rectangle is divided.
template <class Corners>
HitMask AreaLight::divided(int i1, int j1, int i2, int j2, int depth, HitMask hits, const Corners& corners) const
{
    if (!(i2 - i1 > 1 || j2 - j1 > 1)) return 0;
    return depth >= light_.adaptive ? hits & corners.differing(hits, bright_) : hits;
}

/// Asks for all nodes that the hits need, a level of rectangles after the other: their samples fill tiles.
void AreaLight::refine(HitMask hits)
{
    area_.level.assign(1, {0, 0, light_.size1 - 1, light_.size2 - 1, 0, hits});
    while (!area_.level.empty()) {
        area_.next_level.clear();
        for (const auto& now : area_.level) {  // bindings would not reach into the lambda: clang 14 refuses
            const HitMask some = with_corners(now.i1, now.j1, now.i2, now.j2, now.hits, [&](const auto& corners) {
                return divided(now.i1, now.j1, now.i2, now.j2, now.depth, now.hits, corners);
            });
            if (some == 0) continue;
            const Quarters quarters(now.i1, now.j1, now.i2, now.j2);
            if (now.depth >= light_.adaptive) {
                for (const auto& q : quarters.of) want_corners(q);
                ask_nodes(some);
            }
            for (const auto& q : quarters.of)
                if (q[2] - q[0] > 1 || q[3] - q[1] > 1)
                    area_.next_level.push_back({q[0], q[1], q[2], q[3], now.depth + 1, some});
        }
        trace_samples();
        std::swap(area_.level, area_.next_level);
    }
}

void AreaLight::rectangle(int i1, int j1, int i2, int j2, int depth, HitMask hits, bool add, TileColors& out)
{
    with_corners(i1, j1, i2, j2, hits,
                 [&](const auto& corners) { rectangle(i1, j1, i2, j2, depth, hits, corners, add, out); });
}

template <class Corners>
void AreaLight::rectangle(int i1, int j1, int i2, int j2, int depth, HitMask hits, const Corners& corners, bool add,
                          TileColors& out)
{
    const HitMask some = divided(i1, j1, i2, j2, depth, hits, corners);
    TileColors sum;
    if (some != 0) {
        const Quarters quarters(i1, j1, i2, j2);
        if (depth >= light_.adaptive && !by_level_) {
            for (const auto& q : quarters.of) want_corners(q);
            ask(some);
        }
        bool more = false;
        for (const auto& q : quarters.of)
            rectangle(q[0], q[1], q[2], q[3], depth + 1, some, std::exchange(more, true), sum);
    }
    constexpr HitMask kPart = (HitMask{1} << kFloatPart) - 1;
    each_part(hits, [&](std::size_t first) {
        const HitMask here = some >> first & kPart;
        const FloatMask of_quarters(here);
        corners.mean(first, grey_ ? 1 : kChannels.size(), [&](std::size_t n, FloatPart v) {
            if (here != 0)
                v = of_quarters.chosen(FloatPart::load_aligned((sum.*kChannels[n]).data() + first) * FloatPart(0.25f),
                                       v);
            float* at = (out.*kChannels[n]).data() + first;
            if (add) v = FloatPart::load_aligned(at) + v;
            v.store_aligned(at);
        });
    });
}

/// Hits where a corner that sees the light differs enough from one that does not.
HitMask AreaLight::bright(HitMask hits) const
{
    TileColors dark;
    dark.fill(0.0f);
    return differ(hits, color_, dark);
}

}  // namespace trace
