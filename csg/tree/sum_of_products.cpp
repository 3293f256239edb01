#include "csg/tree/sum_of_products.h"

#include "csg/tree/program.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace csg {
namespace {

constexpr std::size_t kMostInCut = 8;

/// A cut while it is worked out: leaves by node index.
using Group = std::vector<std::uint32_t>;

struct DraftTerm {
    Group leaves;
    std::vector<Group> cuts;
};

enum class Shape { Convex, Spans, Unfit };

Shape shape_of(const SolidStore& store, PartId part)
{
    return with_solid(store, part, [](const auto& solid) {
        using T = std::decay_t<decltype(solid)>;
        if constexpr (std::is_same_v<T, Cylinder>) return solid.open ? Shape::Unfit : Shape::Convex;
        else if constexpr (std::is_same_v<T, Cone>)
            return solid.open ? Shape::Unfit : solid.convex() ? Shape::Convex : Shape::Spans;
        else if constexpr (std::is_same_v<T, Torus>) return solid.spindle() ? Shape::Unfit : Shape::Spans;
        else if constexpr (std::is_same_v<T, Quadric>) return Shape::Spans;
        else if constexpr (std::is_same_v<T, Sphere> || std::is_same_v<T, Ellipsoid> || std::is_same_v<T, Box> ||
                           std::is_same_v<T, OrientedBox> || std::is_same_v<T, Plane>)
            return Shape::Convex;
        else return Shape::Unfit;
    });
}

class Flattener {
public:
    Flattener(const Program& program, const SolidStore& store) : nodes_(program.nodes), store_(store) {}

    SumOfProducts run()
    {
        form_.merged = nodes_[0].op == Op::Merge;
        const auto term = form_.merged ? merge_of(0) : term_of(0);
        return term && add(*term) ? std::move(form_) : SumOfProducts{};
    }

private:
    Shape shape(std::uint32_t i) const { return shape_of(store_, nodes_[i].solid); }

    /// Whether the leaves can be intersected by interval: convex, or one alone. None are all of space: where pruning
    /// has left an operator without operands.
    bool fit_for_cut(const Group& group) const
    {
        if (group.size() == 1) return true;
        return !group.empty() && group.size() <= kMostInCut &&
               std::all_of(group.begin(), group.end(), [&](std::uint32_t i) { return shape(i) == Shape::Convex; });
    }

    std::optional<DraftTerm> term_of(std::uint32_t i) const
    {
        const Node& node = nodes_[i];
        switch (node.op) {
        case Op::Leaf: {
            if (shape(i) == Shape::Unfit) return std::nullopt;
            DraftTerm term;
            if (node.inverted) term.cuts.push_back({i});
            else term.leaves.push_back(i);
            return term;
        }
        case Op::Union: return nodes_[i + 1].end == node.end ? term_of(i + 1) : std::nullopt;
        case Op::Intersection: return product(i);
        case Op::Merge: return subtracted_intersection(i);
        case Op::Clip:
        case Op::Guard: return std::nullopt;
        }
        return std::nullopt;
    }

    std::optional<DraftTerm> product(std::uint32_t i) const
    {
        DraftTerm all;
        for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) {
            const auto term = term_of(k);
            if (!term) return std::nullopt;
            append(all, *term);
        }
        return all;
    }

    static void append(DraftTerm& to, const DraftTerm& from)
    {
        to.leaves.insert(to.leaves.end(), from.leaves.begin(), from.leaves.end());
        to.cuts.insert(to.cuts.end(), from.cuts.begin(), from.cuts.end());
    }

    /// A merge of inverted leaves is the inverse of their intersection: one cut.
    std::optional<DraftTerm> subtracted_intersection(std::uint32_t i) const
    {
        Group group;
        for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) {
            if (nodes_[k].op != Op::Leaf || !nodes_[k].inverted || shape(k) == Shape::Unfit) return std::nullopt;
            group.push_back(k);
        }
        if (!fit_for_cut(group)) return std::nullopt;
        return DraftTerm{{}, {group}};
    }

    /// A merge at the top: its operands, solids or intersections of convex ones, become the cuts of one term.
    std::optional<DraftTerm> merge_of(std::uint32_t i) const
    {
        DraftTerm all;
        for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) {
            const auto term = nodes_[k].op == Op::Merge ? merge_of(k) : term_of(k);
            if (!term) return std::nullopt;
            if (nodes_[k].op == Op::Merge) {
                append(all, *term);
            } else {
                if (!term->cuts.empty() || !fit_for_cut(term->leaves)) return std::nullopt;
                all.cuts.push_back(term->leaves);
            }
        }
        return all;
    }

    ProductLeaf leaf(std::uint32_t i) const
    {
        const Node& node = nodes_[i];
        return {node.solid, node.inverted && kind_of(node.solid) != SolidKind::Quadric, shape(i) == Shape::Convex};
    }

    Aabb box(std::uint32_t i) const
    {
        return with_solid(store_, nodes_[i].solid, [](const auto& solid) { return solid.bounds(); });
    }
    Aabb common_box(const Group& group) const
    {
        Aabb common = Aabb::everything();
        for (const std::uint32_t i : group) common = common.intersected(box(i));
        return common;
    }

    void put_cut_box(std::size_t place, const Aabb& box)
    {
        std::vector<BoxBlock>& blocks = form_.cut_boxes;
        if (place / 8 >= blocks.size()) {
            BoxBlock& fresh = blocks.emplace_back();
            for (int row = 0; row < 6; ++row)
                std::fill_n(fresh.bounds[row], 8,
                            row < 3 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity());
        }
        for (int axis = 0; axis < 3; ++axis) {
            blocks[place / 8].bounds[axis][place % 8] = rounded(box.lower[axis], -1.0f);
            blocks[place / 8].bounds[axis + 3][place % 8] = rounded(box.upper[axis], 1.0f);
        }
    }
    static float rounded(double v, float towards)
    {
        const auto f = static_cast<float>(v);
        const bool enough = towards < 0.0f ? static_cast<double>(f) <= v : static_cast<double>(f) >= v;
        return enough ? f : std::nextafter(f, towards * std::numeric_limits<float>::infinity());
    }

    /// False: it has no such form, or nothing is in it.
    bool add(const DraftTerm& draft)
    {
        Group leaves = draft.leaves;
        // The one that is not convex comes last, and has to be a quadric.
        const auto convex = [&](std::uint32_t i) { return shape(i) == Shape::Convex; };
        const auto spans = std::stable_partition(leaves.begin(), leaves.end(), convex);
        if (leaves.end() - spans > 1) return false;
        if (spans != leaves.end() && kind_of(nodes_[*spans].solid) != SolidKind::Quadric) return false;

        const Aabb own = common_box(leaves);
        if (own.empty() && !leaves.empty()) return false;
        ProductTerm& term = form_.term.emplace();
        for (const std::uint32_t i : leaves) form_.leaves.push_back(leaf(i));
        term.last = static_cast<std::uint32_t>(form_.leaves.size());
        term.convex = spans == leaves.end();
        add_cuts(term, draft.cuts, own);
        return true;
    }

    void add_cuts(ProductTerm& term, const std::vector<Group>& all, const Aabb& within)
    {
        term.wide_cuts = true;
        for (const Group& group : all) {
            const Aabb box = common_box(group);
            if (box.intersected(within).empty()) continue;
            term.wide_cuts = term.wide_cuts && box.holds(within);
            term.bounded_cuts = term.bounded_cuts && box.finite();
            put_cut_box(form_.cuts.size(), box);
            form_.cuts.push_back(
                {static_cast<std::uint32_t>(form_.leaves.size()), static_cast<std::uint32_t>(group.size())});
            for (const std::uint32_t i : group) form_.leaves.push_back(leaf(i));
        }
        term.cut_last = static_cast<std::uint32_t>(form_.cuts.size());
    }

    const std::vector<Node>& nodes_;
    const SolidStore& store_;
    SumOfProducts form_;
};

}  // namespace

SumOfProducts sum_of_products(const Program& program, const SolidStore& store)
{
    if (program.nodes.empty()) return {};
    return Flattener(program, store).run();
}

}  // namespace csg
