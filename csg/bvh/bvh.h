#pragma once

#include "csg/base/types.h"

#include <cstdint>
#include <vector>

/// The bounding hierarchy: 8 boxes a node, leaf blocks of one kind.
namespace csg {

/// What a leaf holds. A block of spheres or triangles is tested in vector lanes; anything else stands alone.
enum class LeafKind : std::uint32_t { Item, Spheres, Triangles };

/// Items of one kind that fit in a block.
constexpr std::uint32_t block_capacity(LeafKind kind)
{
    return kind == LeafKind::Spheres ? 8u : kind == LeafKind::Triangles ? 4u : 1u;
}

/// A child of a node: another node, or a leaf block.
struct ChildWord {
    std::uint32_t word;
    static constexpr std::uint32_t kLeafBit = 0x80000000u;
    static constexpr std::uint32_t kKindShift = 28, kIndexMask = 0x0fffffffu;
    static constexpr ChildWord node(std::uint32_t index) { return {index}; }
    static constexpr ChildWord leaf(LeafKind kind, std::uint32_t block)
    {
        return {kLeafBit | static_cast<std::uint32_t>(kind) << kKindShift | block};
    }
    constexpr bool is_leaf() const { return (word & kLeafBit) != 0; }
    constexpr LeafKind kind() const { return static_cast<LeafKind>((word >> kKindShift) & 7u); }
    constexpr std::uint32_t index() const { return word & kIndexMask; }
};

/// Eight boxes, rounded outward to single precision. bounds[axis] is the lower side, bounds[axis + 3] the upper.
/// An empty place has lower +inf and upper -inf: no ray passes it.
struct alignas(64) BvhNode {
    float bounds[6][8];
    ChildWord child[8];
    std::uint32_t kinds[8];  ///< bits of the kinds of ray that see anything below, and kQuick of a leaf
};
static_assert(sizeof(BvhNode) == 256, "four cache lines");
inline constexpr std::uint32_t kQuick = 0x80000000u;

/// By what number children of a node are asked, the least first: where a ray is in the box at the earliest. What is
/// quickly asked goes before what costs more and stands around it, for that may turn out to lie behind.
inline float asked_at(const BvhNode& node, std::uint32_t child, float near)
{
    if ((node.kinds[child] & kQuick) == 0) return near;
    float size = 0.0f;
    for (int axis = 0; axis < 3; ++axis) size += node.bounds[axis + 3][child] - node.bounds[axis][child];
    return near - 0.5f * size;
}

/// One thing to be put in the tree.
struct BvhInput {
    Aabb bounds;  ///< fits_hierarchy()
    LeafKind kind = LeafKind::Item;
    std::uint32_t index = 0;  ///< among its kind, whatever the caller means by it
    std::uint8_t visible = 0xff;
    bool quick = false;  ///< cheap to ask: before others around it, which may turn out to lie behind
};

struct Bvh {
    std::vector<BvhNode> nodes;  ///< node 0 is the root; empty where there is nothing
    /// Members of the leaf blocks, in the order of the blocks: block b of a kind holds members[first[b] .. first[b +
    /// 1]).
    std::vector<std::uint32_t> sphere_members, sphere_first, triangle_members, triangle_first;
    Aabb bounds;
    int depth = 0;  ///< levels of nodes
};

/// Whether a box is one of those that build_bvh() takes: not too wide for single precision.
bool fits_hierarchy(const Aabb& box);

/// Builds by binned surface area heuristic, many inputs on several threads. The same whatever the number of threads.
Bvh build_bvh(std::vector<BvhInput> inputs, int threads = 1);

/// Places a traversal may have to remember: 7 per level.
inline constexpr int kBvhStack = 512;

}  // namespace csg
