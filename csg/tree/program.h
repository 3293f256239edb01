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
    PartId solid = kNoPart;                         ///< leaf only
    std::uint32_t max_spans = 0;                    ///< at most so many spans along any ray
    std::uint32_t first_sieve = 0, last_sieve = 0;  ///< of Program::sieves: boxes of its operands, where they are many
    Op op = Op::Leaf;
    bool inverted = false;       ///< leaf only
    bool inside_beyond = false;  ///< what lies outside the box is inside the solid (an inverted operand)
    bool test_box = true;        ///< false where the box test costs as much as the solid
};
static_assert(sizeof(Node) <= 64, "one cache line");

/// Boxes of eight operands of one operator, in their order, as rays test them (BvhNode::bounds). One that a ray misses
/// changes nothing of what the operator does there: it adds nothing to a union, takes nothing from an intersection.
/// Operands of which that is not so have a box without end. The last ones may be empty.
struct alignas(64) OperandSieve {
    float bounds[6][8];
    std::uint32_t node[8];  ///< among Program::nodes
};

/// A flattened CSG tree. Immutable once built; shared by all threads.
struct Program {
    std::vector<Node> nodes;  ///< empty: nothing to draw, nothing inside
    std::vector<OperandSieve> sieves;
    Aabb bounds;                 ///< world box of everything drawn; empty when nothing is
    bool inside_beyond = false;  ///< the solid goes on outside the bounds
    SumOfProducts products;      ///< the same as a union of terms, where it can be written so
    BooleanForm boolean;         ///< otherwise what decides which ends are drawn, where its leaves are few and simple
    std::uint32_t span_memory = 0;      ///< spans of scratch one query needs
    std::uint32_t crossing_memory = 0;  ///< crossings of scratch one query needs
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

/// Working memory of one thread, reused from ray to ray.
class Scratch {
public:
    void prepare(const Program& program)
    {
        if (program.span_memory > span_capacity_ || program.crossing_memory > crossing_capacity_ ||
            program.nodes.size() > record_capacity_)
            grow(program);
        span_top_ = 0;
        crossing_top_ = 0;
        record_top_ = 0;
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

    /// Items that wait for others to be asked first; kept for its memory.
    std::vector<OrderedItem>& ordered_items() { return ordered_items_; }
    /// What lies in one place: items, and a hit of each.
    std::vector<std::uint32_t>& tied_items() { return tied_items_; }
    std::vector<Hit>& tied_hits() { return tied_hits_; }

    /// Looked at by every question to a World.
    CancelWatch cancel;

    /// Keeps a crossing.
    void add(const Crossing& c) { crossings_[crossing_top_++] = c; }
    /// Keeps a crossing unless it is there already: terms share solids.
    void add_once(const Crossing& c)
    {
        for (std::uint32_t i = 0; i < crossing_top_; ++i)
            if (crossings_[i].t == c.t && crossings_[i].part == c.part && crossings_[i].face == c.face) return;
        crossings_[crossing_top_++] = c;
    }
    std::pair<const Crossing*, const Crossing*> crossings() const
    {
        return {crossings_.get(), crossings_.get() + crossing_top_};
    }

    /// What an operator remembers of one operand while it works.
    struct Record {
        SpanList spans;
        std::uint32_t node = 0;             ///< the operand
        std::uint32_t first = 0, last = 0;  ///< its crossings
        bool known = false;                 ///< spans were evaluated already
    };

private:
    friend class Evaluation;
    friend class BooleanWalk;
    void grow(const Program& program);
    void grow_pieces(std::size_t count);
    std::unique_ptr<Span[]> spans_;
    std::unique_ptr<Crossing[]> crossings_;
    std::unique_ptr<Record[]> records_;
    std::unique_ptr<ProductPiece[]> pieces_;
    std::unique_ptr<RayBatch> batch_;
    std::vector<Hit> hits_, instance_hits_;
    std::vector<OrderedItem> ordered_items_;
    std::vector<std::uint32_t> tied_items_;
    std::vector<Hit> tied_hits_;
    std::vector<ProductCandidate> candidates_;
    std::size_t span_capacity_ = 0, crossing_capacity_ = 0, record_capacity_ = 0, piece_capacity_ = 0;
    std::uint32_t span_top_ = 0, crossing_top_ = 0, record_top_ = 0;
};

/// Whether the world point is inside (spec 5a, 8.1 and 2.4).
bool contains(const Program& program, const SolidStore& store, const glm::dvec3& p);

}  // namespace csg

#include "csg/tree/front.h"
