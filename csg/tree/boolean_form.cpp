#include "csg/tree/boolean_form.h"

#include "csg/tree/program.h"

#include <algorithm>

namespace csg {
namespace {

/// Intervals of a leaf along any ray, as far as lanes have room for them.
std::uint32_t most_pieces(const Node& node, const SolidStore& store)
{
    return with_solid(store, node.solid, [&](const auto& solid) {
        using T = std::decay_t<decltype(solid)>;
        if constexpr (std::is_same_v<T, Quadric> || std::is_same_v<T, Torus>) return 2u;
        else if constexpr (std::is_same_v<T, Cone>) return solid.convex() ? 1u : 2u;
        else if constexpr (requires(Interval & out) { solid.interval(Ray{}, out); }) return 1u;
        else return std::min(node.max_spans, BooleanForm::kMostOfLeaf);
    });
}

class BooleanCompiler {
public:
    BooleanCompiler(const Program& program, const SolidStore& store) : nodes_(program.nodes), store_(store) {}

    BooleanForm run()
    {
        if (nodes_.empty()) return {};
        form_.first_leaf.reserve(nodes_.size() + 1);
        for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
            if (nodes_[i].op == Op::Guard) return {};
            form_.first_leaf.push_back(static_cast<std::uint8_t>(form_.leaves.size()));
            if (nodes_[i].op == Op::Leaf && !add_leaf(i)) return {};
        }
        form_.first_leaf.push_back(static_cast<std::uint8_t>(form_.leaves.size()));
        std::vector<std::uint32_t> path;
        conditions_below(0, path);
        return std::move(form_);
    }

private:
    bool add_leaf(std::uint32_t i)
    {
        const Node& node = nodes_[i];
        BooleanLeaf leaf;
        leaf.most_pieces = static_cast<std::uint8_t>(most_pieces(node, store_));
        pieces_ += leaf.most_pieces;
        // A torus' inner sheet is a piece within the outer one's.
        const bool alone = node.draws_alone && kind_of(node.solid) != SolidKind::Torus;
        if (pieces_ > BooleanForm::kMostPieces || alone) return false;
        leaf.solid = node.solid;
        leaf.node = i;
        leaf.inverted = node.inverted;
        leaf.normal_flipped = node.normal_flipped;
        leaf.closed = node.closed;
        leaf.drawn = node.drawn;
        leaf.rank = static_cast<std::uint8_t>(node.rank);
        form_.leaves.push_back(leaf);
        return true;
    }

    /// Works out the conditions of the leaves below node i. path: its ancestors.
    void conditions_below(std::uint32_t i, std::vector<std::uint32_t>& path)
    {
        if (nodes_[i].op == Op::Leaf) {
            BooleanLeaf& leaf = form_.leaves[form_.first_leaf[i]];
            leaf.first = static_cast<std::uint32_t>(form_.conditions.size());
            for (std::size_t k = 0; k < path.size(); ++k)
                add_siblings(leaf, path[k], k + 1 < path.size() ? path[k + 1] : i);
            leaf.count = static_cast<std::uint32_t>(form_.conditions.size()) - leaf.first;
            return;
        }
        path.push_back(i);
        for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) conditions_below(k, path);
        path.pop_back();
    }

    /// What an ancestor asks of its operands other than the one that the leaf is in.
    void add_siblings(BooleanLeaf& leaf, std::uint32_t ancestor, std::uint32_t own)
    {
        const Op op = nodes_[ancestor].op;
        if (op == Op::Union) return;
        for (std::uint32_t k = ancestor + 1; k < nodes_[ancestor].end; k = nodes_[k].end)
            if (k != own) add_condition(leaf, k, op != Op::Merge);
    }

    void add_condition(BooleanLeaf& leaf, std::uint32_t i, bool inside)
    {
        const Op op = nodes_[i].op;
        if (op == Op::Leaf) {
            (inside ? leaf.inside : leaf.outside) |= std::uint64_t{1} << form_.first_leaf[i];
        } else if (inside == (op == Op::Intersection || op == Op::Clip)) {
            for (std::uint32_t k = i + 1; k < nodes_[i].end; k = nodes_[k].end) add_condition(leaf, k, inside);
        } else {
            form_.conditions.push_back({i, inside});
            for (std::uint32_t k = i; k < nodes_[i].end; ++k)
                if (nodes_[k].op == Op::Leaf) leaf.below |= std::uint64_t{1} << form_.first_leaf[k];
        }
    }

    const std::vector<Node>& nodes_;
    const SolidStore& store_;
    BooleanForm form_;
    std::uint32_t pieces_ = 0;
};

}  // namespace

BooleanForm boolean_form(const Program& program, const SolidStore& store)
{
    return BooleanCompiler(program, store).run();
}

}  // namespace csg
