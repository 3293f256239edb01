#include "csg/tree/sum_of_products.h"

#include "csg/tree/program.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace csg {
namespace {

constexpr std::size_t kMostTerms = 256, kMostCutsMultiplied = 65536, kMostInCut = 8;
/// From so many cuts on a hierarchy finds them faster than one box after the other.
constexpr std::size_t kManyCuts = 32;

/// A cut while it is worked out: leaves by node index.
using Group = std::vector<std::uint32_t>;

struct DraftTerm {
    Group leaves;
    std::vector<Group> cuts;
};
using DraftTerms = std::vector<DraftTerm>;

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
        const auto terms = nodes_[0].op == Op::Merge ? merge_of(0) : terms_of(0);
        if (!terms || terms->empty() || terms->size() > kMostTerms) return {};
        form_.merged = nodes_[0].op == Op::Merge;
        for (const DraftTerm& term : *terms)
            if (!add(term)) return {};
        return std::move(form_);
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

    std::optional<DraftTerms> terms_of(std::uint32_t i) const
    {
        const Node& node = nodes_[i];
        switch (node.op) {
        case Op::Leaf: {
            if (shape(i) == Shape::Unfit) return std::nullopt;
            DraftTerm term;
            if (node.inverted) term.cuts.push_back({i});
            else term.leaves.push_back(i);
            return DraftTerms{std::move(term)};
        }
        case Op::Union: return sum(i);
        case Op::Intersection: return product(i);
        case Op::Merge: return subtracted_intersection(i);
        case Op::Clip:
        case Op::Guard: return std::nullopt;
        }
        return std::nullopt;
    }

    std::optional<DraftTerms> sum(std::uint32_t i) const
    {
        DraftTerms all;
        for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) {
            auto terms = terms_of(k);
            if (!terms || all.size() + terms->size() > kMostTerms) return std::nullopt;
            std::move(terms->begin(), terms->end(), std::back_inserter(all));
        }
        return all;
    }

    std::optional<DraftTerms> product(std::uint32_t i) const
    {
        DraftTerms all(1);
        for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) {
            const auto terms = terms_of(k);
            if (!terms || all.size() * terms->size() > kMostTerms) return std::nullopt;
            if (terms->size() == 1) {
                for (DraftTerm& term : all) append(term, terms->front());
                continue;
            }
            DraftTerms multiplied;
            for (const DraftTerm& a : all)
                for (const DraftTerm& b : *terms) append(multiplied.emplace_back(a), b);
            all = std::move(multiplied);
        }
        std::size_t cuts = 0;
        for (const DraftTerm& term : all) cuts += term.cuts.size();
        if (cuts > kMostCutsMultiplied && all.size() > 1) return std::nullopt;
        return all;
    }

    static void append(DraftTerm& to, const DraftTerm& from)
    {
        to.leaves.insert(to.leaves.end(), from.leaves.begin(), from.leaves.end());
        to.cuts.insert(to.cuts.end(), from.cuts.begin(), from.cuts.end());
    }

    /// A merge of inverted leaves is the inverse of their intersection: one cut.
    std::optional<DraftTerms> subtracted_intersection(std::uint32_t i) const
    {
        Group group;
        for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) {
            if (nodes_[k].op != Op::Leaf || !nodes_[k].inverted || shape(k) == Shape::Unfit) return std::nullopt;
            group.push_back(k);
        }
        if (!fit_for_cut(group)) return std::nullopt;
        return DraftTerms{DraftTerm{{}, {group}}};
    }

    /// A merge at the top: its operands, solids or intersections of convex ones, become the cuts of one term.
    std::optional<DraftTerms> merge_of(std::uint32_t i) const
    {
        DraftTerm all;
        for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) {
            const auto terms = nodes_[k].op == Op::Merge ? merge_of(k) : terms_of(k);
            if (!terms || terms->size() != 1) return std::nullopt;
            const DraftTerm& term = terms->front();
            if (nodes_[k].op == Op::Merge) {
                append(all, term);
            } else {
                if (!term.cuts.empty() || !fit_for_cut(term.leaves)) return std::nullopt;
                all.cuts.push_back(term.leaves);
            }
        }
        return DraftTerms{std::move(all)};
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

    static void put(std::vector<BoxBlock>& blocks, std::size_t place, const Aabb& box)
    {
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

    bool add(const DraftTerm& draft)
    {
        Group leaves = draft.leaves;
        const auto spans = static_cast<std::size_t>(
            std::count_if(leaves.begin(), leaves.end(), [&](std::uint32_t i) { return shape(i) == Shape::Spans; }));
        if (spans > 1) return false;
        // The one that is not convex comes last: its spans are clipped to what the others leave.
        std::stable_partition(leaves.begin(), leaves.end(), [&](std::uint32_t i) { return shape(i) == Shape::Convex; });

        const Aabb own = common_box(leaves);
        if (own.empty() && !leaves.empty()) return true;  // nothing in it
        ProductTerm term;
        term.first = static_cast<std::uint32_t>(form_.leaves.size());
        for (const std::uint32_t i : leaves) form_.leaves.push_back(leaf(i));
        term.last = static_cast<std::uint32_t>(form_.leaves.size());
        term.convex = spans == 0;
        add_cuts(term, draft.cuts, own);
        put(form_.term_boxes, form_.terms.size(), leaves.empty() ? Aabb::everything() : own);
        form_.terms.push_back(term);
        return true;
    }

    void add_cuts(ProductTerm& term, const std::vector<Group>& all, const Aabb& within)
    {
        std::vector<Group> groups;
        for (const Group& group : all)
            if (!common_box(group).intersected(within).empty()) groups.push_back(group);
        term.wide_cuts = std::all_of(groups.begin(), groups.end(),
                                     [&](const Group& group) { return common_box(group).holds(within); });
        const auto known = known_cuts_.find(groups);
        if (known != known_cuts_.end()) {
            term.cut_first = known->second.cut_first;
            term.cut_last = known->second.cut_last;
            term.tree = known->second.tree;
            term.bounded_cuts = known->second.bounded_cuts;
            return;
        }
        form_.cuts.resize((form_.cuts.size() + 7) / 8 * 8);
        term.cut_first = static_cast<std::uint32_t>(form_.cuts.size());
        std::vector<BvhInput> inputs;
        std::uint32_t spans = 1;
        for (const Group& group : groups) {
            const Aabb box = common_box(group);
            put(form_.cut_boxes, form_.cuts.size(), box);
            inputs.push_back({box, LeafKind::Item, static_cast<std::uint32_t>(form_.cuts.size()), 0xff});
            term.bounded_cuts = term.bounded_cuts && box.finite();
            form_.cuts.push_back(
                {static_cast<std::uint32_t>(form_.leaves.size()), static_cast<std::uint32_t>(group.size())});
            for (const std::uint32_t i : group) form_.leaves.push_back(leaf(i));
            spans += shape(group.front()) == Shape::Convex ? 1 : kProductSpans;
        }
        term.cut_last = static_cast<std::uint32_t>(form_.cuts.size());
        form_.span_memory = std::max(form_.span_memory, spans);
        if (term.bounded_cuts && groups.size() >= kManyCuts) {
            term.tree = static_cast<std::uint32_t>(form_.trees.size());
            form_.trees.push_back(build_bvh(std::move(inputs)));
        }
        known_cuts_.emplace(std::move(groups), term);
    }

    const std::vector<Node>& nodes_;
    const SolidStore& store_;
    SumOfProducts form_;
    std::map<std::vector<Group>, ProductTerm> known_cuts_;
};

}  // namespace

bool SumOfProducts::simple() const
{
    return terms.size() == 1 && (terms[0].convex || kind_of(leaves[terms[0].last - 1].solid) == SolidKind::Quadric);
}

SumOfProducts sum_of_products(const Program& program, const SolidStore& store)
{
    if (program.nodes.empty()) return {};
    return Flattener(program, store).run();
}

}  // namespace csg
