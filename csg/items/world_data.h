#pragma once

#include "csg/bvh/bvh.h"
#include "csg/base/hit.h"
#include "csg/tree/program.h"
#include "csg/items/test_order.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace csg {

/// One thing that is tested on its own: a lone solid or a CSG program.
struct WorldItem {
    PartId solid = kNoPart;       ///< kNoPart: a program
    std::uint32_t program = 0;    ///< index into WorldData::programs
    std::uint32_t object = 0;     ///< Surface::object
    std::uint8_t visible = 0xff;  ///< bits of the kinds of ray that see it
    bool inverted = false;        ///< lone solid only
    bool all_opaque = true;       ///< every surface of it stops light
    bool simple = false;          ///< a program whose sum of products suits vector lanes
    bool plain = false;           ///< and has nothing cut from it
    bool boolean = false;         ///< a program that is not simple, but whose boolean form suits vector lanes
    bool many = false;  ///< a solid that answers a batch of rays faster than one by one, or a program with one
    std::uint32_t guard = kNoGuard;             ///< index into WorldData::guards
    std::uint32_t instance = Hit::kNoInstance;  ///< an instance, and neither solid nor program
    std::uint32_t unclipped = kNoProgram;  ///< the same without its own clips, where that may hold the start of a ray

    static constexpr std::uint32_t kNoGuard = 0xffffffffu, kNoProgram = 0xffffffffu;
};

/// What a ray must meet, or start inside of, to be told anything of an item: POV-Ray's `bounded_by` (spec 5a, 9.2). Of
/// what it is told then, nothing is left out.
struct BoundingGuard {
    Aabb box = Aabb::everything();
    std::vector<std::uint32_t> programs;  ///< each of them
    /// POV-Ray asks what it keeps in a hierarchy in the order in which rays come to the boxes, and stops at a box
    /// beyond the nearest hit: what is drawn before its box is hidden by what lies between.
    bool ordered = false;
    /// Shadow rays do not ask for the box of what stops light: POV-Ray remembers the last solid that did and asks it,
    /// but not its box, first.
    bool shadows_pass = false;
};

struct WorldData;

/// One of many copies of an object: a world of its own that all of them share, whose rays are moved into its space.
struct Instance {
    std::shared_ptr<const WorldData> world;  ///< finished, bounded, seen by every kind of ray
    Transform frame;                         ///< from its space to ours
    std::uint32_t first_surface = 0;         ///< its surface s is WorldData::instance_surfaces[first_surface + s] here
};

/// Eight spheres in lanes; an empty place has radius -1.
struct alignas(64) SphereBlock {
    double x[8], y[8], z[8], radius[8];
    std::uint32_t item[8];
};

/// What World reads: filled through add_*, then finished once; immutable afterwards. Items keep the order in which they
/// were added: of what lies in one place the first is seen.
struct WorldData {
    SolidStore store;
    std::vector<Program> programs;
    std::vector<WorldItem> items;
    std::vector<BoundingGuard> guards;
    std::vector<Instance> instances;
    std::vector<SurfaceId> instance_surfaces;
    std::vector<std::uint32_t> unbounded;       ///< items outside the hierarchy
    std::vector<std::uint32_t> ordered;         ///< items with ordered guards
    std::shared_ptr<LazyTestOrder> test_order;  ///< null: of what lies in one place the first item is seen
    Bvh bvh;
    std::vector<SphereBlock> spheres;          ///< by leaf block
    std::vector<std::uint8_t> surface_opaque;  ///< by SurfaceId: a shadow ray may stop at it for good (spec 3, 13.2)
    /// By SurfaceId: those of one number look alike wherever their normals are the same; kNoLook: like no other.
    std::vector<std::uint32_t> surface_look;
    static constexpr std::uint32_t kNoLook = 0xffffffffu;
    std::uint8_t visible_everywhere = 0xff;  ///< kinds of ray that see every item
    std::uint8_t shadow_kinds = 0xff;  ///< kinds of ray that ask for shadows: items that none of these sees cast none
    bool drop_empty = true;            ///< items that draw nothing are never asked
    bool costly = false;               ///< some item is `many`
    Aabb costly_bounds;                ///< of all of these
    Roundings told = Roundings::Own;   ///< whose last bits points and normals of hits have (csg/items/last_bits.h)
    bool faithful = false;  ///< answers by POV-Ray's constants, ray by ray where they matter (docs/faithful.md)

    /// A solid by itself.
    void add_solid(PartId solid, bool inverted, std::uint32_t object, std::uint8_t visible);
    /// A CSG object.
    void add_program(Program program, std::uint32_t object, std::uint8_t visible);
    /// A copy of a shared world, whose surfaces are `surfaces` here.
    void add_instance(std::shared_ptr<const WorldData> shared, const Transform& frame,
                      const std::vector<SurfaceId>& surfaces, std::uint32_t object, std::uint8_t visible);
    /// Whether the item that was added last has to be given its box in POV-Ray (TestOrder).
    bool last_has_test_box();
    /// Gives it that box.
    void test_box_of_last(const Aabb& box);
    /// Those added since there were so many are one object with that box there.
    void test_box_since(std::size_t first, const Aabb& box);
    /// Puts a guard before the item that was added last.
    void guard_last(BoundingGuard guard);
    /// Builds the hierarchy, of many items on so many threads. surface_opaque must be set.
    void finish(int threads = 1);
};

/// A box around what the item draws.
Aabb drawn_bounds(const WorldData& world, const WorldItem& item);

}  // namespace csg
