#pragma once

#include "csg/beam.h"
#include "csg/lane_solids.h"
#include "csg/lane_torus.h"
#include "csg/program.h"
#include "csg/tile_rays.h"

/// A CSG object's flat form against a tile of rays, in vector lanes. Compiled once per instruction set.
namespace csg {

/// The nearest crossing of a flat form for each ray: latest entry and earliest exit of the leaves, then the front moves
/// through the cuts. Where FlatFront would be undecided, or the ray begins inside the leaves, the ray is left to it; all
/// other numbers are the solids' own, so the answers are the same.
class LaneFront {
public:
    LaneFront(const SolidStore& store, const Beam& beam, const TileRays& rays) : store_(store), beam_(beam), rays_(rays)
    {
        const glm::dvec3 o = glm::abs(rays.origin);
        reach_ = 1.75 * glm::max(o.x, glm::max(o.y, o.z));  // no less than FlatFront's for directions of unit length
    }

    /// An end as a number: kFaces * leaf of the form + face.
    struct LeafEnd {
        std::uint32_t leaf, face;
        explicit LeafEnd(double code) : leaf(static_cast<std::uint32_t>(code) / kFaces), face(static_cast<std::uint32_t>(code) % kFaces) {}
    };

    /// Asks for the rays of the mask a form that is simple(); the answers are in the members below until the next call.
    void ask(const FlatForm& form, RayMask mask)
    {
        found = undecided = 0;
        const FlatTerm& term = form.terms[0];
        mask = meet_leaves(form, term, mask);
        if (mask == 0) return;
        if (!meet_cuts(form, term, mask)) {
            undecided = mask;
            return;
        }
        each_vector(mask, [&](int i) { leave_cuts(i); });
        undecided &= mask;
        found &= mask & ~undecided;
    }

    /// Both ends of a form whose one term is plain(), for the rays found: entry, exit and their codes.
    void ask_ends(const FlatForm& form, RayMask mask)
    {
        undecided = 0;
        const RayMask met = meet_leaves(form, form.terms[0], mask);
        undecided &= mask;
        found = met & ~undecided;
    }
    double entry(std::size_t ray) const { return in_[ray]; }
    double exit(std::size_t ray) const { return out_[ray]; }
    LeafEnd entry_end(std::size_t ray) const { return LeafEnd(in_end_[ray]); }
    LeafEnd exit_end(std::size_t ray) const { return LeafEnd(out_end_[ray]); }

    RayMask found = 0, undecided = 0;
    alignas(64) TileRays::Lanes t;      ///< where found
    alignas(64) TileRays::Lanes end;    ///< which end of which leaf: decode by LeafEnd

private:
    using Double = lanes::Double;
    using Bool = lanes::Bool;
    using Lanes = TileRays::Lanes;

    static constexpr std::uint32_t kMostCuts = 48;   ///< that one tile meets
    static constexpr std::uint32_t kFaces = 8;   ///< more than any convex solid has

    static Double end_code(std::uint32_t leaf, Double face) { return Double(static_cast<double>(kFaces * leaf)) + face; }
    static Double load(const Lanes& from, int i) { return Double::load_aligned(from.data() + i); }
    static void store(Lanes& to, int i, Double v) { v.store_aligned(to.data() + i); }
    static RayMask bits(Bool b, int i) { return static_cast<RayMask>(lanes::mask(b)) << i; }

    Bool close(Double a, Double b) const
    {
        const Double gap = xsimd::abs(a - b);
        return (gap <= Double(kCoincidence) * (xsimd::abs(a) + Double(reach_))) & (gap < lanes::beyond());
    }

    /// in_ to out_: what all leaves hold. Returns the rays for which something is left.
    RayMask meet_leaves(const FlatForm& form, const FlatTerm& term, RayMask mask)
    {
        each_vector(mask, [&](int i) {
            store(in_, i, lanes::before());
            store(out_, i, lanes::beyond());
        });
        for (std::uint32_t k = term.first; k < term.last && mask != 0; ++k) {
            RayMask left = 0;
            lanes::with_test(store_, form.leaves[k].solid, rays_.origin, [&](const auto& test) {
                each_vector(mask, [&](int i) { left |= meet_leaf(test(rays_.directions(i)), k, i); });
            });
            mask &= left;
        }
        return mask;
    }

    RayMask meet_leaf(const lanes::Intervals& own, std::uint32_t k, int i)
    {
        const Bool kept = own.met & (own.entry <= load(rays_.limit, i)) & (own.exit >= load(rays_.t_min, i));
        undecided |= bits(own.unclear, i);
        if (lanes::mask(kept) == 0) return bits(own.unclear, i);
        Double in = load(in_, i), out = load(out_, i);
        Bool coincide = close(own.entry, in) | close(own.exit, out);
        const Bool later = own.entry > in, earlier = own.exit < out;
        in = xsimd::select(later, own.entry, in);
        out = xsimd::select(earlier, own.exit, out);
        coincide = coincide | close(in, out);
        store(in_, i, in);
        store(out_, i, out);
        store(in_end_, i, xsimd::select(later, end_code(k, own.entry_face), load(in_end_, i)));
        store(out_end_, i, xsimd::select(earlier, end_code(k, own.exit_face), load(out_end_, i)));
        undecided |= bits(coincide, i);
        return bits((kept & (in <= out)) | own.unclear, i);
    }

    /// The intervals of the cuts whose box is met. False: too many of them.
    bool meet_cuts(const FlatForm& form, const FlatTerm& term, RayMask mask)
    {
        cuts_ = 0;
        if (term.tree == FlatTerm::kNoTree) {
            if (term.cut_last - term.cut_first > kMostCuts) return false;
            for (std::uint32_t k = term.cut_first; k < term.cut_last; ++k) near_cut(form, k, mask);
            return true;
        }
        const float limit = rounded_up(rays_.farthest(0, rays_.groups));
        for (std::uint32_t first = term.cut_first; first < term.cut_last; first += 8) {
            alignas(32) float near[8];
            std::uint32_t met = beam_.meet(form.cut_boxes[first / 8].bounds, limit, near);
            for (; met != 0; met &= met - 1) {
                const std::uint32_t k = first + static_cast<std::uint32_t>(std::countr_zero(met));
                if (k >= term.cut_last) break;
                if (cuts_ == kMostCuts) return false;
                near_cut(form, k, mask);
            }
        }
        return true;
    }

    void near_cut(const FlatForm& form, std::uint32_t k, RayMask mask)
    {
        const auto& bounds = form.cut_boxes[k / 8].bounds;
        const auto corner = [&](std::size_t row) {
            return glm::dvec3(bounds[row][k % 8], bounds[row + 1][k % 8], bounds[row + 2][k % 8]);
        };
        const RayMask near = rays_.meet(corner(0), corner(3), mask);
        if (near == 0) return;
        const std::uint32_t leaf = form.cuts[k].first;
        if (form.cuts[k].count == 1 && form.leaves[leaf].convex)
            meet_cut(form, leaf, near);
        else if (form.cuts[k].count != 1 || !cut_by_torus(form, leaf, near))
            undecided |= near;  // not for lanes
    }

    /// Its two pieces are two cuts. False: no torus, or not for lanes.
    bool cut_by_torus(const FlatForm& form, std::uint32_t leaf, RayMask mask)
    {
        const PartId part = form.leaves[leaf].solid;
        if (kind_of(part) != SolidKind::Torus || cuts_ + 2 > kMostCuts) return false;
        const Torus& torus = store_.all<Torus>()[index_of(part)];
        if (!detail::factors_serve(torus)) return false;
        const TorusEnds ends(torus, rays_, mask);
        undecided |= ends.unclear;
        for (int which = 0; which < 2; ++which) {
            if (ends.met[which] == 0) continue;
            each_vector(ends.met[which], [&](int i) {
                const lanes::Intervals own = ends.piece(which, i);
                store(cut_in_[cuts_], i, own.entry);
                store(cut_out_[cuts_], i, own.exit);
                store(cut_end_[cuts_], i, end_code(leaf, own.exit_face));
            });
            cut_rays_[cuts_++] = ends.met[which];
        }
        return true;
    }

    void meet_cut(const FlatForm& form, std::uint32_t leaf, RayMask mask)
    {
        RayMask met = 0;
        lanes::with_test(store_, form.leaves[leaf].solid, rays_.origin, [&](const auto& test) {
            each_vector(mask, [&](int i) {
                const lanes::Intervals own = test(rays_.directions(i));
                met |= bits(own.met, i);
                store(cut_in_[cuts_], i, xsimd::select(own.met, own.entry, lanes::beyond()));
                store(cut_out_[cuts_], i, xsimd::select(own.met, own.exit, lanes::before()));
                store(cut_end_[cuts_], i, end_code(leaf, own.exit_face));
            });
        });
        met &= mask;
        if (met == 0) return;
        // Rays of the same vectors that are not in the mask met the solid too or not: either way it is their interval.
        cut_rays_[cuts_++] = mask;
    }

    void leave_cuts(int i)
    {
        constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;
        const Double begin = load(in_, i), out = load(out_, i);
        Double front = begin, code = load(in_end_, i), own(-1.0);
        Bool coincide = !(begin >= load(rays_.t_min, i));  // begins inside: not asked here
        for (bool moved = cuts_ > 0; moved;) {
            Bool moves(false);
            for (std::uint32_t c = 0; c < cuts_; ++c) {
                if (((cut_rays_[c] >> i) & kVector) == 0) continue;
                const Double entry = load(cut_in_[c], i), exit = load(cut_out_[c], i), id(static_cast<double>(c));
                coincide = coincide | ((own != id) & (close(entry, front) | close(exit, front)));
                const Bool covers = (entry < front) & (exit > front);
                front = xsimd::select(covers, exit, front);
                own = xsimd::select(covers, id, own);
                code = xsimd::select(covers, load(cut_end_[c], i), code);
                moves = moves | covers;
            }
            moved = lanes::mask(moves & (front <= out)) != 0;
        }
        coincide = coincide | close(front, out);
        store(t, i, front);
        store(end, i, code);
        undecided |= bits(coincide, i);
        found |= bits((front < out) & (front <= load(rays_.limit, i)) & (front < lanes::beyond()), i);
    }

    const SolidStore& store_;
    const Beam& beam_;
    const TileRays& rays_;
    double reach_;
    alignas(64) Lanes in_, out_, in_end_, out_end_;
    std::uint32_t cuts_ = 0;
    alignas(64) std::array<Lanes, kMostCuts> cut_in_, cut_out_, cut_end_;
    std::array<RayMask, kMostCuts> cut_rays_;
};

}  // namespace csg
