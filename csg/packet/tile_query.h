#pragma once

#include "numbers/lane_equal.h"
#include "csg/solids/shared/slab.h"
#include "csg/packet/packet_walk.h"
#include "csg/packet/tile_leaf.h"

/// The two questions a tile asks, in vector lanes where the solid allows it: its test is a template, so that the
/// answers are those of one ray to the last bit.
namespace csg {

/// Which ends of the intervals can be seen between t_min and limit.
struct SeenEnds {
    lanes::Double t_min, limit;
    lanes::Bool entry, exit;

    template <class Rays>
    SeenEnds(const Rays& rays, int i, const lanes::Intervals& in)
        : t_min(lanes::Double::load_aligned(rays.t_min.data() + i)),
          limit(lanes::Double::load_aligned(rays.limit.data() + i)), entry(in.met & seen(in.entry, in.entry_face)),
          exit(in.met & seen(in.exit, in.exit_face))
    {}

private:
    lanes::Bool seen(lanes::Double t, lanes::Double face) const
    {
        return (t >= t_min) & (t <= limit) & (t > lanes::before()) & (t < lanes::beyond()) &
               (face != lanes::Double(static_cast<double>(kUndrawnFace)));
    }
};

/// f(t, face) for what a lone freeform solid draws between the ends: as solid_crossings() offers it.
template <class F>
inline void drawn_ends(const IntersectionList& record, double t_min, double limit, F&& f)
{
    const auto offer = [&](double t, std::uint32_t face) {
        if (t >= t_min && t <= limit && face != kUndrawnFace && t < kInfinity && t > -kInfinity) f(t, face);
    };
    record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
        offer(in, in_face);
        offer(out, out_face);
    });
    record.each_touching(offer);
}

/// The nearest hit of every ray.
template <class Rays>
class NearestOfTile {
public:
    NearestOfTile(const WorldData& world, Rays& rays, Scratch& scratch, HitTile& out)
        : world_(world), rays_(rays), scratch_(scratch), out_(out)
    {
        const int places = rays.groups * kRayGroup;
        std::fill_n(out.t.begin(), places, kInfinity);
        std::fill_n(out.surface.begin(), places, kNoSurface);
        std::fill_n(item_.begin(), places, kNone);
        std::fill_n(nearer_.begin(), places, kInfinity);
        if constexpr (Rays::kShared) std::fill_n(reach_.begin(), places, Nearest::reach_of(rays.origin));
        else
            for (std::size_t k = 0; k < static_cast<std::size_t>(rays.count); ++k)
                reach_[k] = Nearest::reach_of(rays.origin_of(k));
    }

    void each(std::uint32_t index, int i)
    {
        const auto k = static_cast<std::size_t>(i);
        offer(index, k,
              item_nearest(world_, world_.items[index], rays_.ray(i), rays_.t_min[k], rays_.limit[k], scratch_));
    }

    static double guarded_until(std::size_t) { return kInfinity; }
    static bool first_only(const WorldItem&) { return true; }
    static constexpr bool any_will_do() { return false; }
    void hit(std::uint32_t index, std::size_t k, const Hit& found) { offer(index, k, found); }
    void record(std::uint32_t index, std::size_t k, const IntersectionList& told)
    {
        const WorldItem& item = world_.items[index];
        Hit hit;
        double limit = rays_.limit[k];
        drawn_ends(told, rays_.t_min[k], limit, [&](double t, std::uint32_t face) {
            if (t > limit) return;
            limit = hit.t = t;
            hit.face = face;
            hit.part = item.solid;
        });
        if (!(hit.t < kInfinity)) return;
        hit.surface = world_.store.surface(item.solid);
        hit.inverted = normal_flipped(world_, item);
        offer(index, k, hit);
    }

    template <class At>
    void solid(std::uint32_t index, RayMask mask, At&& at)
    {
        using lanes::Double;
        const Double id(static_cast<double>(index));
        each_vector(mask, [&](int i) {
            const lanes::Intervals in = at(i);
            if (lanes::mask(in.met) == 0) return;
            const SeenEnds seen(rays_, i, in);
            // Of equal ends the last generated is seen (spec 5a, 2.1).
            const auto second = seen.exit & ((!seen.entry) | (in.exit <= in.entry));
            const Double t = xsimd::select(second, in.exit, in.entry),
                         face = xsimd::select(second, in.exit_face, in.entry_face);
            const Double nearer = Double::load_aligned(nearer_.data() + i),
                         item = Double::load_aligned(item_.data() + i);
            const auto any = seen.entry | seen.exit, before = t < nearer;
            note_ties(i, index, lanes::mask(any & before), lanes::mask(any & !before));
            const auto wins = any & (before | (id < item));
            if (lanes::mask(wins) == 0) return;
            const Double room = Tolerance::same_place(t, Double::load_aligned(reach_.data() + i));
            xsimd::select(wins, t, Double::load_aligned(out_.t.data() + i)).store_aligned(out_.t.data() + i);
            xsimd::select(wins, xsimd::min(seen.limit, t + room), seen.limit).store_aligned(rays_.limit.data() + i);
            xsimd::select(wins, t - room, nearer).store_aligned(nearer_.data() + i);
            xsimd::select(wins, id, item).store_aligned(item_.data() + i);
            xsimd::select(wins, face, Double::load_aligned(face_.data() + i)).store_aligned(face_.data() + i);
        });
    }

    static bool lanes_serve(const WorldItem&) { return true; }
    static void ask(LaneFront<Rays>& front, const WorldItem&, const SumOfProducts& form, RayMask mask)
    {
        front.ask(form, mask);
    }

    void program(std::uint32_t index, const LaneFront<Rays>& front)
    {
        for (RayMask left = front.found; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            const double t = front.t[k];
            if (t > rays_.limit[k] || !wins_against(k, index, t)) continue;
            out_.t[k] = t;
            face_[k] = front.end[k];
            win(k, index, t);
        }
    }

    /// Rays whose nearest hit shares its place with another object's, and which.
    RayMask tied() const { return tied_; }
    Tie tie(std::size_t ray) const { return {item(ray), other_[ray]}; }
    /// Of a ray that hit something.
    std::uint32_t item(std::size_t ray) const { return static_cast<std::uint32_t>(item_[ray]); }

    /// What lanes found is only a number and a face, or an end of a leaf, while the walk lasts.
    void finish()
    {
        const RayMask all = rays_.all(), none = all & lanes::equal(item_, kNone),
                      known = all & lanes::equal(face_, kKnown);
        each_ray(none, [&](std::size_t k) { out_.set(static_cast<int>(k), {}); });
        for (RayMask left = all & ~none & ~known; left != 0;) {
            const double id = item_[static_cast<std::size_t>(std::countr_zero(left))];
            const RayMask group = left & lanes::equal(item_, id);
            const WorldItem& item = world_.items[static_cast<std::size_t>(id)];
            if (item.solid == kNoPart) finish_program(world_.programs[item.program].products, group);
            else finish_solid(item, group);
            left &= ~group;
        }
    }

    Scratch& scratch() const { return scratch_; }

private:
    void offer(std::uint32_t index, std::size_t k, const Hit& hit)
    {
        if (!hit.found() || hit.t > rays_.limit[k] || !wins_against(k, index, hit.t)) return;
        out_.set(static_cast<int>(k), hit);
        face_[k] = kKnown;
        win(k, index, hit.t);
    }

    /// Rays for which something lies before all that they met, and rays for which it lies in the same place.
    void note_ties(int first, std::uint32_t index, std::uint32_t before, std::uint32_t beside)
    {
        tied_ &= ~(RayMask{before} << first);
        each_ray(RayMask{beside} << first, [&](std::size_t k) { note_tie(k, index); });
    }
    void note_tie(std::size_t k, std::uint32_t index)
    {
        other_[k] = (tied_ >> k & 1) != 0 ? Tie::kSeveral : std::max(index, item(k));
        tied_ |= RayMask{1} << k;
    }
    bool wins_against(std::size_t k, std::uint32_t index, double t)
    {
        if (t < nearer_[k]) {
            tied_ &= ~(RayMask{1} << k);
            return true;
        }
        note_tie(k, index);
        return static_cast<double>(index) < item_[k];
    }

    void win(std::size_t k, std::uint32_t index, double t)
    {
        item_[k] = static_cast<double>(index);
        const double room = Tolerance::same_place(t, reach_[k]);
        rays_.limit[k] = std::min(rays_.limit[k], t + room);
        nearer_[k] = t - room;
    }

    void finish_program(const SumOfProducts& form, RayMask rays)
    {
        each_ray(rays, [&](std::size_t k) {
            const LeafEnd end(face_[k]);
            const ProductLeaf& leaf = form.leaves[end.leaf];
            out_.set(static_cast<int>(k),
                     {out_.t[k], world_.store.surface(leaf.solid), leaf.solid, end.face, leaf.normal_flipped});
        });
    }

    void finish_solid(const WorldItem& item, RayMask rays)
    {
        const SurfaceId surface = world_.store.surface(item.solid);
        const std::uint8_t inverted = normal_flipped(world_, item) ? 1 : 0;
        each_ray(rays, [&](std::size_t k) {
            out_.surface[k] = surface;
            out_.part[k] = item.solid;
            out_.face[k] = static_cast<std::uint32_t>(face_[k]);
            out_.instance[k] = Hit::kNoInstance;
            out_.inverted[k] = inverted;
        });
    }

    static constexpr double kNone = 4294967295.0, kKnown = -1.0;
    const WorldData& world_;
    Rays& rays_;
    Scratch& scratch_;
    HitTile& out_;
    RayMask tied_ = 0;
    std::array<std::uint32_t, kTileRays> other_;  ///< of tied rays: the item that is not the winner
    alignas(64) RayLanes item_;                   ///< the winner's place in the order of items
    alignas(64) RayLanes nearer_;                 ///< before this nothing is in the same place as the winner
    alignas(64) RayLanes reach_;                  ///< Nearest::reach of the ray
    alignas(64) RayLanes face_;                   ///< kKnown: `out` has the whole hit already
};

/// Whether every ray is blocked. A blocked ray's limit becomes -infinity: it is done.
template <class Rays>
class ShadowOfTile {
public:
    ShadowOfTile(const WorldData& world, Rays& rays, Scratch& scratch) : world_(world), rays_(rays), scratch_(scratch)
    {}

    void each(std::uint32_t index, int i)
    {
        const auto k = static_cast<std::size_t>(i);
        item_in_the_way(
            world_, world_.items[index], rays_.ray(i), rays_.t_min[k], rays_.limit[k], scratch_, nullptr,
            [&] { note_hit(RayMask{1} << i, true); },
            [&](const Hit& hit) { note_hit(RayMask{1} << i, world_.surface_opaque[hit.surface] != 0); });
    }

    template <class At>
    void solid(std::uint32_t index, RayMask mask, At&& at)
    {
        const bool opaque = world_.surface_opaque[world_.store.surface(world_.items[index].solid)] != 0;
        each_vector(mask, [&](int i) {
            const lanes::Intervals in = at(i);
            if (lanes::mask(in.met) == 0) return;
            const SeenEnds seen(rays_, i, in);
            note_hit(static_cast<RayMask>(lanes::mask(seen.entry | seen.exit)) << i, opaque);
        });
    }

    double guarded_until(std::size_t k) const { return rays_.limit[k]; }
    static bool first_only(const WorldItem& item) { return item.all_opaque; }
    static constexpr bool any_will_do() { return true; }
    void block_all(RayMask rays) { note_hit(rays, true); }
    void hit(std::uint32_t, std::size_t k, const Hit& found)
    {
        note_hit(RayMask{1} << k, world_.surface_opaque[found.surface] != 0);
    }
    void record(std::uint32_t index, std::size_t k, const IntersectionList& told)
    {
        bool met = false;
        drawn_ends(told, rays_.t_min[k], rays_.limit[k], [&](double, std::uint32_t) { met = true; });
        if (met) note_hit(RayMask{1} << k, world_.surface_opaque[world_.store.surface(world_.items[index].solid)] != 0);
    }

    Scratch& scratch() const { return scratch_; }

    /// One crossing is enough where every surface stops light.
    static bool lanes_serve(const WorldItem& item) { return item.all_opaque; }
    static void ask(LaneFront<Rays>& front, const WorldItem&, const SumOfProducts& form, RayMask mask)
    {
        front.ask(form, mask);
    }
    void program(std::uint32_t, const LaneFront<Rays>& front) { note_hit(front.found, true); }

    Shadow answer(int i) const
    {
        const RayMask bit = RayMask{1} << i;
        return (blocked_ & bit) != 0 ? Shadow::Blocked : (filtered_ & bit) != 0 ? Shadow::Filtered : Shadow::Clear;
    }

private:
    void note_hit(RayMask rays, bool opaque)
    {
        (opaque ? blocked_ : filtered_) |= rays;
        for (; opaque && rays != 0; rays &= rays - 1)
            rays_.limit[static_cast<std::size_t>(std::countr_zero(rays))] = -kInfinity;
    }

    const WorldData& world_;
    Rays& rays_;
    Scratch& scratch_;
    RayMask blocked_ = 0, filtered_ = 0;
};

/// Asks everything of the query: unbounded items first, then the hierarchy by beam. False: nothing was asked, the rays
/// are too far apart.
template <class Rays, class Query>
inline bool ask_tile(const WorldData& world, Rays& rays, std::uint32_t kinds, Query& query)
{
    const Beam beam(rays, world.bvh.bounds);
    if (!beam.narrow()) return false;
    LaneFront<Rays> front(world.store, beam, rays);
    PackedBoolean<Rays> boolean(world.store, rays);
    TileLeaf<Rays, Query> leaf{world, &beam, rays, query, kinds, front, boolean};
    for (const std::uint32_t item : world.unbounded) leaf.item(item, rays.all());
    // Rays from an eye are mostly those of neighbouring pixels; points that ask for a lamp may lie anywhere.
    const Spread spread = !Rays::kShared || query.any_will_do() ? Spread::Scattered
                          : beam.slim()                         ? Spread::Neighbours
                                                                : Spread::FromOnePoint;
    TileWalk(world.bvh, beam, rays, kinds, leaf).run(spread);
    return true;
}

/// The same of rays that form no beam.
template <class Rays, class Query>
inline void ask_packet(const WorldData& world, Rays& rays, std::uint32_t kinds, Query& query)
{
    const PacketSlabs<Rays> slabs(rays);
    LaneFront<Rays> front(world.store, slabs, rays);
    PackedBoolean<Rays> boolean(world.store, rays);
    TileLeaf<Rays, Query> leaf{world, nullptr, rays, query, kinds, front, boolean};
    for (const std::uint32_t item : world.unbounded) leaf.item(item, rays.all());
    PacketWalk(world.bvh, slabs, rays, kinds, leaf).run();
}

/// Fewer rays than this go one by one: a beam of few rays that fly apart meets more than they do. Where two come near
/// solids that answer rays together sooner, these outweigh the boxes.
inline constexpr int kFewestForBeam = 24, kFewestTogether = 2;

/// Whether a ray comes near the box.
inline bool comes_near(const Aabb& box, const Ray& ray, double first, double last)
{
    Interval within{first, last};
    return narrow(within, ray, box.lower, box.upper);
}

inline int fewest_for_beam(const WorldData& world, const RayTile& rays)
{
    if (!world.costly || rays.count >= 2 * kFewestForBeam) return kFewestForBeam;  // several beams perhaps
    int near = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i)
        if (comes_near(world.costly_bounds, rays.ray(static_cast<int>(i)), rays.t_min[i], rays.t_max[i]) &&
            ++near == kFewestTogether)
            return kFewestTogether;
    return kFewestForBeam;
}

/// Fewer rays than this that form no beam are not asked together. Nor are rays from places of their own in a larger
/// world: there each of them soon goes its own way, and what they share weighs less than its cost.
inline int fewest_for_packet(const WorldData& world, const RayTile& rays)
{
    constexpr int kFewest = 6;
    constexpr std::size_t kMostNodes = 128;
    return rays.common_origin || world.bvh.nodes.size() <= kMostNodes ? kFewest : kTileRays + 1;
}

}  // namespace csg
