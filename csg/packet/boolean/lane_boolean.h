#pragma once

#include "csg/packet/boolean/lane_piece.h"
#include "csg/packet/boolean/lane_states.h"
#include "csg/packet/lanes/lane_solids.h"
#include "csg/packet/lanes/lane_quartic.h"
#include "csg/packet/lanes/lane_torus.h"
#include "csg/tree/face_held.h"
#include "csg/tree/leaf_spans.h"
#include "csg/tree/program.h"
#include "csg/packet/lanes/tile_rays.h"

/// A CSG object's boolean form against a tile of rays, in vector lanes.
namespace csg {

/// The crossings of a boolean form for each ray, as Evaluation finds them: the pieces of all leaves, and for each end
/// of a piece which of the other leaves hold it. Solids without a test in lanes are asked ray by ray; what is made of
/// their pieces goes in lanes all the same. Rays that meet more ends in one place than one leaf's and, at most, one of
/// a subtree among the conditions are left to it.
template <class Rays>
class LaneBoolean {
public:
    LaneBoolean(const SolidStore& store, const Rays& rays) : store_(store), rays_(rays) {}

    /// The rays are others from now on; places: theirs in the tile, as FetchedSpans knows them.
    void rays_changed(const std::uint8_t* places)
    {
        measured_ = false;
        places_ = places;
    }

    /// The nearest crossing of the rays of the mask, or all of them; each_crossing() has them for the rays found.
    void ask(const Program& program, RayMask mask, bool nearest_only, Scratch& scratch)
    {
        program_ = &program;
        form_ = &program.boolean;
        pieces_ = 0;
        states_.start(program);
        found = undecided = 0;
        if (!measured_) measure();
        mask = meet_node(0, mask, scratch);
        each_vector(mask & ~undecided, [&](int i) {
            if (nearest_only) nearest(i);
            else all(i);
        });
        nearest_only_ = nearest_only;
        undecided &= mask;
        found &= mask & ~undecided;
    }

    /// Calls f(Hit) for the crossings of a ray that was found: one, or all of them in any order.
    template <class F>
    void each_crossing(std::size_t ray, F&& f) const
    {
        if (nearest_only_) {
            f(hit(t_[ray], static_cast<std::uint32_t>(leaf_[ray]), face_[ray]));
            return;
        }
        for (std::uint32_t p = 0; p < pieces_; ++p)
            for (std::size_t side = 0; side < 2; ++side)
                if (((piece_[p].seen[side] >> ray) & 1) != 0)
                    f(hit(piece_[p].t[side][ray], piece_[p].leaf, piece_[p].face[side][ray]));
    }

    RayMask found = 0, undecided = 0;

private:
    using Double = lanes::Double;
    using Bool = lanes::Bool;
    using Lanes = RayLanes;

    static constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;

    using Piece = LanePiece;

    static std::size_t bit(std::uint64_t mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }
    static Double load(const Lanes& from, int i) { return Double::load_aligned(from.data() + i); }
    static void store(Lanes& to, int i, Double v) { v.store_aligned(to.data() + i); }
    static RayMask bits(Bool b, int i) { return static_cast<RayMask>(lanes::mask(b)) << i; }

    Hit hit(double t, std::uint32_t leaf, double face) const
    {
        const BooleanLeaf& of = form_->leaves[leaf];
        const auto side = static_cast<std::uint32_t>(face);
        return {t, store_.surface(of.solid, side), of.solid, side, of.normal_flipped};
    }

    /// As origin_reach().
    void measure()
    {
        measured_ = true;
        for (int i = 0; i < rays_.groups * kRayGroup; i += lanes::kDoubles) {
            const auto from = rays_.origins(i);
            const lanes::Directions to = rays_.directions(i);
            const auto most = [](Double x, Double y, Double z) {
                return xsimd::max(xsimd::abs(x), xsimd::max(xsimd::abs(y), xsimd::abs(z)));
            };
            store(reach_, i, most(Double(from.x), Double(from.y), Double(from.z)) / most(to.x, to.y, to.z));
        }
    }

    Double slack(Double t, int i) const { return Double(kCoincidence) * (xsimd::abs(t) + load(reach_, i)); }

    /// The pieces of a subtree's leaves. Returns the rays of which it may hold something within their ranges. Those
    /// that miss an operand of an intersection see none of its ends, and are not asked the other operands.
    RayMask meet_node(std::uint32_t n, RayMask mask, Scratch& scratch)
    {
        const Node& node = program_->nodes[n];
        if (node.op == Op::Leaf) {
            const RayMask met = meet_leaf(form_->first_leaf[n], mask, scratch);
            return form_->leaves[form_->first_leaf[n]].inverted ? mask : met & mask;
        }
        if (node.test_box && !node.inside_beyond) {
            const RayMask near = near_box(node, mask);
            states_.leave_out(n, mask & ~near);
            mask = near;
        }
        const bool all = node.op == Op::Intersection || node.op == Op::Clip;
        RayMask some = 0;
        for (const bool slow : {false, true})
            for (std::uint32_t k = n + 1; k < node.end && mask != 0; k = program_->nodes[k].end) {
                if (is_slow(k) != slow) continue;
                const RayMask met = meet_node(k, mask, scratch);
                some |= met;
                if (all) mask = met;
            }
        return all ? mask : some;
    }

    RayMask near_box(const Node& of, RayMask mask) const
    {
        return rays_.intersect({of.lower[0], of.lower[1], of.lower[2]}, {of.upper[0], of.upper[1], of.upper[2]}, mask);
    }

    bool is_slow(std::uint32_t n) const
    {
        const PartId solid = program_->nodes[n].solid;
        return solid == kNoPart || (!lanes::has_test(store_, solid) && kind_of(solid) != SolidKind::Quadric);
    }

    /// Adds a leaf's pieces. Returns the rays that it holds something of within their ranges, perhaps more, and perhaps
    /// others of their vectors.
    RayMask meet_leaf(std::uint32_t k, RayMask mask, Scratch& scratch)
    {
        const BooleanLeaf& leaf = form_->leaves[k];
        const Node& node = program_->nodes[leaf.node];
        if (node.test_box && node.inside_beyond == leaf.inverted) mask = near_box(node, mask);
        if (mask == 0) return 0;
        if (kind_of(leaf.solid) == SolidKind::Quadric)
            return meet_quadric(k, store_.all<Quadric>()[index_of(leaf.solid)], mask);
        if (!is_slow(leaf.node)) return meet_in_lanes(k, mask);
        if (kind_of(leaf.solid) == SolidKind::Torus) {
            const Torus& torus = store_.all<Torus>()[index_of(leaf.solid)];
            if (detail::factors_serve(torus)) return meet_ends(k, TorusEnds(torus, rays_, mask));
        }
        if (kind_of(leaf.solid) == SolidKind::Polynomial) {
            const Polynomial& polynomial = store_.all<Polynomial>()[index_of(leaf.solid)];
            if (QuarticEnds::serve(polynomial)) return meet_ends(k, QuarticEnds(polynomial, rays_, mask));
        }
        return meet_ray_by_ray(k, mask, scratch);
    }

    Piece& next_piece(std::uint32_t leaf)
    {
        Piece& made = piece_[pieces_++];
        made.leaf = leaf;
        made.rays = made.seen[0] = made.seen[1] = 0;
        return made;
    }

    /// Fills a vector of a piece in; which of its rays hold something of it within their ranges.
    RayMask put(Piece& piece, const lanes::Intervals& own, int i)
    {
        piece.rays |= kVector << i;
        store(piece.t[0], i, xsimd::select(own.met, own.entry, lanes::beyond()));
        store(piece.t[1], i, xsimd::select(own.met, own.exit, lanes::before()));
        store(piece.face[0], i, own.entry_face);
        store(piece.face[1], i, own.exit_face);
        const Double t_min = load(rays_.t_min, i), limit = load(rays_.limit, i);
        const Double room = xsimd::select(limit < lanes::beyond(), slack(limit, i), Double(0.0));
        return bits(own.met & (own.exit >= t_min - slack(t_min, i)) & (own.entry <= limit + room), i);
    }

    RayMask meet_in_lanes(std::uint32_t k, RayMask mask)
    {
        RayMask held = 0;
        Piece& piece = next_piece(k);
        lanes::with_test(store_, form_->leaves[k].solid, rays_, [&](const auto& at) {
            each_vector(mask, [&](int i) {
                const lanes::Intervals own = at(i);
                if (lanes::mask(own.met) != 0) held |= put(piece, own, i);
            });
        });
        if (piece.rays == 0) --pieces_;
        return held;
    }

    RayMask meet_quadric(std::uint32_t k, const Quadric& quadric, RayMask mask)
    {
        RayMask held = 0;
        Piece &first = next_piece(k), &second = next_piece(k);
        lanes::with_spans(quadric, rays_, [&](const auto& both) {
            each_vector(mask, [&](int i) {
                lanes::Intervals beyond;
                const lanes::Intervals own = both(i, beyond);
                const RayMask unclear = bits(own.unclear, i);
                undecided |= unclear;
                held |= unclear;
                if (lanes::mask(own.met) != 0) held |= put(first, own, i);
                if (lanes::mask(beyond.met) != 0) held |= put(second, beyond, i);
            });
        });
        if (second.rays == 0) --pieces_;  // it has none without the first
        if (first.rays == 0) --pieces_;
        return held;
    }

    /// Of a solid that has several pieces a ray.
    template <class Ends>
    RayMask meet_ends(std::uint32_t k, const Ends& ends)
    {
        undecided |= ends.unclear;
        RayMask held = ends.unclear;
        for (int which = 0; which < Ends::kPieces; ++which) {
            if (ends.met[which] == 0) continue;
            Piece& piece = next_piece(k);
            each_vector(ends.met[which], [&](int i) { held |= put(piece, ends.piece(which, i), i); });
        }
        return held;
    }

    RayMask meet_ray_by_ray(std::uint32_t k, RayMask mask, Scratch& scratch)
    {
        const BooleanLeaf& leaf = form_->leaves[k];
        const std::uint32_t most = leaf.most_pieces;
        Piece* const own = &piece_[pieces_];
        for (std::uint32_t p = 0; p < most; ++p) next_piece(k);
        std::uint32_t used = 0;
        RayMask held = 0;
        each_ray(mask, [&](std::size_t ray) {
            if (rays_.limit[ray] < 0.0) return;
            scratch.fetched.select(places_ != nullptr ? places_[ray] : static_cast<int>(ray));
            const Ray of = rays_.ray(static_cast<int>(ray));
            std::uint32_t count = 0;
            with_solid(store_, leaf.solid, [&](const auto& solid) {
                each_span_of(solid, of, false, rays_.t_min[ray], rays_.limit[ray], origin_reach(of),
                             {store_, program_->nodes.data(), leaf.node, scratch.fetched},
                             scratch.leaf_spans(program_->nodes[leaf.node].max_spans),
                             [&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                                 if (count < most) own[count].put(ray, in, in_face, out, out_face);
                                 ++count;
                             });
            });
            if (count == 0) return;
            held |= RayMask{1} << ray;
            if (count > most) undecided |= RayMask{1} << ray;
            used = std::max(used, std::min(count, most));
        });
        pieces_ -= most - used;
        return held;
    }

    void nearest(int i)
    {
        Double t = load(rays_.limit, i), leaf(0.0), face(0.0), rank(-1.0), tied = lanes::beyond();
        Bool some(false);
        each_end(i, [&](std::uint32_t p, std::size_t side, Double at, Bool in_range) {
            const Double own(static_cast<double>(form_->leaves[piece_[p].leaf].rank));
            // Ends of lower rank in the same place are looked at too: whether they are decided counts.
            const Bool reached = in_range & (at <= t);
            if (lanes::mask(reached) == 0) return;
            look(i, piece_[p], side, at);
            tied = xsimd::select(reached & shared_, xsimd::min(tied, at), tied);
            const Bool nearer = reached & ((at < t) | (own >= rank));
            const Bool seen = nearer & drawn(i, p, side) & states_.seen(form_->leaves[piece_[p].leaf], nearer);
            t = xsimd::select(seen, at, t);
            rank = xsimd::select(seen, own, rank);
            leaf = xsimd::select(seen, Double(static_cast<double>(piece_[p].leaf)), leaf);
            face = xsimd::select(seen, load(piece_[p].face[side], i), face);
            some = some | seen;
        });
        store(t_, i, t);
        store(leaf_, i, leaf);
        store(face_, i, face);
        found |= bits(some, i);
        undecided |= bits((tied < lanes::beyond()) & (tied <= t), i);
    }

    void all(int i)
    {
        each_end(i, [&](std::uint32_t p, std::size_t side, Double at, Bool in_range) {
            if (lanes::mask(in_range) == 0) return;
            look(i, piece_[p], side, at);
            undecided |= bits(in_range & shared_, i);
            const Bool seen = in_range & drawn(i, p, side) & states_.seen(form_->leaves[piece_[p].leaf], in_range);
            piece_[p].seen[side] |= bits(seen, i);
            found |= bits(seen, i);
        });
    }

    /// f(piece, side, t, whether it lies in the rays' ranges) for the ends of all pieces of a vector.
    template <class F>
    void each_end(int i, F&& f)
    {
        const Double t_min = load(rays_.t_min, i), limit = load(rays_.limit, i);
        here_ = 0;
        for (std::uint32_t p = 0; p < pieces_; ++p)
            if (((piece_[p].rays >> i) & kVector) != 0) here_ |= std::uint64_t{1} << p;
        for (std::uint64_t left = here_; left != 0; left &= left - 1) {
            const auto p = static_cast<std::uint32_t>(bit(left));
            if (!form_->leaves[piece_[p].leaf].drawn) continue;
            for (std::size_t side = 0; side < 2; ++side) {
                const Double t = load(piece_[p].t[side], i);
                f(p, side, t,
                  (t >= t_min) & (t <= limit) & (t > lanes::before()) & (t < lanes::beyond()) &
                      (load(piece_[p].t[0], i) <= load(piece_[p].t[1], i)));
            }
        }
    }

    Bool drawn(int i, std::uint32_t p, std::size_t side) const
    {
        return load(piece_[p].face[side], i) != Double(static_cast<double>(kUndrawnFace));
    }

    /// Which of the leaves that matter hold the points at t, as Evaluation has it, and where more ends are in one place
    /// than is decided here.
    void look(int i, const Piece& end_of, std::size_t side, Double t)
    {
        const BooleanLeaf& own = form_->leaves[end_of.leaf];
        const Double face = load(end_of.face[side], i), room = slack(t, i);
        const std::uint64_t matters = own.matters();
        states_.begin(matters, i);
        shared_ = Bool(false);
        Bool below(false), of_leaf(false);  // an end of those, and of the leaf at hand, is in the same place
        std::uint32_t of = kNoPart;
        for (std::uint64_t left = here_; left != 0; left &= left - 1) {
            const Piece& piece = piece_[bit(left)];
            if ((matters >> piece.leaf & 1) == 0) continue;
            const BooleanLeaf& leaf = form_->leaves[piece.leaf];
            const Double in = load(piece.t[0], i), out = load(piece.t[1], i);
            const Bool at_in = (t >= in - room) & (t <= in + room), at_out = (t >= out - room) & (t <= out + room);
            // A leaf's pieces lie apart, or one within the other. (The exclusive or of xsimd 8's masks is a plain or on
            // AVX-512.)
            Bool inside = (in < t) & (t <= out);
            Bool& holds = states_[piece.leaf];
            if (const Bool near = at_in | at_out; lanes::mask(near) != 0) {
                if (piece.leaf != of) of_leaf = Bool(false);
                of = piece.leaf;
                shared_ = shared_ | (at_in & at_out) | (near & of_leaf);
                of_leaf = of_leaf | near;
                if ((own.below >> piece.leaf & 1) != 0) {
                    shared_ = shared_ | (near & below);
                    below = below | near;
                }
                inside = leaf.closed != leaf.inverted ? inside | near : inside & !near;
                const Bool alike = (t == (side == 0 ? in : out)) & (load(piece.face[side], i) == face);
                if (kind_of(leaf.solid) == kind_of(own.solid) && lanes::mask(alike) != 0)
                    inside = (inside & !alike) | (holds_face_of(i, piece, side, lanes::mask(alike)) & alike);
            }
            holds = leaf.inverted ? holds & !inside : holds | inside;
        }
    }

    /// Of the lanes asked for: whether the leaf, as it is without inversion, holds the end of a piece of it for a face
    /// that is alike.
    Bool holds_face_of(int i, const Piece& piece, std::size_t side, std::uint32_t asked) const
    {
        const BooleanLeaf& leaf = form_->leaves[piece.leaf];
        std::uint32_t held = 0;
        for (; asked != 0; asked &= asked - 1) {
            const int lane = std::countr_zero(asked);
            const auto k = static_cast<std::size_t>(i + lane);
            if (holds_face(store_, leaf.solid, rays_.ray(i + lane), piece.t[side][k],
                           static_cast<std::uint32_t>(piece.face[side][k]), leaf.closed != leaf.inverted))
                held |= 1u << lane;
        }
        return lanes::lanes_of(held);
    }

    const SolidStore& store_;
    const Rays& rays_;
    const Program* program_ = nullptr;
    const BooleanForm* form_ = nullptr;
    const std::uint8_t* places_ = nullptr;  ///< of the rays in the tile, or null: as they come
    bool measured_ = false;
    bool nearest_only_ = true;
    std::uint32_t pieces_ = 0;
    std::uint64_t here_ = 0;  ///< pieces of the vector at hand
    Bool shared_ = Bool(false);
    alignas(64) Lanes t_, leaf_, face_;  ///< the nearest, where found
    alignas(64) Lanes reach_;            ///< where measured
    LaneStates states_;                  ///< of the leaves, at the end at hand
    Piece piece_[BooleanForm::kMostPieces];
};

}  // namespace csg
