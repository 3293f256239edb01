#pragma once

#include "csg/bvh.h"
#include "csg/solid.h"

#include <cstdint>
#include <vector>

/// A CSG object as a union of terms, each an intersection of solids less a list of cuts: see docs/flat_csg.md.
namespace csg {

struct Program;

/// A solid of a term. Its complement is meant where it stands in a cut of a difference; the solid itself is intersected.
struct FlatLeaf {
    PartId solid = kNoPart;
    bool turned = false;          ///< the outward normal is negated: Crossing::inverted
    bool convex = true;           ///< one interval; else up to kFlatSpans spans
};
inline constexpr std::uint32_t kFlatSpans = 3;

/// What is taken away: the intersection of leaves[first .. first + count). All of them convex, or one that is not.
/// count 0: an empty place that fills a block of boxes.
struct FlatCut {
    std::uint32_t first = 0, count = 0;
};

/// The intersection of leaves[first .. last) less cuts[cut_first .. cut_last). Not convex is at most one of the leaves.
struct FlatTerm {
    std::uint32_t first = 0, last = 0;
    std::uint32_t cut_first = 0, cut_last = 0;   ///< cut_first is a multiple of 8; terms may share cuts
    std::uint32_t tree = kNoTree;                ///< index into trees: where there are many cuts
    bool convex = true;                          ///< all leaves are
    bool bounded_cuts = true;                    ///< the boxes of all cuts are finite
    static constexpr std::uint32_t kNoTree = 0xffffffffu;

    /// Convex and nothing is cut from it: its crossings are two ends.
    bool plain() const { return convex && cut_first == cut_last; }
};

/// An end of a leaf along a ray: small, because most are thrown away.
struct FlatEnd {
    double t;
    std::uint32_t leaf, face;     ///< leaf: index into FlatForm::leaves
};

/// A piece of a ray in the leaves of a term, or in a cut.
struct FlatPiece {
    FlatEnd in, out;
};

/// A cut whose box a ray meets.
struct FlatCandidate {
    float near;                   ///< where, or before; -infinity where it was not worked out
    std::uint32_t cut;
};

/// Eight boxes as in BvhNode: rounded outward, an empty place is never met.
struct alignas(32) BoxBlock {
    float bounds[6][8];
};

struct FlatForm {
    std::vector<FlatLeaf> leaves;
    std::vector<FlatCut> cuts;
    std::vector<FlatTerm> terms;            ///< none: the object has no flat form
    std::vector<BoxBlock> term_boxes;       ///< eight terms a block
    std::vector<BoxBlock> cut_boxes;        ///< eight cuts a block
    std::vector<Bvh> trees;                 ///< items are indices into cuts
    std::uint32_t span_memory = 0;          ///< spans of scratch one query needs
    bool merged = false;                    ///< one term without leaves: the union of its cuts, inner surfaces left out

    bool usable() const { return !terms.empty(); }
    /// Fit for vector lanes: one term of convex solids, or of none, and perhaps a quadric. Cuts may be anything: rays that
    /// come near one that is neither convex nor a torus go their own way.
    bool simple() const;
};

/// The flat form of a built program, if it has one.
FlatForm flat_form(const Program& program, const SolidStore& store);

}  // namespace csg
