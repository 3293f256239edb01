#include "csg/world/inside_index.h"

#include "csg/items/world_data.h"
#include "numbers/lanes.h"
#include "numbers/rounding.h"

#include <bit>

namespace csg {
namespace {

/// Which of eight boxes hold the point.
std::uint32_t holding(const BvhNode& node, const float (&above)[3], const float (&below)[3])
{
    using lanes::FloatPart;
    std::uint32_t mask = 0;
    for (int part = 0; part < lanes::kFloatParts; ++part) {
        const int at = part * lanes::kFloatPart;
        std::uint32_t inside = ~0u;
        for (int axis = 0; axis < 3; ++axis)
            inside &= lanes::mask((FloatPart::load_aligned(node.bounds[axis] + at) <= FloatPart(above[axis])) &
                                  (FloatPart(below[axis]) <= FloatPart::load_aligned(node.bounds[axis + 3] + at)));
        mask |= (inside & ((1u << lanes::kFloatPart) - 1)) << at;
    }
    return mask;
}

}  // namespace

InsideIndex::InsideIndex(const WorldData& world) : world_(world)
{
    std::vector<BvhInput> inputs;
    for (std::uint32_t i = 0; i < world.items.size(); ++i) {
        const Aabb box = World(world).inside_bounds(i);
        if (box.empty()) continue;
        if (fits_hierarchy(box)) inputs.push_back({.bounds = box, .index = i});
        else unbounded_.push_back(i);
    }
    boxes_ = build_bvh(std::move(inputs));
}

bool InsideIndex::holds(const glm::dvec3& point) const
{
    const World world(world_);
    for (const std::uint32_t item : unbounded_)
        if (world.item_holds(item, point)) return true;
    if (boxes_.nodes.empty()) return false;
    float above[3], below[3];
    for (int axis = 0; axis < 3; ++axis) {
        above[axis] = rounded_up(point[axis]);
        below[axis] = rounded_down(point[axis]);
    }
    std::uint32_t stack[kBvhStack];
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
        const BvhNode& node = boxes_.nodes[stack[--top]];
        for (std::uint32_t mask = holding(node, above, below); mask != 0; mask &= mask - 1) {
            const ChildWord child = node.child[std::countr_zero(mask)];
            if (!child.is_leaf()) stack[top++] = child.index();
            else if (world.item_holds(child.index(), point)) return true;
        }
    }
    return false;
}

}  // namespace csg
