#pragma once

#include "csg/base/hit.h"
#include "csg/base/types.h"

#include <cstdint>
#include <vector>

namespace csg {

struct Tie;        // csg/items/world_item.h
class TestOrder;   // csg/items/test_order.h
struct WorldData;  // csg/items/world_data.h
class Scratch;     // csg/tree/program.h: per thread, reused; never shared
class Shaft;       // csg/packet/shaft.h

/// All top-level objects of a scene behind one bounding hierarchy. Immutable once built; safe for any number of
/// threads. Ray directions have unit length; t is a distance in scene units. Bits of `kinds`:
/// trace::bit(plan::RayKind). Of what lies in one place (Tolerance::kSamePlace) the object is seen that POV-Ray asks
/// first, as it is there where its numbers are equal (csg/items/test_order.h).
class World {
public:
    explicit World(const WorldData& data) : data_(&data) {}

    /// The first visible crossing with t_min <= t < t_max among objects visible to `kind_bit`; !found() if none.
    Hit nearest(const Ray& ray, double t_min, double t_max, std::uint8_t kind_bit, Scratch& scratch) const;

    /// Point and normal of a hit of that ray; uv where asked for.
    HitDetails details(const Ray& ray, const Hit& hit, bool with_uv = true) const;
    /// The same of the hits of a tile that `which` names (bit k: hit k), without uv; others' places are anything.
    void shading_points(const RayTile& rays, const HitTile& hits, std::uint64_t which, ShadingPoints& out) const;
    /// Whether POV-Ray does not tell of a hit as far off as this one (csg/items/depth_range.h).
    bool too_far(const Hit& hit) const;
    /// Where a ray that leaves a hit begins to look: csg/items/spawn_epsilon.h.
    double spawn_distance(const Ray& ray, const Hit& hit, double incidence, bool inward, double usual) const;
    /// Appends the shares of the parts of the shape that was hit (Freeform::shares).
    void shares(const Hit& hit, const glm::dvec3& point, std::vector<Share>& out) const;

    /// Whether anything that casts a shadow lies in (t_min, t_max): Blocked as soon as an opaque surface is met.
    Shadow shadow(const Ray& ray, double t_min, double t_max, Scratch& scratch) const;

    /// shadow(), and where it is Filtered every crossing in (t_min, t_max), nearest first, in `out`; what is in it
    /// otherwise means nothing.
    Shadow shadow_crossings(const Ray& ray, double t_min, double t_max, Scratch& scratch, std::vector<Hit>& out) const;

    /// Indices (Surface::object, in order of declaration) of the top-level objects whose solid holds the point.
    void containing(const glm::dvec3& point, std::vector<std::uint32_t>& out) const;

    /// Whether the solid of one item (WorldData::items) holds the point.
    bool item_holds(std::uint32_t item, const glm::dvec3& point) const;

    /// The same of the start of a ray, for which POV-Ray leaves the item's own clips out (spec 5a, 11.5).
    bool item_holds_start(std::uint32_t item, const glm::dvec3& point) const;

    /// Whether it may hold any point of the box; certain if it says no.
    bool item_may_hold(std::uint32_t item, const Aabb& box) const;
    /// A box around the solid of one item, as item_holds() has it.
    Aabb inside_bounds(std::uint32_t item) const;
    /// Puts items in the order in which POV-Ray finds that they hold a point; as they are declared where there is none.
    void in_test_order(std::vector<std::uint32_t>& items) const;

    /// Whether rays of all these kinds see every object.
    bool seen_by_all(std::uint8_t kinds) const;

    /// nearest() for a tile: rays i < count, with their own t_min and t_max. Same answers, bit for bit, as one by one.
    void nearest(const RayTile& rays, std::uint8_t kind_bit, Scratch& scratch, HitTile& out) const;

    /// shadow() for a tile. `out` has kTileRays places.
    void shadow(const RayTile& rays, Scratch& scratch, Shadow* out) const;

    /// shadow_crossings() for a tile.
    void shadow_crossings(const RayTile& rays, Scratch& scratch, CrossingTile& out) const;

    /// The same for rays that run inside of a shaft, which serves.
    void shadow(const RayTile& rays, const Shaft& shaft, Scratch& scratch, Shadow* out) const;
    void shadow_crossings(const RayTile& rays, const Shaft& shaft, Scratch& scratch, CrossingTile& out) const;

    const WorldData& data() const { return *data_; }

private:
    Hit first(const Ray& ray, double t_min, double t_max, std::uint8_t kind_bit, Scratch& scratch) const;
    Hit first_in_order(const Ray& ray, double t_min, double t_max, std::uint8_t kind_bit, Scratch& scratch) const;
    Hit first_tested(const Ray& ray, double t_min, std::uint8_t kind_bit, Scratch& scratch, const Hit& nearest,
                     const Tie& tie) const;
    const TestOrder& test_order() const;
    Hit first_in_reach(const Ray& ray, double t_min, double t_max, std::uint8_t kind_bit, Scratch& scratch) const;
    void recheck(const RayTile& rays, std::uint8_t kind_bit, Scratch& scratch, HitTile& out) const;
    const WorldData* data_;
};

}  // namespace csg
