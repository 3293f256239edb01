#include "csg/world/inside_index.h"

#include "csg/packet/lanes/tile_rays.h"
#include "csg/world/item_holds.h"
#include "numbers/rounding.h"

namespace csg {
namespace {

/// A point as boxes of single precision are tested against it.
struct Rounded {
    float above[3], below[3];

    Rounded() {}
    explicit Rounded(const glm::dvec3& p)
    {
        for (int axis = 0; axis < 3; ++axis) {
            above[axis] = rounded_up(p[axis]);
            below[axis] = rounded_down(p[axis]);
        }
    }
};

/// Which of eight boxes hold the point.
std::uint32_t holding(const BvhNode& node, const Rounded& p)
{
    using lanes::FloatPart;
    std::uint32_t mask = 0;
    for (int part = 0; part < lanes::kFloatParts; ++part) {
        const int at = part * lanes::kFloatPart;
        std::uint32_t inside = ~0u;
        for (int axis = 0; axis < 3; ++axis)
            inside &= lanes::mask((FloatPart::load_aligned(node.bounds[axis] + at) <= FloatPart(p.above[axis])) &
                                  (FloatPart(p.below[axis]) <= FloatPart::load_aligned(node.bounds[axis + 3] + at)));
        mask |= (inside & ((1u << lanes::kFloatPart) - 1)) << at;
    }
    return mask;
}

/// One point.
struct Alone {
    const WorldData& world;
    glm::dvec3 point;

    glm::dvec3 at(std::size_t) const { return point; }
    /// Which of the points an item holds; box: around it.
    std::uint64_t held(std::uint32_t item, std::uint64_t) const { return item_holds(world, item, point, true); }
    std::uint64_t held(std::uint32_t item, const Aabb& box, std::uint64_t asked) const
    {
        return beyond(box.lower, box.upper, point) ? 0 : held(item, asked);
    }
};

/// Many, in vector lanes.
struct Together {
    const WorldData& world;
    const double *x, *y, *z;

    glm::dvec3 at(std::size_t k) const { return {x[k], y[k], z[k]}; }
    lanes::Points points(int i) const
    {
        using lanes::Double;
        return {Double::load_aligned(x + i), Double::load_aligned(y + i), Double::load_aligned(z + i)};
    }
    std::uint64_t held(std::uint32_t item, std::uint64_t asked) const
    {
        std::uint64_t out = 0;
        each_vector(asked, [&](int i) {
            const auto held = item_holds(world, item, points(i), lanes::lanes_of(part(asked, i)));
            out |= std::uint64_t{lanes::mask(held)} << i;
        });
        return out;
    }
    std::uint64_t held(std::uint32_t item, const Aabb& box, std::uint64_t asked) const
    {
        std::uint64_t near = 0;
        each_vector(asked, [&](int i) {
            near |= std::uint64_t{part(asked, i) & ~lanes::mask(beyond(box.lower, box.upper, points(i)))} << i;
        });
        return near == 0 ? 0 : held(item, near);
    }

private:
    static std::uint32_t part(std::uint64_t of, int i)
    {
        return static_cast<std::uint32_t>(of >> i) & ((1u << lanes::kDoubles) - 1);
    }
};

}  // namespace

InsideIndex::InsideIndex(const WorldData& world) : world_(world)
{
    constexpr std::size_t kFewest = 4;  // for a hierarchy
    std::vector<BvhInput> inputs;
    for (std::uint32_t i = 0; i < world.items.size(); ++i) {
        const Aabb box = World(world).inside_bounds(i);
        if (box.empty()) continue;
        if (fits_hierarchy(box)) inputs.push_back({.bounds = box, .index = i});
        else apart_.push_back({i, box});
    }
    if (inputs.size() < kFewest) {
        for (const BvhInput& input : inputs) apart_.push_back({input.index, input.bounds});
        inputs.clear();
    }
    boxes_ = build_bvh(std::move(inputs));
}

/// Of the points left.
template <class Asked>
std::uint64_t InsideIndex::find(const Asked& asked, std::uint64_t left) const
{
    const std::uint64_t all = left;
    for (const Placed& one : apart_)
        if ((left &= ~asked.held(one.item, one.box, left)) == 0) return all;
    if (boxes_.nodes.empty()) return all & ~left;
    std::array<Rounded, kTileRays> rounded;
    each_ray(left, [&](std::size_t k) { rounded[k] = Rounded(asked.at(k)); });
    struct Visit {
        std::uint32_t node;
        std::uint64_t points;
    };
    Visit stack[kBvhStack];
    int top = 0;
    stack[top++] = {0, left};
    while (top > 0 && left != 0) {
        const Visit visit = stack[--top];
        const BvhNode& node = boxes_.nodes[visit.node];
        std::uint64_t near[8] = {};
        std::uint32_t met = 0;
        each_ray(visit.points & left, [&](std::size_t k) {
            const std::uint32_t holders = holding(node, rounded[k]);
            met |= holders;
            for (std::uint32_t mask = holders; mask != 0; mask &= mask - 1)
                near[std::countr_zero(mask)] |= std::uint64_t{1} << k;
        });
        for (; met != 0; met &= met - 1) {
            const int c = std::countr_zero(met);
            if (!node.child[c].is_leaf()) stack[top++] = {node.child[c].index(), near[c]};
            else left &= ~asked.held(node.child[c].index(), near[c] & left);
        }
    }
    return all & ~left;
}

bool InsideIndex::holds(const glm::dvec3& point) const { return find(Alone{world_, point}, 1) != 0; }

std::uint64_t InsideIndex::holds(const double* x, const double* y, const double* z, std::size_t count) const
{
    return find(Together{world_, x, y, z}, count < 64 ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0});
}

}  // namespace csg
