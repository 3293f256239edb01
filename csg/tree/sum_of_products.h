#pragma once

#include "csg/bvh/bvh.h"
#include "csg/solids/solid.h"

#include <cstdint>
#include <vector>

/// A CSG object as a union of terms, each an intersection of solids less a list of cuts: see docs/flat_csg.md.
namespace csg {

struct Program;

/// A solid of a term. Its complement is meant where it stands in a cut of a difference; the solid itself is
/// intersected.
struct ProductLeaf {
    PartId solid = kNoPart;
    bool normal_flipped = false;  ///< the outward normal is negated: Crossing::inverted
    bool convex = true;           ///< one interval; else up to kProductSpans spans
};
inline constexpr std::uint32_t kProductSpans = 3;

/// What is taken away: the intersection of leaves[first .. first + count). All of them convex, or one that is not.
/// count 0: an empty place that fills a block of boxes.
struct ProductCut {
    std::uint32_t first = 0, count = 0;
};

/// The intersection of leaves[first .. last) less cuts[cut_first .. cut_last). Not convex is at most one of the leaves.
struct ProductTerm {
    std::uint32_t first = 0, last = 0;
    std::uint32_t cut_first = 0, cut_last = 0;  ///< cut_first is a multiple of 8; terms may share cuts
    std::uint32_t tree = kNoTree;               ///< index into trees: where there are many cuts
    bool convex = true;                         ///< all leaves are
    bool bounded_cuts = true;                   ///< the boxes of all cuts are finite
    bool wide_cuts = false;                     ///< and each holds that of the leaves: no ray would be sieved out
    static constexpr std::uint32_t kNoTree = 0xffffffffu;

    /// Convex and nothing is cut from it: its crossings are two ends.
    bool plain() const { return convex && cut_first == cut_last; }
};

/// An end of a leaf along a ray: small, because most are thrown away.
struct ProductEnd {
    double t;
    std::uint32_t leaf, face;  ///< leaf: index into SumOfProducts::leaves
};

/// A piece of a ray in the leaves of a term, or in a cut.
struct ProductPiece {
    ProductEnd in, out;
};

/// A cut whose box a ray meets.
struct ProductCandidate {
    float near;  ///< where, or before; -infinity where it was not worked out
    std::uint32_t cut;
};

/// Eight boxes as in BvhNode: rounded outward, an empty place is never met.
struct alignas(32) BoxBlock {
    float bounds[6][8];
};

struct SumOfProducts {
    std::vector<ProductLeaf> leaves;
    std::vector<ProductCut> cuts;
    std::vector<ProductTerm> terms;    ///< none: the object has no sum of products
    std::vector<BoxBlock> term_boxes;  ///< eight terms a block
    std::vector<BoxBlock> cut_boxes;   ///< eight cuts a block
    std::vector<Bvh> trees;            ///< items are indices into cuts
    std::uint32_t span_memory = 0;     ///< spans of scratch one query needs
    bool merged = false;               ///< one term without leaves: the union of its cuts, inner surfaces left out

    bool usable() const { return !terms.empty(); }
    /// Fit for vector lanes: one term of convex solids, or of none, and perhaps a quadric. Cuts may be anything: rays
    /// that come near one that is neither convex nor a torus go their own way.
    bool simple() const;
};

/// The sum of products of a built program, if it has one.
SumOfProducts sum_of_products(const Program& program, const SolidStore& store);

}  // namespace csg
