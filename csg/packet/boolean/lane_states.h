#pragma once

#include "csg/packet/lanes/tile_rays.h"
#include "csg/tree/program.h"

/// Which leaves of a boolean form hold a place on each of some rays.
namespace csg {

class LaneStates {
    using Bool = lanes::Bool;

public:
    /// Before rays are asked of a program.
    void start(const Program& program)
    {
        nodes_ = program.nodes.data();
        form_ = &program.boolean;
        left_out_ = 0;
    }

    /// These rays meet nothing of the subtree at node n: its inverted leaves do not hold them, though no piece of
    /// theirs says so.
    void leave_out(std::uint32_t n, RayMask rays)
    {
        if (rays == 0) return;
        const std::uint32_t end = form_->first_leaf[nodes_[n].end];
        for (std::uint32_t k = form_->first_leaf[n]; k < end; ++k) {
            if (!form_->leaves[k].inverted) continue;
            const std::uint64_t bit = std::uint64_t{1} << k;
            if ((left_out_ & bit) == 0) out_[k] = 0;
            left_out_ |= bit;
            out_[k] |= rays;
        }
    }

    /// Of the rays from i on, before the pieces of these leaves are looked at.
    void begin(std::uint64_t leaves, int i)
    {
        for (std::uint64_t left = leaves; left != 0; left &= left - 1)
            holds_[bit(left)] = Bool(form_->leaves[bit(left)].inverted);
        for (std::uint64_t left = leaves & left_out_; left != 0; left &= left - 1)
            holds_[bit(left)] = !lanes::lanes_of(static_cast<std::uint32_t>(out_[bit(left)] >> i & kVector));
    }

    /// The rays that a leaf holds.
    Bool& operator[](std::uint32_t leaf) { return holds_[leaf]; }

    /// Of the rays asked, those for which an end of the leaf is seen.
    Bool seen(const BooleanLeaf& own, Bool asked) const
    {
        for (std::uint64_t left = own.inside; left != 0; left &= left - 1) asked = asked & holds_[bit(left)];
        for (std::uint64_t left = own.outside; left != 0; left &= left - 1) asked = asked & !holds_[bit(left)];
        for (std::uint32_t k = own.first; k < own.first + own.count && lanes::mask(asked) != 0; ++k) {
            const BooleanCondition& condition = form_->conditions[k];
            const Bool held = holds(condition.node);
            asked = asked & (condition.inside ? held : !held);
        }
        return asked;
    }

private:
    static constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;
    static std::size_t bit(std::uint64_t mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }

    /// Those that are inside of the subtree at node i.
    Bool holds(std::uint32_t i) const
    {
        const Node& node = nodes_[i];
        if (node.op == Op::Leaf) return holds_[form_->first_leaf[i]];
        const bool all = node.op == Op::Intersection || node.op == Op::Clip;
        Bool out(all);
        for (std::uint32_t k = i + 1; k < node.end; k = nodes_[k].end) {
            const Bool one = holds(k);
            out = all ? out & one : out | one;
        }
        return out;
    }

    const Node* nodes_ = nullptr;
    const BooleanForm* form_ = nullptr;
    std::uint64_t left_out_ = 0;             ///< inverted leaves that do not hold some rays
    RayMask out_[BooleanForm::kMostLeaves];  ///< these
    Bool holds_[BooleanForm::kMostLeaves];
};

}  // namespace csg
