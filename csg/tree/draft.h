#pragma once

#include "csg/tree/program.h"

#include <optional>
#include <vector>

namespace csg {

/// A tree without Difference and without inversion above the leaves.
struct Draft {
    Op op = Op::Leaf;
    std::vector<Draft> operands = {};
    PartId solid = kNoPart;
    bool inverted = false;
    Aabb box = {};
    std::optional<Plane> half_space = {};  ///< a plane's leaf, turned round if inverted
    bool inside_beyond = false;
    bool reversed = false;  ///< the operands come in reverse, and so does all below them
};

/// The draft of a tree, with boxes, and without what `pruning` finds useless.
Draft draft_of(const Tree& tree, const SolidStore& store, Pruning& pruning);

/// Whether a solid has an inside at all.
template <class T>
bool bounds_space(const T& solid)
{
    if constexpr (std::is_same_v<T, Mesh>) return solid.solid();
    else if constexpr (std::is_same_v<T, Freeform>) return !solid.surface();
    else return !std::is_same_v<T, Triangle>;
}

/// Whether an operator reverses the crossings of each operand. A clipped union does too (spec 5a, 2.2): its operands
/// are reversed when the draft is made.
inline bool reverses(Op op) { return op == Op::Intersection || op == Op::Merge; }

}  // namespace csg
