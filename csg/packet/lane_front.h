#pragma once

#include "csg/packet/beam.h"
#include "csg/packet/cut_runs.h"
#include "csg/packet/lanes/lane_solids.h"
#include "csg/packet/lanes/lane_torus.h"
#include "csg/packet/packet_slabs.h"
#include "csg/tree/program.h"
#include "csg/packet/lanes/tile_rays.h"

/// A CSG object's sum of products against a tile of rays, in vector lanes.
namespace csg {

/// An end as a number: kFaces * leaf of the form + face.
struct LeafEnd {
    static constexpr std::uint32_t kFaces = 8;  ///< more than any convex solid has
    std::uint32_t leaf, face;

    explicit LeafEnd(double code)
        : leaf(static_cast<std::uint32_t>(code) / kFaces), face(static_cast<std::uint32_t>(code) % kFaces)
    {}
    static lanes::Double code(std::uint32_t leaf, lanes::Double face)
    {
        return lanes::Double(static_cast<double>(kFaces * leaf)) + face;
    }
};

/// The crossings of a sum of products for each ray: latest entry and earliest exit of the leaves, then the front moves
/// through the cuts. Where ProductFront would be undecided the ray is left to it; all other numbers are the solids'
/// own, so the answers are the same.
template <class Rays>
class LaneFront {
public:
    LaneFront(const SolidStore& store, const Beam& beam, const Rays& rays) : store_(store), beam_(&beam), rays_(rays) {}
    /// Of rays that form no beam.
    LaneFront(const SolidStore& store, const PacketSlabs<Rays>& slabs, const Rays& rays)
        : store_(store), slabs_(&slabs), rays_(rays)
    {}

    /// The nearest crossing, for the rays of the mask; the form is simple(). The answers are in `t` and `end` until the
    /// next question.
    void ask(const SumOfProducts& form, RayMask mask)
    {
        mask = intersect(form, mask);
        each_vector(mask, [&](int i) { nearest(i); });
        undecided &= mask;
        found &= mask & ~undecided;
    }

    /// Both ends of a form whose one term is plain(), for the rays found: entry, exit and their codes.
    void ask_ends(const SumOfProducts& form, RayMask mask)
    {
        undecided = 0;
        find_reach();
        const RayMask met = meet_leaves(form, form.terms[0], mask);
        undecided &= mask;
        found = met & ~undecided;
    }
    double entry(std::size_t ray) const { return in_[ray]; }
    double exit(std::size_t ray) const { return out_[ray]; }
    LeafEnd entry_end(std::size_t ray) const { return LeafEnd(in_end_[ray]); }
    LeafEnd exit_end(std::size_t ray) const { return LeafEnd(out_end_[ray]); }

    /// All crossings of a form that is simple(): each_crossing() has them for the rays found.
    void ask_all(const SumOfProducts& form, RayMask mask)
    {
        mask = intersect(form, mask);
        undecided &= mask;
        found = mask & ~undecided;
    }

    /// Calls emit(t, LeafEnd) for the crossings of a ray; false, and nothing is emitted, where ends coincide.
    template <class Emit>
    bool each_crossing(std::size_t ray, Emit&& emit) const
    {
        std::array<Piece, kMostCuts> cuts;
        std::uint32_t count = 0;
        if (!gather(ray, cuts, count)) return false;
        struct End {
            double t, code;
        };
        std::array<End, 2 * kMostCuts> ends;
        std::uint32_t ended = 0;
        const double in = in_[ray], out = out_[ray];
        bool enters = in > -kInfinity, leaves = out < kInfinity;
        for (std::uint32_t first = 0; first < count;) {
            std::uint32_t last = first + 1, longest = first;
            if (!run_of_cuts(cuts.data(), count, last, longest, [&](double a, double b) { return close(a, b); }))
                return false;
            const Piece &opens = cuts[first], &closes = cuts[longest];
            enters = enters && !(opens.in < in && closes.out > in);
            leaves = leaves && !(opens.in < out && closes.out > out);
            if (opens.in > in && opens.in < out) ends[ended++] = {opens.in, opens.in_code};
            if (closes.out > in && closes.out < out) ends[ended++] = {closes.out, closes.out_code};
            first = last;
        }
        if (enters) emit(in, LeafEnd(in_end_[ray]));
        for (std::uint32_t i = 0; i < ended; ++i) emit(ends[i].t, LeafEnd(ends[i].code));
        if (leaves) emit(out, LeafEnd(out_end_[ray]));
        return true;
    }

    RayMask found = 0, undecided = 0;
    alignas(64) RayLanes t;    ///< where found
    alignas(64) RayLanes end;  ///< which end of which leaf: decode by LeafEnd

private:
    using Double = lanes::Double;
    using Bool = lanes::Bool;
    using Lanes = RayLanes;

    static constexpr std::uint32_t kMostCuts = 48;  ///< that one tile meets
    static constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;

    using Piece = CutPiece;

    static Double load(const Lanes& from, int i) { return Double::load_aligned(from.data() + i); }
    static void store(Lanes& to, int i, Double v) { v.store_aligned(to.data() + i); }
    static RayMask bits(Bool b, int i) { return static_cast<RayMask>(lanes::mask(b)) << i; }

    Bool close(Double a, Double b) const
    {
        const Double gap = xsimd::abs(a - b);
        return (gap <= Double(kCoincidence) * (xsimd::abs(a) + Double(reach_))) & (gap < lanes::beyond());
    }

    /// Whether what coincides with a place can lie before the limit: beyond it nothing matters.
    Bool reaches(Double limit, Double at) const
    {
        return at - Double(2.0 * kCoincidence) * (xsimd::abs(at) + Double(reach_)) <= limit;
    }

    bool close(double a, double b) const
    {
        const double gap = std::abs(a - b);
        return gap <= kCoincidence * (std::abs(a) + reach_) && gap < kInfinity;
    }

    /// For the first question: most tiles have none.
    void find_reach()
    {
        if (reach_ >= 0.0) return;
        const glm::dvec3 o = rays_.widest();
        reach_ = 1.75 * glm::max(o.x, glm::max(o.y, o.z));  // no less than ProductFront's for directions of unit length
    }

    /// Leaves and cuts. Returns the rays that are left; none of them when there are too many cuts.
    RayMask intersect(const SumOfProducts& form, RayMask mask)
    {
        found = undecided = 0;
        find_reach();
        const ProductTerm& term = form.terms[0];
        mask = meet_leaves(form, term, mask);
        if (mask == 0 || meet_cuts(form, term, mask)) return mask;
        undecided = mask;
        cuts_ = 0;
        return mask;
    }

    /// The cuts of a ray inside the leaves, by entry. False where one coincides with an end of the leaves.
    bool gather(std::size_t ray, std::array<Piece, kMostCuts>& cuts, std::uint32_t& count) const
    {
        const double in = in_[ray], out = out_[ray];
        for (std::uint32_t c = 0; c < cuts_; ++c) {
            if (((cut_rays_[c] >> ray) & 1) == 0) continue;
            const Piece piece{cut_in_[c][ray], cut_out_[c][ray], cut_begin_[c][ray], cut_end_[c][ray]};
            if (!(piece.in <= piece.out)) continue;  // missed
            if (close(piece.in, in) || close(piece.out, in) || close(piece.in, out) || close(piece.out, out))
                return false;
            if (piece.out < in || piece.in > out) continue;
            std::uint32_t at = count++;
            for (; at > 0 && cuts[at - 1].in > piece.in; --at) cuts[at] = cuts[at - 1];
            cuts[at] = piece;
        }
        return true;
    }

    /// in_ to out_: what all leaves hold. Returns the rays for which something is left.
    RayMask meet_leaves(const SumOfProducts& form, const ProductTerm& term, RayMask mask)
    {
        each_vector(mask, [&](int i) {
            store(in_, i, lanes::before());
            store(out_, i, lanes::beyond());
        });
        for (std::uint32_t k = term.first; k < term.last && mask != 0; ++k) {
            RayMask left = 0;
            lanes::with_test(store_, form.leaves[k].solid, rays_, [&](const auto& at) {
                each_vector(mask, [&](int i) { left |= meet_leaf(at(i), k, i); });
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
        store(in_end_, i, xsimd::select(later, LeafEnd::code(k, own.entry_face), load(in_end_, i)));
        store(out_end_, i, xsimd::select(earlier, LeafEnd::code(k, own.exit_face), load(out_end_, i)));
        undecided |= bits(coincide, i);
        return bits((kept & (in <= out)) | own.unclear, i);
    }

    /// The intervals of the cuts whose box is met. False: too many of them.
    bool meet_cuts(const SumOfProducts& form, const ProductTerm& term, RayMask mask)
    {
        cuts_ = 0;
        constexpr std::uint32_t kFew = 2;
        const std::uint32_t count = term.cut_last - term.cut_first;
        if (count <= kFew || !term.bounded_cuts || term.wide_cuts) {
            for (std::uint32_t k = term.cut_first; k < term.cut_last; ++k) {
                if (cuts_ == kMostCuts) return false;
                if (term.wide_cuts) meet_cut_of(form, k, mask);
                else near_cut(form, k, mask);
            }
            return true;
        }
        if (slabs_ != nullptr) return sieve_cuts(form, term, mask);
        const float limit = rounded_up(rays_.farthest(0, rays_.groups));
        for (std::uint32_t first = term.cut_first; first < term.cut_last; first += 8) {
            alignas(32) float near[8];
            std::uint32_t met = beam_->intersect(form.cut_boxes[first / 8].bounds, limit, near);
            for (; met != 0; met &= met - 1) {
                const std::uint32_t k = first + static_cast<std::uint32_t>(std::countr_zero(met));
                if (k >= term.cut_last) break;
                if (cuts_ == kMostCuts) return false;
                near_cut(form, k, mask);
            }
        }
        return true;
    }

    /// The same where the rays form no beam. False also where a hierarchy serves a ray by itself.
    bool sieve_cuts(const SumOfProducts& form, const ProductTerm& term, RayMask mask)
    {
        if (term.tree != ProductTerm::kNoTree) return false;
        for (std::uint32_t first = term.cut_first; first < term.cut_last; first += 8) {
            alignas(32) float near[8];
            std::array<RayMask, 8> rays;
            std::uint32_t met = slabs_->intersect(form.cut_boxes[first / 8].bounds, mask, rays, near);
            for (; met != 0; met &= met - 1) {
                const auto place = static_cast<std::uint32_t>(std::countr_zero(met));
                if (first + place >= term.cut_last) break;
                if (cuts_ == kMostCuts) return false;
                meet_cut_of(form, first + place, rays[place]);
            }
        }
        return true;
    }

    void near_cut(const SumOfProducts& form, std::uint32_t k, RayMask mask)
    {
        const auto& bounds = form.cut_boxes[k / 8].bounds;
        const auto corner = [&](std::size_t row) {
            return glm::dvec3(bounds[row][k % 8], bounds[row + 1][k % 8], bounds[row + 2][k % 8]);
        };
        const RayMask near = rays_.intersect(corner(0), corner(3), mask);
        if (near != 0) meet_cut_of(form, k, near);
    }

    void meet_cut_of(const SumOfProducts& form, std::uint32_t k, RayMask near)
    {
        const std::uint32_t leaf = form.cuts[k].first;
        if (form.cuts[k].count == 1 && form.leaves[leaf].convex) meet_cut(form, leaf, near);
        else if (form.cuts[k].count != 1 || !cut_by_torus(form, leaf, near)) undecided |= near;  // not for lanes
    }

    /// Its two pieces are two cuts. False: no torus, or not for lanes.
    bool cut_by_torus(const SumOfProducts& form, std::uint32_t leaf, RayMask mask)
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
                store(cut_begin_[cuts_], i, LeafEnd::code(leaf, own.entry_face));
                store(cut_end_[cuts_], i, LeafEnd::code(leaf, own.exit_face));
            });
            cut_rays_[cuts_++] = ends.met[which];
        }
        return true;
    }

    void meet_cut(const SumOfProducts& form, std::uint32_t leaf, RayMask mask)
    {
        RayMask vectors = 0;
        lanes::with_test(store_, form.leaves[leaf].solid, rays_, [&](const auto& at) {
            each_vector(mask, [&](int i) {
                const lanes::Intervals own = at(i);
                if (lanes::mask(own.met) == 0) return;
                vectors |= kVector << i;
                store(cut_in_[cuts_], i, xsimd::select(own.met, own.entry, lanes::beyond()));
                store(cut_out_[cuts_], i, xsimd::select(own.met, own.exit, lanes::before()));
                store(cut_begin_[cuts_], i, LeafEnd::code(leaf, own.entry_face));
                store(cut_end_[cuts_], i, LeafEnd::code(leaf, own.exit_face));
            });
        });
        // Rays of these vectors that are not in the mask met the solid too or not: either way it is their interval.
        if ((vectors & mask) != 0) cut_rays_[cuts_++] = vectors & mask;
    }

    /// Calls f(cut, entry, exit) for the cuts that rays of the vector from i on come near.
    template <class F>
    void each_cut(int i, F&& f) const
    {
        for (std::uint32_t c = 0; c < cuts_; ++c)
            if (((cut_rays_[c] >> i) & kVector) != 0) f(c, load(cut_in_[c], i), load(cut_out_[c], i));
    }

    void nearest(int i)
    {
        const Double t_min = load(rays_.t_min, i), out = load(out_, i), begin = load(in_, i);
        const Bool inside = !(begin >= t_min);
        Double front = begin, code = load(in_end_, i), own(-1.0);
        Bool coincide(false), ends(false);
        if (lanes::mask(inside) != 0) {
            // From a cut that covers the beginning to its end; else to the first cut or the end of the leaves.
            each_cut(i, [&](std::uint32_t c, Double entry, Double exit) {
                const Bool covers = inside & (own < Double(0.0)) & (entry < t_min) & (exit >= t_min);
                front = xsimd::select(covers, exit, front);
                code = xsimd::select(covers, load(cut_end_[c], i), code);
                own = xsimd::select(covers, Double(static_cast<double>(c)), own);
            });
            ends = inside & (own < Double(0.0));
            if (lanes::mask(ends) != 0) find_end(i, ends, t_min, front, code, coincide);
        }
        if (cuts_ > 0 && lanes::mask(!ends) != 0) leave_cuts(i, ends, front, code, own, coincide);
        coincide = coincide | ((!ends) & reaches(load(rays_.limit, i), front) & close(front, out));
        store(t, i, front);
        store(end, i, code);
        undecided |= bits(coincide, i);
        found |= bits((ends | (front < out)) & (front <= load(rays_.limit, i)) & (front < lanes::beyond()), i);
    }

    /// Where the solid ends that these rays begin in.
    void find_end(int i, Bool which, Double t_min, Double& front, Double& code, Bool& coincide) const
    {
        front = xsimd::select(which, load(out_, i), front);
        code = xsimd::select(which, load(out_end_, i), code);
        each_cut(i, [&](std::uint32_t c, Double entry, Double exit) {
            const Bool begins = which & (entry >= t_min) & (entry <= exit), nearer = begins & (entry < front);
            coincide = coincide | (begins & close(entry, front));
            front = xsimd::select(nearer, entry, front);
            code = xsimd::select(nearer, load(cut_begin_[c], i), code);
        });
    }

    /// Moves the fronts out of all cuts that cover them, but for those of rays at their end.
    void leave_cuts(int i, Bool ends, Double& front, Double& code, Double& own, Bool& coincide) const
    {
        const Double limit = load(rays_.limit, i), last = xsimd::min(load(out_, i), limit);
        for (bool moved = true; moved;) {
            Bool moves(false);
            each_cut(i, [&](std::uint32_t c, Double entry, Double exit) {
                const Double id(static_cast<double>(c));
                const Bool counts = (!ends) & (own != id) & reaches(limit, front);
                coincide = coincide | (counts & (close(entry, front) | close(exit, front)));
                const Bool covers = (!ends) & (entry < front) & (exit > front);
                front = xsimd::select(covers, exit, front);
                own = xsimd::select(covers, id, own);
                code = xsimd::select(covers, load(cut_end_[c], i), code);
                moves = moves | covers;
            });
            moved = lanes::mask(moves & (front <= last)) != 0;
        }
    }

    const SolidStore& store_;
    const Beam* beam_ = nullptr;
    const PacketSlabs<Rays>* slabs_ = nullptr;
    const Rays& rays_;
    double reach_ = -1.0;
    alignas(64) Lanes in_, out_, in_end_, out_end_;
    std::uint32_t cuts_ = 0;
    alignas(64) std::array<Lanes, kMostCuts> cut_in_, cut_out_, cut_begin_, cut_end_;
    std::array<RayMask, kMostCuts> cut_rays_;
};

}  // namespace csg
