#pragma once

// What one ray meets of a term; inline, since each kernel has its own.
#include "csg/tree/evaluate.h"
#include "csg/tree/sum_of_products.h"
#include "csg/bvh/traverse.h"

#include <bit>

namespace csg {

/// How a question to a sum of products ends. Undecided: two ends coincide; the general evaluation knows which of them
/// is drawn.
enum class ProductAnswer { Found, Nothing, Undecided };

/// One ray against the leaves and cuts of a term. `slabs` may be null: it is worked out where boxes have to be tested.
class ProductIntersector {
public:
    ProductIntersector(const SumOfProducts& form, const SolidStore& store, const Ray& ray, const RaySlabs* slabs,
                       double t_min, double t_max, Scratch& scratch)
        : form_(form), store_(store), ray_(ray), slabs_(slabs), t_min_(t_min), t_max_(t_max), scratch_(scratch)
    {
        reach_ = origin_reach(ray);
    }

protected:
    static constexpr std::uint32_t kNoLeaf = 0xffffffffu;
    static constexpr float kAnywhere = -std::numeric_limits<float>::infinity();

    double slack(double t) const { return kCoincidence * (std::abs(t) + reach_); }
    bool close(double a, double b) const
    {
        const double gap = std::abs(a - b);
        return gap <= slack(a) && gap < kInfinity;
    }
    /// Beyond the range, and whatever coincides with it is too.
    bool passed(double t) const { return t - 2.0 * slack(t) > t_max_; }
    bool within(double t) const { return t <= t_max_ && t < kInfinity; }

    Crossing crossing(const ProductEnd& end) const
    {
        const ProductLeaf& leaf = form_.leaves[end.leaf];
        return {.t = end.t, .part = leaf.solid, .face = end.face, .inverted = leaf.normal_flipped};
    }

    /// Calls f for the terms whose box the ray meets between t_min and t_max as they are then, until f returns false.
    template <class F>
    void each_term(F&& f)
    {
        if (form_.terms.size() == 1) {
            f(form_.terms[0]);
            return;
        }
        with_slabs([&](const RaySlabs& slabs) {
            const float begin = rounded_down(t_min_);
            for (std::size_t block = 0; block < form_.term_boxes.size(); ++block) {
                alignas(32) float near[8];
                std::uint32_t mask = slabs.intersect(form_.term_boxes[block].bounds, begin, rounded_up(t_max_), near);
                for (; mask != 0; mask &= mask - 1) {
                    const int k = std::countr_zero(mask);
                    if (static_cast<double>(near[k]) > t_max_) continue;
                    if (!f(form_.terms[8 * block + static_cast<std::size_t>(k)])) return;
                }
            }
        });
    }

    /// What the convex leaves leave of the line.
    ProductAnswer meet_leaves(const ProductTerm& term, ProductPiece& piece) const
    {
        piece = {{-kInfinity, kNoLeaf, 0}, {kInfinity, kNoLeaf, 0}};
        return narrow(piece, term.first, term.convex ? term.last : term.last - 1, t_min_, t_max_);
    }

    /// The pieces of the ray in all leaves that meet the range, for a term with one leaf that is not convex: at most
    /// kProductSpans, nearest first.
    ProductAnswer meet_pieces(const ProductTerm& term, ProductPiece (&pieces)[kProductSpans],
                              std::uint32_t& count) const
    {
        count = 0;
        ProductPiece all;
        const ProductAnswer met = meet_leaves(term, all);
        if (met != ProductAnswer::Found) return met;
        const std::uint32_t last = term.last - 1;
        Span memory[kProductSpans + 1];
        SpanList spans(memory, kProductSpans + 1);
        with_solid(store_, form_.leaves[last].solid, [&](const auto& solid) { intersect(solid, ray_, spans); });
        for (const Span& span : spans) {
            const double entry = span.in.t, exit = span.out.t;
            if (close(entry, all.in.t) || close(exit, all.out.t) || close(entry, all.out.t) || close(exit, all.in.t))
                return ProductAnswer::Undecided;
            ProductPiece piece = all;
            if (entry > all.in.t) piece.in = {entry, last, span.in.face};
            if (exit < all.out.t) piece.out = {exit, last, span.out.face};
            if (piece.in.t > piece.out.t || piece.in.t > t_max_ || piece.out.t < t_min_) continue;
            pieces[count++] = piece;
        }
        return count == 0 ? ProductAnswer::Nothing : ProductAnswer::Found;
    }

    /// The cuts that may meet the ray between `in` and `out`, as far as the range reaches: none is evaluated yet.
    void find_cuts(const ProductTerm& term, double in, double out)
    {
        count_ = waiting_ = 0;
        in_ = in;
        out_ = out;
        if (term.cut_first == term.cut_last) return;
        const auto room = static_cast<std::size_t>(term.cut_last - term.cut_first);
        cuts_ = scratch_.product_pieces(form_.span_memory);
        candidates_ = scratch_.product_candidates(static_cast<std::uint32_t>(room));
        // Margins: an end that coincides with the beginning or the end of the piece must be seen.
        low_ = glm::max(in - slack(in), t_min_);
        high_ = glm::min(out + slack(out), t_max_);
        if (room <= 2) {
            for (std::uint32_t k = term.cut_first; k < term.cut_last; ++k) candidates_[waiting_++] = {kAnywhere, k};
            return;
        }
        with_slabs([&](const RaySlabs& slabs) {
            if (term.tree != ProductTerm::kNoTree) {
                traverse(form_.trees[term.tree], slabs, low_, high_, 0xffu, [&](ChildWord word) {
                    candidates_[waiting_++] = {kAnywhere, word.index()};
                    return high_;
                });
                return;
            }
            const float begin = rounded_down(low_), limit = rounded_up(high_);
            for (std::uint32_t first = term.cut_first; first < term.cut_last; first += 8) {
                alignas(32) float near[8];
                std::uint32_t mask = slabs.intersect(form_.cut_boxes[first / 8].bounds, begin, limit, near);
                for (; mask != 0; mask &= mask - 1) {
                    const int k = std::countr_zero(mask);
                    candidates_[waiting_++] = {near[k], first + static_cast<std::uint32_t>(k)};
                }
            }
        });
    }

    /// Evaluates the cuts found that may begin at t or before, into cuts_[0 .. count_). Undecided: an end coincides
    /// with an end of the piece.
    ProductAnswer evaluate_cuts(double t)
    {
        for (std::uint32_t i = 0; i < waiting_;) {
            if (static_cast<double>(candidates_[i].near) > t) {
                ++i;
                continue;
            }
            const std::uint32_t cut = candidates_[i].cut;
            candidates_[i] = candidates_[--waiting_];
            if (!add_cut(form_.cuts[cut], in_, out_)) return ProductAnswer::Undecided;
        }
        return ProductAnswer::Found;
    }

    /// Where the nearest of the cuts not yet evaluated may begin; infinite when there is none.
    double nearest_waiting() const
    {
        float near = std::numeric_limits<float>::infinity();
        for (std::uint32_t i = 0; i < waiting_; ++i) near = glm::min(near, candidates_[i].near);
        return static_cast<double>(near);
    }

    const SumOfProducts& form_;
    const SolidStore& store_;
    const Ray& ray_;
    const RaySlabs* slabs_;
    double t_min_, t_max_, reach_ = 0.0;
    ProductPiece* cuts_ = nullptr;
    std::uint32_t count_ = 0, waiting_ = 0;  ///< cuts evaluated, and found but not evaluated

private:
    template <class F>
    void with_slabs(F&& f) const
    {
        if (slabs_ != nullptr) f(*slabs_);
        else f(RaySlabs(ray_));
    }

    /// A convex solid's interval; false where the ray misses it.
    bool interval(const ProductLeaf& leaf, Interval& out) const
    {
        if (kind_of(leaf.solid) == SolidKind::Sphere)
            return store_.all<Sphere>()[index_of(leaf.solid)].interval(ray_, out);
        return with_solid(store_, leaf.solid, [&](const auto& solid) {
            if constexpr (requires { solid.interval(ray_, out); }) return solid.interval(ray_, out);
            else return false;  // never convex
        });
    }

    /// Narrows a piece to leaves[first .. last), all convex; Nothing as soon as it is empty or out of [low, high].
    ProductAnswer narrow(ProductPiece& piece, std::uint32_t first, std::uint32_t last, double low, double high) const
    {
        for (std::uint32_t k = first; k < last; ++k) {
            Interval own;
            if (!interval(form_.leaves[k], own) || own.entry > high || own.exit < low) return ProductAnswer::Nothing;
            if (close(own.entry, piece.in.t) || close(own.exit, piece.out.t)) return ProductAnswer::Undecided;
            if (own.entry > piece.in.t) piece.in = {own.entry, k, own.entry_face};
            if (own.exit < piece.out.t) piece.out = {own.exit, k, own.exit_face};
            if (close(piece.in.t, piece.out.t)) return ProductAnswer::Undecided;
            if (piece.in.t > piece.out.t) return ProductAnswer::Nothing;
        }
        return ProductAnswer::Found;
    }

    /// False: an end coincides with the end of the piece.
    bool add_cut(const ProductCut& cut, double in, double out)
    {
        const auto keep = [&](const ProductPiece& piece) {
            if (piece.out.t < low_ || piece.in.t > high_) return true;
            if (close(piece.in.t, out) || close(piece.out.t, in)) return false;
            cuts_[count_++] = piece;
            return true;
        };
        if (!form_.leaves[cut.first].convex) {
            Span memory[kProductSpans + 1];
            SpanList spans(memory, kProductSpans + 1);
            with_solid(store_, form_.leaves[cut.first].solid,
                       [&](const auto& solid) { intersect(solid, ray_, spans); });
            for (const Span& span : spans)
                if (!keep({{span.in.t, cut.first, span.in.face}, {span.out.t, cut.first, span.out.face}})) return false;
            return true;
        }
        if (cut.count == 1) {
            Interval own;
            if (!interval(form_.leaves[cut.first], own)) return true;
            return keep({{own.entry, cut.first, own.entry_face}, {own.exit, cut.first, own.exit_face}});
        }
        ProductPiece piece{{-kInfinity, kNoLeaf, 0}, {kInfinity, kNoLeaf, 0}};
        switch (narrow(piece, cut.first, cut.first + cut.count, low_, high_)) {
        case ProductAnswer::Nothing: return true;
        case ProductAnswer::Undecided: return false;
        case ProductAnswer::Found: break;
        }
        return keep(piece);
    }

    Scratch& scratch_;
    ProductCandidate* candidates_ = nullptr;
    double low_ = 0.0, high_ = 0.0, in_ = 0.0, out_ = 0.0;
};

}  // namespace csg
