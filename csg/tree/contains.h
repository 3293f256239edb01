#pragma once

#include "csg/base/points.h"
#include "csg/tree/program.h"

#include <array>
#include <bit>

/// What is inside of solids and trees: of one point, or of those of them asked for that lie in vector lanes.
namespace csg {

/// Whether a solid holds the point. Kinds without a test in lanes are asked point by point.
template <class Solid, class P>
inline lanes::TruthOf<P> holds(const Solid& solid, bool inverted, const P& p, lanes::TruthOf<P> asked)
{
    if constexpr (requires { solid.contains(p); }) {
        const lanes::TruthOf<P> inside = inverted ? solid.contains_inverted(p) : solid.contains(p);
        return asked & inside;
    } else {
        alignas(64) std::array<double, static_cast<std::size_t>(lanes::kDoubles)> x, y, z;
        p.x.store_aligned(x.data());
        p.y.store_aligned(y.data());
        p.z.store_aligned(z.data());
        std::uint32_t held = 0;
        for (std::uint32_t left = lanes::mask(asked); left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            if (holds(solid, inverted, glm::dvec3(x[k], y[k], z[k]), true)) held |= 1u << k;
        }
        return lanes::lanes_of(held);
    }
}
template <class P>
inline lanes::TruthOf<P> holds(const SolidStore& store, PartId part, bool inverted, const P& p, lanes::TruthOf<P> asked)
{
    return with_solid(store, part, [&](const auto& solid) { return holds(solid, inverted, p, asked); });
}

/// Whether p lies outside of a box; not if it is no number.
template <class P, class Corner>
inline lanes::TruthOf<P> beyond(const Corner& lower, const Corner& upper, const P& p)
{
    const double low[] = {lower[0], lower[1], lower[2]}, high[] = {upper[0], upper[1], upper[2]};
    return (p.x < low[0]) | (p.x > high[0]) | (p.y < low[1]) | (p.y > high[1]) | (p.z < low[2]) | (p.z > high[2]);
}

/// Whether p is inside node i.
template <class P>
lanes::TruthOf<P> contains(const std::vector<Node>& nodes, std::uint32_t i, const SolidStore& store, const P& p,
                           lanes::TruthOf<P> asked)
{
    using Truth = lanes::TruthOf<P>;
    const Node& node = nodes[i];
    Truth found(false);
    if (node.test_box) {
        const Truth out = beyond(node.lower, node.upper, p);
        if (node.inside_beyond) found = asked & out;
        asked = asked & !out;
        if (lanes::mask(asked) == 0) return found;
    }
    if (node.op == Op::Leaf) {
        const Truth held = holds(store, node.solid, node.inverted, p, asked);
        return found | held;
    }
    const bool all = node.op == Op::Intersection || node.op == Op::Clip;
    for (std::uint32_t k = i + 1; k < node.end && lanes::mask(asked) != 0; k = nodes[k].end) {
        const Truth held = contains(nodes, k, store, p, asked);
        if (!all) found = found | held;
        asked = all ? held : asked & !held;
        if (node.op == Op::Guard) break;  // of a guard the first operand is what it guards
    }
    return all ? found | asked : found;
}

}  // namespace csg
