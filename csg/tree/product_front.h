#pragma once

// The crossings of a sum of products; inline, since each kernel has its own.
#include "csg/tree/product_intersector.h"

namespace csg {

/// One ray against a sum of products: see docs/flat_csg.md.
class ProductFront : private ProductIntersector {
public:
    using Answer = ProductAnswer;
    using ProductIntersector::ProductIntersector;

    Answer nearest(Crossing& out)
    {
        ProductEnd best{};
        Answer answer = Answer::Nothing;
        if (form_.terms.size() == 1) {
            answer = nearest_of(form_.terms[0], best);
        } else {
            each_term([&](const ProductTerm& term) {
                ProductEnd found;
                const Answer one = nearest_of(term, found);
                if (one == Answer::Nothing) return true;
                if (one == Answer::Undecided || (answer == Answer::Found && close(found.t, best.t))) {
                    answer = Answer::Undecided;
                    return false;
                }
                answer = Answer::Found;
                best = found;
                t_max_ = found.t + slack(found.t);  // one that coincides must be noticed
                return true;
            });
        }
        if (answer == Answer::Found) out = crossing(best);
        return answer;
    }

    /// All visible crossings in range, in any order: emit(Crossing). Terms share solids, so one may come twice; some
    /// may have been emitted already when the answer is Undecided.
    template <class Emit>
    Answer crossings(Emit&& emit)
    {
        Answer answer = Answer::Nothing;
        each_term([&](const ProductTerm& term) {
            if (crossings_of(term, emit) == Answer::Undecided) answer = Answer::Undecided;
            return answer != Answer::Undecided;
        });
        return answer;
    }

private:
    static constexpr std::uint32_t kNoCut = 0xffffffffu;

    bool begins_in_range(const ProductPiece& piece) const { return piece.in.t >= t_min_ && piece.in.t > -kInfinity; }

    Answer nearest_of(const ProductTerm& term, ProductEnd& found)
    {
        if (term.plain()) {
            ProductPiece piece;
            const Answer met = meet_leaves(term, piece);
            if (met != Answer::Found) return met;
            found = begins_in_range(piece) ? piece.in : piece.out;
            return within(found.t) ? Answer::Found : Answer::Nothing;
        }
        return each_piece(term, [&](const ProductPiece& piece) {
            bool enters = false;
            std::uint32_t cut = kNoCut;
            const Answer answer = first_crossing(piece, found, enters, cut);
            return answer == Answer::Found && !within(found.t) ? Answer::Nothing : answer;
        });
    }

    template <class Emit>
    Answer crossings_of(const ProductTerm& term, Emit&& emit)
    {
        if (term.plain()) {
            ProductPiece piece;
            const Answer met = meet_leaves(term, piece);
            if (met != Answer::Found) return met;
            if (begins_in_range(piece) && within(piece.in.t)) emit(crossing(piece.in));
            if (piece.out.t >= t_min_ && within(piece.out.t)) emit(crossing(piece.out));
            return Answer::Nothing;
        }
        return each_piece(term, [&](const ProductPiece& piece) {
            ProductEnd at;
            bool enters = false;
            std::uint32_t cut = kNoCut;
            Answer answer = evaluate_cuts(kInfinity);
            if (answer == Answer::Found) answer = first_crossing(piece, at, enters, cut);
            while (answer == Answer::Found && within(at.t)) {
                emit(crossing(at));
                if (enters) {
                    answer = find_end(at.t, piece.out, at, cut);
                    enters = false;
                } else {
                    if (cut == kNoCut) break;  // the piece's own end
                    at = cuts_[cut].out;
                    answer = enter(at, cut, piece.out);
                    enters = true;
                }
            }
            return answer == Answer::Undecided ? answer : Answer::Nothing;
        });
    }

    /// Calls f(piece) for the pieces of the line in all leaves that meet the range, nearest first, until f answers
    /// something else than Nothing.
    template <class F>
    Answer each_piece(const ProductTerm& term, F&& f)
    {
        if (term.convex) {
            ProductPiece piece;
            const Answer met = meet_leaves(term, piece);
            if (met != Answer::Found) return met;
            find_cuts(term, piece.in.t, piece.out.t);
            return f(piece);
        }
        ProductPiece pieces[kProductSpans];
        std::uint32_t count = 0;
        const Answer met = meet_pieces(term, pieces, count);
        if (met != Answer::Found) return met;
        find_cuts(term, pieces[0].in.t, pieces[count - 1].out.t);
        for (std::uint32_t i = 0; i < count; ++i) {
            const Answer answer = f(pieces[i]);
            if (answer != Answer::Nothing) return answer;
        }
        return Answer::Nothing;
    }

    /// Moves the front out of every cut that covers it. `own` is the cut that it came from.
    Answer leave_cuts(ProductEnd& front, std::uint32_t& own) const
    {
        double near = 2.0 * slack(front.t);  // farther off nothing coincides
        for (std::uint32_t i = 0; i < count_; ++i) {
            if (i == own) continue;
            const double entry = cuts_[i].in.t, exit = cuts_[i].out.t;
            if (exit < front.t - near || entry > front.t + near) continue;
            if (close(entry, front.t) || close(exit, front.t)) return Answer::Undecided;
            if (entry < front.t && exit > front.t) {
                front = cuts_[i].out;
                near = 2.0 * slack(front.t);
                own = i;
                if (passed(front.t)) break;
                i = static_cast<std::uint32_t>(-1);  // the rest are looked at again after a move
            }
        }
        return Answer::Found;
    }

    /// From an end that is covered, perhaps, to the one where the solid begins.
    Answer enter(ProductEnd& front, std::uint32_t own, const ProductEnd& out)
    {
        for (double before = -kInfinity;
             front.t > before;) {  // what begins farther off is evaluated when the front gets there
            before = front.t;
            if (passed(front.t)) return Answer::Nothing;
            if (evaluate_cuts(front.t + slack(front.t)) == Answer::Undecided) return Answer::Undecided;
            if (leave_cuts(front, own) == Answer::Undecided) return Answer::Undecided;
            if (passed(front.t)) return Answer::Nothing;
            if (close(front.t, out.t)) return Answer::Undecided;
            if (front.t > out.t || !within(front.t)) return Answer::Nothing;
        }
        return Answer::Found;
    }

    /// Where the solid that the ray is in ends: the first cut that begins at `from` or after, or the piece's end.
    Answer find_end(double from, const ProductEnd& out, ProductEnd& found, std::uint32_t& cut)
    {
        for (;;) {
            found = out;
            cut = kNoCut;
            for (std::uint32_t i = 0; i < count_; ++i) {
                if (cuts_[i].in.t < from) continue;
                if (close(cuts_[i].in.t, found.t)) return Answer::Undecided;
                if (cuts_[i].in.t < found.t) found = cuts_[i].in, cut = i;
            }
            // Whatever else may begin before that, nearest first.
            if (waiting_ == 0) return Answer::Found;
            const double next = nearest_waiting();
            if (!(next <= found.t + slack(found.t))) return Answer::Found;
            if (evaluate_cuts(next) == Answer::Undecided) return Answer::Undecided;
        }
    }

    /// The first crossing of the piece at or after t_min. `enters`: the ray is in the solid behind it.
    Answer first_crossing(const ProductPiece& piece, ProductEnd& found, bool& enters, std::uint32_t& cut)
    {
        cut = kNoCut;
        if (begins_in_range(piece)) {
            found = piece.in;
        } else {
            if (evaluate_cuts(t_min_) == Answer::Undecided) return Answer::Undecided;
            for (std::uint32_t i = 0; i < count_ && cut == kNoCut; ++i)
                if (cuts_[i].in.t < t_min_ && cuts_[i].out.t >= t_min_) cut = i;
            if (cut == kNoCut) {
                enters = false;
                return find_end(t_min_, piece.out, found, cut);
            }
            found = cuts_[cut].out;
        }
        enters = true;
        return enter(found, cut, piece.out);
    }
};

}  // namespace csg
