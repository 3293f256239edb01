#pragma once

#include "csg/tree/boolean_form.h"
#include "csg/base/cancel.h"
#include "csg/tree/fetched_spans.h"
#include "csg/tree/sum_of_products.h"
#include "csg/base/hit.h"
#include "csg/solids/solid.h"

#include <memory>
#include <vector>

namespace csg {

/// A CSG object as the planner describes it. Leaves name solids of a SolidStore.
struct Tree {
    enum class Op : std::uint8_t { Leaf, Union, Intersection, Difference, Merge };
    Op op = Op::Leaf;
    std::vector<Tree> operands = {};  ///< in order of declaration
    PartId solid = kNoPart;           ///< leaf only
    bool inverse = false;
    std::vector<Tree> clips = {};  ///< clipped_by: surfaces and inside end where any of them does; no caps
    std::vector<Tree> bounds =
        {};  ///< bounded_by: only a ray that meets them all, or starts inside, is told of surfaces
    std::uint8_t hidden_from = 0;  ///< the planner's: kinds of rays that go past this operand. build() takes no notice

    static Tree leaf(PartId part) { return {.solid = part}; }
};

/// Difference is an intersection with inverted operands and inversion is pushed down to the leaves, turning operators
/// round as POV-Ray does (spec 5a, 8.1). Clip: the first operand is drawn, the others only cut. Guard: the others only
/// decide which rays see the first.
enum class Op : std::uint8_t { Leaf, Union, Merge, Intersection, Clip, Guard };

/// One node of a flattened tree, in pre-order: an operator stands before its operands.
struct Node {
    std::array<float, 3> lower, upper;              ///< world box, rounded outward, of everything the node draws
    std::uint32_t end = 0;                          ///< one past the last operand: a missed box jumps here
    std::uint32_t parent = 0;                       ///< the root's is itself
    PartId solid = kNoPart;                         ///< leaf only
    std::uint32_t max_spans = 0;                    ///< leaf only: at most so many spans along any ray
    std::uint32_t first_sieve = 0, last_sieve = 0;  ///< of Program::sieves: boxes of its operands, where they are many
    std::uint32_t rank = 0;  ///< leaf only: its place in the order in which POV-Ray generates crossings
    Op op = Op::Leaf;
    bool inside_beyond = false;  ///< what lies outside the box is inside the solid (an inverted operand)
    bool test_box = true;        ///< false where the box test costs as much as the solid
    bool bounded = false;        ///< the box is finite and holds all; it is worth testing
    bool drawn = true;           ///< not of an operand that only clips
    bool mixed = false;          ///< an operator with quick operands behind others
    // Of a leaf:
    bool inverted = false;
    bool turned = false;          ///< what its solid does not hold is held; not of a mesh, which is asked for that
    bool normal_flipped = false;  ///< Crossing::inverted of what it draws
    bool closed = false;          ///< Crossing::closed of its ends
    bool draws_alone = false;     ///< it may draw what ends no span
    bool quick = false;           ///< soon asked
};
static_assert(sizeof(Node) <= 64, "one cache line");

/// Boxes of eight operands of one operator, in their order, as rays test them (BvhNode::bounds). One that a ray misses
/// changes nothing of what the operator does there: it adds nothing to a union, takes nothing from an intersection.
/// Operands of which that is not so have a box without end. The last ones may be empty.
struct alignas(64) OperandSieve {
    float bounds[6][8];
    std::uint32_t node[8];  ///< among Program::nodes
};

/// An operand of a merge that is asked for its drawn ends, and whether it holds those of the others.
struct MergedSolid {
    std::uint32_t node = 0;             ///< among Program::nodes
    Aabb drawn;                         ///< box of what can be seen of it
    std::array<glm::dvec3, 3> rows;     ///< from the world into a space of its own,
    glm::dvec3 offset{0.0}, size{0.0};  ///< this subtracted before; size: how long the rows are
    glm::dvec3 lower{0.0}, upper{0.0};  ///< in that space nothing of the solid lies beyond these

    /// Whether something of it may lie so near to a place of the world.
    bool comes_near(const glm::dvec3& p, double distance) const
    {
        const glm::dvec3 beside = p - offset;
        for (int axis = 0; axis < 3; ++axis) {
            const double at = glm::dot(rows[static_cast<std::size_t>(axis)], beside), room = distance * size[axis];
            if (at + room < lower[axis] || at - room > upper[axis]) return false;
        }
        return true;
    }
};

/// A flattened CSG tree. Immutable once built; shared by all threads.
struct Program {
    std::vector<Node> nodes;  ///< empty: nothing to draw, nothing inside
    std::vector<OperandSieve> sieves;
    std::vector<MergedSolid> merged;  ///< all operands of a merge of many solids; else none
    Aabb bounds;                      ///< world box of everything drawn; empty when nothing is
    bool inside_beyond = false;       ///< the solid goes on outside the bounds
    SumOfProducts products;           ///< the same as a union of terms, where it can be written so
    BooleanForm boolean;            ///< the same for rays in lanes: what decides which ends are drawn, where its leaves
                                    ///< are few and simple
    std::uint32_t span_memory = 0;  ///< spans of scratch one query needs
};

/// Whether operands that cannot matter are dropped, and how many were.
struct Pruning {
    bool on = true;
    std::uint64_t dropped = 0;
};

/// Flattens, pushes inversion to the leaves, drops operands that cannot matter and works out boxes.
/// \param pruning null: they are dropped, and nobody counts them
Program build(const Tree& tree, const SolidStore& store, Pruning* pruning = nullptr);

/// An item of a world and how far a ray goes before it is in its box.
struct OrderedItem {
    double entry;
    std::uint32_t item;
};

/// Where a ray passes a drawn end of a solid of Program::merged, and the next of the ray.
struct MergedEnd {
    double t;
    std::uint32_t face, solid, next;
};

/// Where a ray passes an end of a leaf, as Evaluation sorts them.
class TreeEnd {
public:
    double t;
    std::uint32_t face;

    static TreeEnd of(double t, std::uint32_t face, std::uint32_t leaf, bool after, bool hidden)
    {
        return {t, face, (after ? kAfter : 0u) | leaf << 2 | (hidden ? kHidden : 0u)};
    }
    /// A surface that bounds nothing.
    static TreeEnd touch(double t, std::uint32_t face, std::uint32_t leaf) { return {t, face, leaf << 2 | kTouch}; }
    /// No end, but where the ray may come into the box of a node.
    static TreeEnd opening(double t, std::uint32_t node) { return {t, 0, node << 2 | kOpening}; }

    std::uint32_t node() const { return (order_ & ~kAfter) >> 2; }
    /// The point at t itself belongs to what is before the end: of two in one place this comes later.
    bool after() const { return (order_ & kAfter) != 0; }
    bool hidden() const { return (order_ & 3u) == kHidden; }
    bool is_touch() const { return (order_ & 3u) == kTouch; }
    bool opens() const { return (order_ & 3u) == kOpening; }
    static bool later(const TreeEnd& a, const TreeEnd& b) { return a.t != b.t ? a.t > b.t : a.order_ > b.order_; }

private:
    TreeEnd(double at, std::uint32_t side, std::uint32_t order) : t(at), face(side), order_(order) {}
    static constexpr std::uint32_t kAfter = 1u << 31, kHidden = 1, kTouch = 2, kOpening = 3;
    std::uint32_t order_;
};

/// Working memory of one thread, reused from ray to ray.
class Scratch {
public:
    void prepare(const Program& program)
    {
        if (program.span_memory > spans_.size()) spans_.resize(program.span_memory);
        if (program.nodes.size() > counts_.size()) counts_.resize(program.nodes.size());
        ends_.clear();
        waiting_.clear();
        seen_.clear();
        inside_.clear();
        crossings_.clear();
    }

    /// Room for the spans of one leaf, valid until the next call.
    SpanList leaf_spans(std::uint32_t most)
    {
        if (most > spans_.size()) spans_.resize(most);
        return {spans_.data(), most};
    }

    /// Room for so many pieces of a sum of products, valid until the next call.
    ProductPiece* product_pieces(std::uint32_t count)
    {
        if (count > piece_capacity_) grow_pieces(count);
        return pieces_.get();
    }

    ProductCandidate* product_candidates(std::uint32_t count)
    {
        if (count > candidates_.size()) candidates_.resize(count);
        return candidates_.data();
    }

    /// A list of hits to be filled by whoever asks; kept for its memory.
    std::vector<Hit>& hits() { return hits_; }
    /// Another, for what instances are asked for meanwhile.
    std::vector<Hit>& instance_hits() { return instance_hits_; }

    /// Rays for a solid that answers many together.
    RayBatch& batch()
    {
        if (!batch_) batch_ = std::make_unique<RayBatch>();
        batch_->count = 0;
        return *batch_;
    }
    /// What leaves of the object at hand have told already.
    FetchedSpans fetched;

    /// Ends of a merge's solids; kept for its memory.
    std::vector<MergedEnd>& merged_ends() { return merged_ends_; }
    /// Items that wait for others to be asked first; kept for its memory.
    std::vector<OrderedItem>& ordered_items() { return ordered_items_; }
    /// What lies in one place: items, and a hit of each.
    std::vector<std::uint32_t>& tied_items() { return tied_items_; }
    std::vector<Hit>& tied_hits() { return tied_hits_; }

    /// Looked at by every question to a World.
    CancelWatch cancel;

    /// Keeps a crossing.
    void add(const Crossing& c) { crossings_.push_back(c); }
    /// Keeps a crossing unless it is there already: terms share solids.
    void add_once(const Crossing& c)
    {
        for (const Crossing& known : crossings_)
            if (known.t == c.t && known.part == c.part && known.face == c.face) return;
        crossings_.push_back(c);
    }
    std::pair<const Crossing*, const Crossing*> crossings() const
    {
        return {crossings_.data(), crossings_.data() + crossings_.size()};
    }

private:
    friend class TreeEnds;
    friend class Evaluation;
    void grow_pieces(std::size_t count);
    std::vector<TreeEnd> ends_, waiting_;              ///< of the tree at hand: those in order, and the others
    std::vector<std::uint32_t> counts_;                ///< by node
    std::vector<std::uint32_t> seen_, place_, steps_;  ///< among ends_
    std::vector<Span> spans_, inside_;
    std::vector<Crossing> crossings_;
    std::unique_ptr<ProductPiece[]> pieces_;
    std::unique_ptr<RayBatch> batch_;
    std::vector<Hit> hits_, instance_hits_;
    std::vector<MergedEnd> merged_ends_;
    std::vector<OrderedItem> ordered_items_;
    std::vector<std::uint32_t> tied_items_;
    std::vector<Hit> tied_hits_;
    std::vector<ProductCandidate> candidates_;
    std::size_t piece_capacity_ = 0;
};

/// Whether the world point is inside (spec 5a, 8.1 and 2.4).
bool contains(const Program& program, const SolidStore& store, const glm::dvec3& p);

}  // namespace csg

#include "csg/tree/front.h"
