#pragma once

#include "csg/bvh/bvh.h"
#include "csg/solids/solid.h"

#include <cstdint>
#include <optional>
#include <vector>

/// A CSG object as an intersection of solids less a list of cuts, for rays in vector lanes: see docs/flat_csg.md.
namespace csg {

struct Program;

/// A solid of a term. Its complement is meant where it stands in a cut of a difference; the solid itself is
/// intersected.
struct ProductLeaf {
    PartId solid = kNoPart;
    bool normal_flipped = false;  ///< the outward normal is negated: Crossing::inverted
    bool convex = true;           ///< one interval
};

/// What is taken away: the intersection of leaves[first .. first + count). All of them convex, or one that is not.
/// count 0: an empty place that fills a block of boxes.
struct ProductCut {
    std::uint32_t first = 0, count = 0;
};

/// The intersection of leaves[first .. last) less cuts[cut_first .. cut_last). Not convex is at most the last of the
/// leaves, a quadric.
struct ProductTerm {
    std::uint32_t first = 0, last = 0;
    std::uint32_t cut_first = 0, cut_last = 0;
    bool convex = true;        ///< all leaves are
    bool bounded_cuts = true;  ///< the boxes of all cuts are finite
    bool wide_cuts = false;    ///< and each holds that of the leaves: no ray would be sieved out

    /// Convex and nothing is cut from it: its crossings are two ends.
    bool plain() const { return convex && cut_first == cut_last; }
};

/// Eight boxes as in BvhNode: rounded outward, an empty place is never met.
struct alignas(32) BoxBlock {
    float bounds[6][8];
};

struct SumOfProducts {
    std::vector<ProductLeaf> leaves;
    std::vector<ProductCut> cuts;
    std::optional<ProductTerm> term;  ///< none: the object has no such form
    std::vector<BoxBlock> cut_boxes;  ///< eight cuts a block
    bool merged = false;              ///< a term without leaves: the union of its cuts, inner surfaces left out

    bool usable() const { return term.has_value(); }
};

/// The form of a built program, if it has one. Cuts may be anything: rays that come near one that is neither convex nor
/// a torus go their own way.
SumOfProducts sum_of_products(const Program& program, const SolidStore& store);

}  // namespace csg
