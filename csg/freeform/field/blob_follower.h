#pragma once

#include "csg/freeform/field/blob_walk.h"

namespace csg {

/// Tells the crossings of a ray from its stretches. Where a sum of fields passes the threshold once, the place is left
/// to whoever asks: rays in lanes look for theirs together.
class Blob::Follower {
public:
    Follower() = default;
    /// \param start  what the ray's parameter is less by than what is told
    Follower(double threshold, const Walk& walk, double start, IntersectionList& out)
        : walk_(walk), out_(&out), threshold_(threshold), start_(start), from_(out.from - start), to_(out.to - start)
    {
        // Most rays that meet fields stay below the threshold, and those that leave a surface have its better part
        // behind.
        if (threshold_ >= 0.0 && walk_.most_of_all() < threshold_) return;
        walk_.set_ends(from_);
        stride_ = walk_.end_count / 2;
        inside_ = below();
        more_ = !inside_ || out_->enter(-kInfinity, kUndrawnFace);
    }

    /// Goes on to where a place has to be found; false: all is told.
    bool next()
    {
        while (more_ && at_ < walk_.end_count) {
            walk_.pass(walk_.ends[at_]);
            double a = walk_.ends[at_++].t;
            if (at_ == walk_.sorted && at_ < walk_.end_count) walk_.sort_more();
            const double b = at_ < walk_.end_count ? walk_.ends[at_].t : a;
            if (!(a < b) || b < from_) continue;
            if (a > to_) break;
            if (inside_ ? stays_inside(a) : walk_.most() < threshold_) continue;
            // Of the nearest end alone, what lies before the range need not be found.
            const bool cut = out_->first_only && a < from_;
            if (cut) a = from_;
            // Nor what lies beyond: its end may depend on what else the ray has met, so that no number comes from it.
            if (out_->first_only && to_ < b && a < to_) {
                const Quartic wanted = walk_.sum(a, to_, threshold_);
                if (ordinate_changes(wanted) == 0 && ((wanted[0] > 0.0) == inside_ || cut)) break;
            }
            sum_ = walk_.sum(a, b, threshold_);
            if ((sum_[0] > 0.0) != inside_) {
                if (cut) cross_before();
                else if (!cross(a)) break;
            }
            const int changes = ordinate_changes(sum_);
            if (changes == 1) {
                low_ = a;
                high_ = b;
                return true;
            }
            if (changes > 1) each_change(sum_, a, b, kHalvings, [&](double t) { return cross(t); });
        }
        // Nothing reaches beyond the last end.
        if (more_ && inside_ != below() && walk_.end_count != 0) cross(walk_.last_end());
        return false;
    }

    /// The polynomial that is asked for the place of its only change, 0 to 1.
    const Quartic& sum() const { return sum_; }
    void found(double place) { cross(low_ + (high_ - low_) * place); }

private:
    bool below() const { return 0.0 > threshold_; }

    /// Whether the ray surely is inside from `a` to the next end; passes ends for which the same is known.
    bool stays_inside(double a)
    {
        if (!walk_.only_adds) return false;
        for (;; stride_ /= 2) {
            const std::size_t last = std::min(at_ + stride_, walk_.sorted - 1);
            if (walk_.above(threshold_, a, walk_.ends[last].t)) {
                while (at_ < last) walk_.pass(walk_.ends[at_++]);
                return true;
            }
            if (stride_ == 0) return false;
        }
    }

    bool cross(double t)
    {
        inside_ = !inside_;
        more_ = inside_ ? out_->enter(start_ + t, 0) : out_->leave(start_ + t, 0);
        return more_;
    }

    void cross_before()
    {
        inside_ = !inside_;
        if (inside_) out_->enter(-kInfinity, kUndrawnFace);
        else out_->leave(-kInfinity, kUndrawnFace);
    }

    Walk walk_;
    IntersectionList* out_;
    double threshold_, start_, from_, to_;
    double low_, high_;  ///< where the sum is that has to be looked at
    Quartic sum_;
    std::size_t at_ = 0;      ///< of the ends, the next
    std::size_t stride_ = 0;  ///< so many ends further on it may still be inside
    bool inside_ = false;
    bool more_ = false;  ///< ends are still wanted
};

}  // namespace csg
