#pragma once

#include "csg/freeform/revolution/axis_ray.h"
#include "csg/freeform/shared/sorted_ends.h"

#include <array>

/// The answer of a lathe to a ray; single rays and rays in lanes share it.
namespace csg {

/// Collects the crossings of one ray as they are found. If all are asked for, it keeps them. If the nearest is enough,
/// it keeps that, and holds back candidates that are costly to work out, in the order of their lower bounds: most of
/// them turn out to lie farther off. \tparam Waiting a candidate; its crossing is no nearer than its member `nearest`
template <class Waiting>
class LatheTold {
public:
    using Event = SortedEnds::End;

    /// To be called first.
    void begin(const IntersectionList& wanted)
    {
        from_ = wanted.from;
        best_ = {wanted.to, kUndrawnFace};
        first_only_ = wanted.first_only;
    }
    bool first_only() const { return first_only_; }
    double from() const { return from_; }
    double to() const { return best_.t; }

    void add(double t, std::uint32_t face)
    {
        if (!first_only_) events_.add(t, face);
        else if (t >= from_ && t <= best_.t && t < kInfinity) best_ = {t, face};
    }

    /// Holds back a candidate whose crossing lies in [one.nearest, last]; drops it if that is outside of the range that
    /// was asked for. resolve(one) is called, and calls add(), if there is no room to hold it back.
    template <class Resolve>
    void wait(const Waiting& one, double last, Resolve&& resolve)
    {
        if (last < from_ || one.nearest > best_.t) return;
        if (waiting_count_ == kMostWaiting) {
            resolve(one);
            return;
        }
        std::uint32_t at = waiting_count_++;
        for (; at > 0 && waiting_[at - 1].nearest > one.nearest; --at) waiting_[at] = waiting_[at - 1];
        waiting_[at] = one;
    }
    /// Calls resolve() for the candidates that may still be the nearest.
    template <class Resolve>
    void resolve_waiting(Resolve&& resolve)
    {
        for (std::uint32_t i = 0; i < waiting_count_; ++i)
            if (!(waiting_[i].nearest > best_.t)) resolve(waiting_[i]);
    }

    /// Reports the nearest crossing, if that is enough; whether it leads in or out does not matter.
    void tell_nearest(IntersectionList& out) const { out.touch(best_.t, best_.face); }
    /// Reports all crossings. `hole`: what is nearer to the axis is never inside. is_negative(face): the face is drawn,
    /// but bounds nothing.
    template <class IsNegative>
    void tell(const AxisRay& ray, double hole, IsNegative&& is_negative, IntersectionList& out) const
    {
        double from = kInfinity, to = kInfinity;  // the stretch of the ray in the hole
        if (hole > 0.0 && ray.valid()) ray.within(hole, from, to);
        const Event* in = nullptr;
        for (const Event& event : events_) {
            if (event.face != kUndrawnFace && is_negative(event.face)) {
                out.touch(event.t, event.face);
            } else if (in == nullptr) {
                in = &event;
            } else {
                if (!span(*in, event, from, to, out)) return;
                in = nullptr;
            }
        }
    }

private:
    /// Reports a span without its part in the hole. False: the caller wants no more.
    static bool span(const Event& in, const Event& end, double from, double to, IntersectionList& out)
    {
        const auto push = [&](const Event& a, const Event& b) {
            return !(a.t <= b.t) || (out.enter(a.t, a.face) && out.leave(b.t, b.face));
        };
        if (!(from < end.t && to > in.t)) return push(in, end);
        return (from <= in.t || push(in, {from, kUndrawnFace})) && (to >= end.t || push({to, kUndrawnFace}, end));
    }

    static constexpr std::uint32_t kMostWaiting = 8;

    double from_ = 0.0;
    Event best_{};  // of all so far, if one is enough
    bool first_only_ = false;
    std::uint32_t waiting_count_ = 0;
    SortedEnds events_;
    std::array<Waiting, kMostWaiting> waiting_;  // filled as far as the count says
};

}  // namespace csg
