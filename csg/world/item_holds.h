#pragma once

#include "csg/items/world_data.h"
#include "csg/tree/contains.h"

/// What items of a world hold: of one point, or of those of them asked for that lie in vector lanes.
namespace csg {

template <class P>
lanes::TruthOf<P> item_holds(const WorldData& world, std::uint32_t index, const P& p, lanes::TruthOf<P> asked)
{
    const WorldItem& item = world.items[index];
    if (item.instance != Hit::kNoInstance) {
        const Instance& one = world.instances[item.instance];
        const P own = lanes::into(one.frame, p);
        lanes::TruthOf<P> found(false);
        for (std::uint32_t i = 0; i < one.world->items.size() && lanes::mask(asked) != 0; ++i) {
            const lanes::TruthOf<P> held = item_holds(*one.world, i, own, asked);
            found = found | held;
            asked = asked & !held;
        }
        return found;
    }
    if (item.solid != kNoPart) return holds(world.store, item.solid, item.inverted, p, asked);
    const Program& program = world.programs[item.program];
    return program.nodes.empty() ? lanes::TruthOf<P>(false) : contains(program.nodes, 0, world.store, p, asked);
}

}  // namespace csg
