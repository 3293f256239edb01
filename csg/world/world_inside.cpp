#include "csg/world/world.h"
#include "csg/world/item_holds.h"

#include <algorithm>

// What a point is inside of: asked for the starts of rays.
namespace csg {

void World::containing(const glm::dvec3& point, std::vector<std::uint32_t>& out) const
{
    out.clear();
    for (std::uint32_t i = 0; i < data_->items.size(); ++i) {
        const std::uint32_t object = data_->items[i].object;
        if ((out.empty() || out.back() != object) && item_holds(i, point)) out.push_back(object);
    }
}

bool World::item_holds(std::uint32_t index, const glm::dvec3& point) const
{
    return csg::item_holds(*data_, index, point, true);
}

bool World::item_holds_start(std::uint32_t index, const glm::dvec3& point) const
{
    const WorldItem& item = data_->items[index];
    return item.unclipped != WorldItem::kNoProgram ? contains(data_->programs[item.unclipped], data_->store, point)
                                                   : item_holds(index, point);
}

Aabb World::inside_bounds(std::uint32_t index) const
{
    const WorldItem& item = data_->items[index];
    if (item.instance != Hit::kNoInstance) {
        const Instance& one = data_->instances[item.instance];
        Aabb all;
        for (std::uint32_t i = 0; i < one.world->items.size(); ++i) all.include(World(*one.world).inside_bounds(i));
        return all.empty() || !all.finite() ? all : transformed_box(one.frame, all);
    }
    if (item.solid == kNoPart) {
        const Program& program = data_->programs[item.program];
        return program.inside_beyond ? Aabb::everything() : program.bounds;
    }
    return item.inverted ? Aabb::everything()
                         : with_solid(data_->store, item.solid, [](const auto& solid) { return solid.bounds(); });
}

bool World::item_may_hold(std::uint32_t index, const Aabb& box) const
{
    return data_->items[index].unclipped != WorldItem::kNoProgram || !inside_bounds(index).intersected(box).empty();
}

void World::in_test_order(std::vector<std::uint32_t>& items) const
{
    std::sort(items.begin(), items.end());
    if (items.size() > 1 && data_->test_order) test_order().arrange(items);
}

}  // namespace csg
