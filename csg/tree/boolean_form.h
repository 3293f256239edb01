#pragma once

#include "csg/solids/solid.h"

#include <cstdint>
#include <vector>

/// What decides whether an end of a leaf is drawn: which of the other leaves hold the point. For trees that have no sum
/// of products: clips, merges below other operators, cuts of merges (docs/flat_csg.md).
namespace csg {

struct Program;

/// A subtree that has to hold the point of a drawn end, or may not. Those of single leaves are masks of BooleanLeaf.
struct BooleanCondition {
    std::uint32_t node = 0;  ///< its root among Program::nodes
    bool inside = false;
};

struct BooleanLeaf {
    PartId solid = kNoPart;
    std::uint32_t node = 0;
    bool inverted = false;
    bool normal_flipped = false;            ///< Crossing::inverted of its ends
    bool closed = false;                    ///< Crossing::closed of them
    std::uint8_t most_pieces = 1;           ///< intervals along any ray that there is room for
    bool drawn = true;                      ///< not an operand that only clips
    std::uint8_t rank = 0;                  ///< its place in the order in which the general evaluation draws
    std::uint64_t inside = 0, outside = 0;  ///< leaves that have to hold the point of a drawn end; that may not
    std::uint64_t below = 0;                ///< leaves of the subtrees among the conditions
    std::uint32_t first = 0, count = 0;     ///< of BooleanForm::conditions

    /// The leaves on which it depends whether an end of this one is drawn: not those of other operands of a union.
    std::uint64_t matters() const { return inside | outside | below; }
};

struct BooleanForm {
    static constexpr std::uint32_t kMostLeaves = 64;
    static constexpr std::uint32_t kMostPieces = 64;  ///< of all leaves together
    static constexpr std::uint32_t kMostOfLeaf = 4;   ///< pieces of one leaf; a ray with more is asked by itself
    std::vector<BooleanLeaf> leaves;                  ///< bit i of a mask: leaf i. None: the object has no such form
    std::vector<BooleanCondition> conditions;
    std::vector<std::uint8_t>
        first_leaf;  ///< by node, and one past the last: leaves before it in the tree, so a leaf's own bit

    bool usable() const { return !leaves.empty(); }
};

/// The form of a built program, if it has one.
BooleanForm boolean_form(const Program& program, const SolidStore& store);

}  // namespace csg
