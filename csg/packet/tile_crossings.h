#pragma once

#include "csg/packet/tile_query.h"

/// All crossings of transparent surfaces by the shadow rays of a tile.
namespace csg {

/// Puts a ray's crossings nearest first; equal distances in one fixed order, whatever order the walk had.
inline void sort_crossings(Hit* hits, std::size_t count)
{
    const auto before = [](const Hit& a, const Hit& b) {
        return a.t != b.t ? a.t < b.t : a.part != b.part ? a.part < b.part : a.face < b.face;
    };
    constexpr std::size_t kFew = 32;
    if (count > kFew) {
        std::sort(hits, hits + count, before);
        return;
    }
    for (std::size_t i = 1; i < count; ++i) {
        const Hit hit = hits[i];
        std::size_t k = i;
        for (; k > 0 && before(hit, hits[k - 1]); --k) hits[k] = hits[k - 1];
        hits[k] = hit;
    }
}

/// A query of TileLeaf. A ray that meets an opaque surface is done: its limit becomes -infinity.
template <class Rays>
class CrossingsOfTile {
public:
    CrossingsOfTile(const WorldData& world, Rays& rays, Scratch& scratch, CrossingTile& out)
        : world_(world), rays_(rays), scratch_(scratch), out_(out)
    {
        out.ending.fill(Shadow::Clear);
        out.count.fill(0);
    }

    void each(std::uint32_t index, int i)
    {
        const auto k = static_cast<std::size_t>(i);
        item_in_the_way(
            world_, world_.items[index], rays_.ray(i), rays_.t_min[k], rays_.limit[k], scratch_, nullptr,
            [&] { block(k); }, [&](const Hit& hit) { add(k, hit); });
    }

    template <class At>
    void solid(std::uint32_t index, RayMask mask, At&& at)
    {
        const WorldItem& item = world_.items[index];
        const SurfaceId surface = world_.store.surface(item.solid);
        const bool opaque = world_.surface_opaque[surface] != 0;
        each_vector(mask, [&](int i) {
            const lanes::Intervals in = at(i);
            if (lanes::mask(in.met) == 0) return;
            const SeenEnds seen(rays_, i, in);
            if (opaque) return block_all(RayMask{lanes::mask(seen.entry | seen.exit)} << i);
            offer(lanes::mask(seen.entry), in.entry, in.entry_face, i, surface, item);
            offer(lanes::mask(seen.exit), in.exit, in.exit_face, i, surface, item);
        });
    }

    double guarded_until(std::size_t k) const { return rays_.limit[k]; }
    static bool first_only(const WorldItem& item) { return item.all_opaque; }
    static constexpr bool any_will_do() { return true; }
    void block_all(RayMask rays)
    {
        each_ray(rays, [this](std::size_t k) { block(k); });
    }
    void hit(std::uint32_t index, std::size_t k, const Hit& found)
    {
        if (world_.items[index].all_opaque) block(k);
        else add(k, found);
    }
    void record(std::uint32_t index, std::size_t k, const IntersectionList& told)
    {
        const WorldItem& item = world_.items[index];
        drawn_ends(told, rays_.t_min[k], rays_.limit[k], [&](double t, std::uint32_t face) {
            if (item.all_opaque) block(k);
            else add(k, Hit{t, world_.store.surface(item.solid, face), item.solid, face, normal_flipped(world_, item)});
        });
    }

    Scratch& scratch() const { return scratch_; }

    static bool lanes_serve(const WorldItem& item) { return item.all_opaque || item.simple; }
    static void ask(LaneFront<Rays>& front, const WorldItem& item, const SumOfProducts& form, RayMask mask)
    {
        if (item.all_opaque) front.ask(form, mask);
        else if (item.plain) front.ask_ends(form, mask);
        else front.ask_all(form, mask);
    }

    void program(std::uint32_t index, const LaneFront<Rays>& front)
    {
        const WorldItem& item = world_.items[index];
        const SumOfProducts& form = world_.programs[item.program].products;
        for (RayMask left = front.found; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            if (item.all_opaque) {
                block(k);
                continue;
            }
            if (!item.plain) {
                if (!front.each_crossing(k, [&](double t, const LeafEnd& at) { end(k, form, t, at); }))
                    each(index, static_cast<int>(k));
                continue;
            }
            end(k, form, front.entry(k), front.entry_end(k));
            end(k, form, front.exit(k), front.exit_end(k));
        }
    }

    void finish()
    {
        for (std::size_t k = 0; k < static_cast<std::size_t>(rays_.count); ++k)
            if (out_.ending[k] == Shadow::Filtered && out_.count[k] != CrossingTile::kTooMany)
                sort_crossings(out_.hits[k].data(), out_.count[k]);
    }

private:
    void block(std::size_t k)
    {
        out_.ending[k] = Shadow::Blocked;
        rays_.limit[k] = -kInfinity;
    }

    void add(std::size_t k, const Hit& hit)
    {
        if (world_.surface_opaque[hit.surface] != 0) return block(k);
        if (out_.ending[k] == Shadow::Clear) out_.ending[k] = Shadow::Filtered;
        if (out_.count[k] >= CrossingTile::kMost) out_.count[k] = CrossingTile::kTooMany;
        else out_.hits[k][out_.count[k]++] = hit;
    }

    void end(std::size_t k, const SumOfProducts& form, double t, const LeafEnd& at)
    {
        if (!(t >= rays_.t_min[k] && t <= rays_.limit[k] && t < kInfinity && t > -kInfinity)) return;
        const ProductLeaf& leaf = form.leaves[at.leaf];
        add(k, {t, world_.store.surface(leaf.solid), leaf.solid, at.face, leaf.normal_flipped});
    }

    void offer(std::uint32_t which, lanes::Double t, lanes::Double face, int i, SurfaceId surface,
               const WorldItem& item)
    {
        if (which == 0) return;
        alignas(64) double at[lanes::kDoubles], side[lanes::kDoubles];
        t.store_aligned(at);
        face.store_aligned(side);
        for (; which != 0; which &= which - 1) {
            const int lane = std::countr_zero(which);
            const auto k = static_cast<std::size_t>(i + lane);
            if (rays_.limit[k] < 0.0) continue;  // blocked meanwhile
            add(k,
                {at[lane], surface, item.solid, static_cast<std::uint32_t>(side[lane]), normal_flipped(world_, item)});
        }
    }

    const WorldData& world_;
    Rays& rays_;
    Scratch& scratch_;
    CrossingTile& out_;
};

}  // namespace csg
