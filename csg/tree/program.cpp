#include "csg/tree/program.h"

#include "csg/tree/contains.h"
#include "csg/tree/draft.h"

#include <algorithm>
#include <cmath>

namespace csg {

namespace {

float down(double v)
{
    const float f = static_cast<float>(v);
    return static_cast<double>(f) > v ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

float up(double v)
{
    const float f = static_cast<float>(v);
    return static_cast<double>(f) < v ? std::nextafter(f, std::numeric_limits<float>::infinity()) : f;
}

bool box_worth_testing(const Draft& draft)
{
    if (draft.op != Op::Leaf) return true;
    const SolidKind kind = kind_of(draft.solid);
    return kind == SolidKind::Torus || kind == SolidKind::Quadric || kind == SolidKind::Cone ||
           kind == SolidKind::Cylinder || kind == SolidKind::OrientedBox || kind == SolidKind::Ellipsoid ||
           kind == SolidKind::Mesh || kind == SolidKind::Extrusion || kind == SolidKind::Freeform;
}

std::uint32_t leaf_spans(PartId part, const SolidStore& store)
{
    return with_solid(store, part, [](const auto& solid) -> std::uint32_t {
        if constexpr (requires { solid.most_spans(); }) return solid.most_spans();
        else return 3;
    });
}

/// Whether a solid may draw what ends no span.
bool draws_alone(PartId part, const SolidStore& store)
{
    return with_solid(store, part, [](const auto& solid) {
        using T = std::decay_t<decltype(solid)>;
        if constexpr (std::is_same_v<T, Torus>) return solid.spindle();
        else if constexpr (std::is_same_v<T, Freeform>) return solid.reports_touches();
        else return std::is_same_v<T, Triangle> || std::is_same_v<T, Mesh>;
    });
}

void describe_leaf(Node& node, const SolidStore& store)
{
    const SolidKind kind = kind_of(node.solid);
    const bool bounds = with_solid(store, node.solid, [](const auto& solid) { return bounds_space(solid); });
    node.max_spans = leaf_spans(node.solid, store);
    node.turned = node.inverted && bounds && kind != SolidKind::Mesh;
    // POV-Ray negates an inverted quadric's coefficients and normal: the normal stays (spec 5a, 2.5). A patch ignores
    // inversion.
    node.normal_flipped = node.inverted && kind != SolidKind::Quadric && (bounds || kind == SolidKind::Mesh);
    node.closed = with_solid(store, node.solid, [&](const auto& solid) { return holds_surface(solid, node.inverted); });
    node.draws_alone = draws_alone(node.solid, store);
    node.quick = kind != SolidKind::Torus && kind != SolidKind::Mesh && kind != SolidKind::Extrusion &&
                 kind != SolidKind::Polynomial && kind != SolidKind::Freeform;
}

/// Appends the draft's nodes.
void flatten(const Draft& draft, const SolidStore& store, std::uint32_t parent, bool drawn, bool reversed,
             Program& program)
{
    reversed = reversed != draft.reversed;
    const bool backwards = reversed && draft.op != Op::Clip &&
                           draft.op != Op::Guard;  // of these the first is the shape
    const std::size_t count = draft.operands.size();
    const auto at = static_cast<std::uint32_t>(program.nodes.size());
    program.nodes.emplace_back();
    bool all_quick = true, mixed = false;
    for (std::size_t k = 0; k < count; ++k) {
        const auto operand = static_cast<std::uint32_t>(program.nodes.size());
        const bool seen = k == 0 || draft.op == Op::Guard || draft.op != Op::Clip;
        flatten(draft.operands[backwards ? count - 1 - k : k], store, at,
                (drawn || (draft.op == Op::Guard && k > 0)) && seen, reversed, program);
        mixed = mixed || (!all_quick && program.nodes[operand].quick);
        all_quick = all_quick && program.nodes[operand].quick;
    }
    Node& node = program.nodes[at];
    for (int i = 0; i < 3; ++i) {
        node.lower[static_cast<std::size_t>(i)] = down(draft.box.lower[i]);
        node.upper[static_cast<std::size_t>(i)] = up(draft.box.upper[i]);
    }
    node.end = static_cast<std::uint32_t>(program.nodes.size());
    node.parent = parent;
    node.solid = draft.solid;
    node.op = draft.op;
    node.inverted = draft.inverted;
    node.inside_beyond = draft.inside_beyond;
    node.test_box = box_worth_testing(draft);
    node.bounded = node.test_box && draft.box.finite() && !draft.inside_beyond;
    node.drawn = drawn;
    node.mixed = mixed && draft.op != Op::Union && draft.op != Op::Guard;
    if (draft.op != Op::Leaf) return;
    describe_leaf(node, store);
    program.span_memory = std::max(program.span_memory, node.max_spans);
}

/// Ranks the leaves below node i in the order of their crossings.
void rank_leaves(std::vector<Node>& nodes, std::uint32_t i, bool turned, std::uint32_t& rank)
{
    if (nodes[i].op == Op::Leaf) {
        nodes[i].rank = rank++;
        return;
    }
    std::vector<std::uint32_t> operands;
    for (std::uint32_t k = i + 1; k < nodes[i].end; k = nodes[k].end) operands.push_back(k);
    if (turned) std::reverse(operands.begin(), operands.end());
    for (const std::uint32_t k : operands) rank_leaves(nodes, k, turned != reverses(nodes[i].op), rank);
}

/// Whether an operator's answer is the same without an operand whose box the ray misses.
bool sieved(const Node& op, const Node& operand, bool first)
{
    if (op.op == Op::Union || op.op == Op::Merge) return !operand.inside_beyond;
    return operand.inside_beyond && !(op.op == Op::Clip && first);
}

/// Boxes of the operands of operators that have many.
void add_sieves(Program& program)
{
    constexpr std::uint32_t kFewest = 8;
    constexpr float kNever = std::numeric_limits<float>::infinity();
    for (std::uint32_t i = 0; i < program.nodes.size(); ++i) {
        Node& node = program.nodes[i];
        if (node.op == Op::Leaf || node.op == Op::Guard) continue;
        std::uint32_t count = 0;
        for (std::uint32_t k = i + 1; k < node.end; k = program.nodes[k].end) ++count;
        if (count < kFewest) continue;
        node.first_sieve = static_cast<std::uint32_t>(program.sieves.size());
        std::size_t place = 8;
        for (std::uint32_t k = i + 1; k < node.end; k = program.nodes[k].end) {
            if (place == 8) {
                OperandSieve& fresh = program.sieves.emplace_back();
                for (int row = 0; row < 6; ++row) std::fill_n(fresh.bounds[row], 8, row < 3 ? kNever : -kNever);
                std::fill_n(fresh.node, 8, 0u);
                place = 0;
            }
            OperandSieve& sieve = program.sieves.back();
            const Node& operand = program.nodes[k];
            const bool tested = sieved(node, operand, k == i + 1);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                sieve.bounds[axis][place] = tested ? operand.lower[axis] : -kNever;
                sieve.bounds[axis + 3][place] = tested ? operand.upper[axis] : kNever;
            }
            sieve.node[place++] = k;
        }
        node.last_sieve = static_cast<std::uint32_t>(program.sieves.size());
    }
}

/// The operands of a program that merges many solids, all of which are drawn at their ends alone.
std::vector<MergedSolid> merged_solids(const Program& program, const SolidStore& store)
{
    constexpr std::size_t kFewest = 8;
    std::vector<MergedSolid> out;
    if (program.nodes[0].op != Op::Merge) return out;
    for (std::uint32_t i = 1; i < program.nodes.size(); ++i) {
        const Node& node = program.nodes[i];
        if (node.op != Op::Leaf || node.inverted || node.draws_alone || node.max_spans == 0) return {};
        MergedSolid made;
        made.node = i;
        Transform frame;
        Aabb space;
        with_solid(store, node.solid, [&](const auto& solid) {
            if constexpr (std::is_same_v<std::decay_t<decltype(solid)>, Freeform>) {
                made.drawn = solid.drawn_bounds();
                frame = solid.frame;
                space = solid.space();
            } else {
                made.drawn = space = solid.bounds();
            }
        });
        const glm::dmat3 rows = glm::transpose(frame.inverse_linear);
        for (int axis = 0; axis < 3; ++axis) {
            made.rows[static_cast<std::size_t>(axis)] = rows[axis];
            made.size[axis] = glm::length(rows[axis]);
        }
        made.offset = frame.offset;
        made.lower = space.lower;
        made.upper = space.upper;
        out.push_back(made);
    }
    if (out.size() < kFewest) out.clear();
    return out;
}

}  // namespace

Program build(const Tree& tree, const SolidStore& store, Pruning* pruning)
{
    Pruning usual;
    const Draft draft = draft_of(tree, store, pruning != nullptr ? *pruning : usual);
    Program program;
    if (draft.op != Op::Leaf && draft.operands.empty()) return program;
    if (draft.op == Op::Leaf && draft.solid == kNoPart) return program;
    flatten(draft, store, 0, true, false, program);
    std::uint32_t rank = 0;
    rank_leaves(program.nodes, 0, false, rank);
    add_sieves(program);
    program.bounds = draft.box;
    program.inside_beyond = draft.inside_beyond;
    program.products = sum_of_products(program, store);
    program.boolean = boolean_form(program, store);
    program.merged = merged_solids(program, store);
    return program;
}

void Scratch::grow_pieces(std::size_t count)
{
    piece_capacity_ = count;
    pieces_ = std::make_unique<ProductPiece[]>(count);
}

bool contains(const Program& program, const SolidStore& store, const glm::dvec3& p)
{
    return !program.nodes.empty() && contains(program.nodes, 0, store, p, true);
}

}  // namespace csg
