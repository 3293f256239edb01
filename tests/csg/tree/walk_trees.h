#pragma once

#include "tests/csg/support.h"

#include <algorithm>

/// Random CSG objects that have a boolean form, most of them.
namespace csg_test {

inline csg::Solid solid_for_walk(Rng& rng)
{
    const glm::dvec3 c = rng.point(1.0);
    switch (rng.below(8)) {
    case 0: return csg::Sphere{c, rng.uniform(0.3, 1.2)};
    case 1: return csg::Box{c, c + rng.uniform(0.2, 1.5)};
    case 2: return csg::OrientedBox{{-0.8, -0.6, -0.7}, {0.7, 0.5, 0.9}, random_transform(rng)};
    case 3: return csg::Plane{rng.direction(), rng.uniform(-0.5, 1.0)};
    case 4: return csg::Cylinder::make(c, -c, rng.uniform(0.2, 0.8), rng.coin(), {});
    case 5: return csg::Torus{0.8, rng.uniform(0.1, rng.coin() ? 0.4 : 1.6), random_transform(rng)};
    case 6: return csg::Disc{};
    default: return csg::Quadric{{1, rng.uniform(-1, 1), 1}, {0.1, 0.2, 0}, {0, 0, 0}, -0.5, random_transform(rng)};
    }
}

/// Solids whose faces often lie in the same places as others': corners on a lattice, tubes around one axis.
inline csg::Solid solid_on_lattice(Rng& rng)
{
    const glm::dvec3 corner(rng.below(3) - 1, rng.below(3) - 1, rng.below(3) - 1);
    const double radius = 0.5 * (1 + rng.below(3));
    switch (rng.below(5)) {
    case 0: return csg::Box{corner, corner + glm::dvec3(1 + rng.below(2), 1 + rng.below(2), 1 + rng.below(2))};
    case 1: return csg::Plane{glm::dvec3(0, rng.coin() ? 1 : -1, 0), static_cast<double>(rng.below(3) - 1)};
    case 2: return csg::Sphere{{0, 0, 0}, radius};
    default: {
        const double end = 1 + rng.below(2);
        return csg::Cylinder::make({-end, 0, 0}, {end, 0, 0}, radius, rng.below(3) == 0, {});
    }
    }
}

/// What random trees are like: two operands or one of `more` more, one of `inverse` of them inverted, clips of so many
/// levels.
struct TreeHabit {
    int more, inverse, clip_depth;
};

/// Operators of every kind, clips and inverses among them; solid(rng) makes the leaves.
template <class F>
csg::Tree random_tree(Rng& rng, csg::SolidStore& store, int depth, const TreeHabit& habit, const F& solid)
{
    csg::Tree made;
    if (depth == 0 || rng.below(4) == 0) {
        made.solid = store.add(solid(rng), 0);
    } else {
        made.op = static_cast<csg::Tree::Op>(1 + rng.below(4));
        const int operands = 2 + rng.below(habit.more);
        for (int i = 0; i < operands; ++i) made.operands.push_back(random_tree(rng, store, depth - 1, habit, solid));
    }
    made.inverse = rng.below(habit.inverse) == 0;
    if (rng.below(3) == 0)
        made.clips.push_back(random_tree(rng, store, std::min(depth, habit.clip_depth), habit, solid));
    return made;
}

inline csg::Tree tree_for_walk(Rng& rng, csg::SolidStore& store, int depth)
{
    return random_tree(rng, store, depth, {3, 6, 1}, solid_for_walk);
}

inline csg::Tree tree_on_lattice(Rng& rng, csg::SolidStore& store, int depth)
{
    return random_tree(rng, store, depth, {2, 8, 0}, solid_on_lattice);
}

}  // namespace csg_test
