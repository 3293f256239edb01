#pragma once

#include "csg/spans/span_list.h"

#include <algorithm>
#include <array>

namespace csg {

/// What a freeform shape tells of one ray, in the ray's own parameter: where it goes in and out, or what it touches.
class IntersectionList {
public:
    /// Farther ends of one ray are not kept.
    static constexpr std::uint32_t kMostSpans = 128, kMostTouches = 64;

    /// A shape may leave out what lies wholly outside [from, to]; what it tells of the rest is whole. `first_only`: no
    /// more is wanted than the nearest drawn end.
    IntersectionList(double nearest, double farthest, bool first) : from(nearest), to(farthest), first_only(first) {}
    /// Of no ray yet: begin() first.
    IntersectionList() = default;

    /// Forgets what was told and asks anew.
    void begin(double nearest, double farthest, bool first)
    {
        from = nearest;
        to = farthest;
        first_only = first;
        spans_ = touches_ = 0;
    }

    double from = 0.0, to = 0.0;
    bool first_only = false;

    /// Into the solid, then out of it, nearest first; ends may be infinite. False: no more is wanted.
    bool enter(double t, std::uint32_t face)
    {
        if (spans_ == kMostSpans) return false;
        in_[spans_] = {t, face};
        out_[spans_++] = {kInfinity, kUndrawnFace};
        return !(first_only && wanted(t, face));
    }
    bool leave(double t, std::uint32_t face)
    {
        out_[spans_ - 1] = {t, face};
        return !(first_only && wanted(t, face)) && t <= to;
    }
    /// A surface that bounds nothing, in any order.
    void touch(double t, std::uint32_t face)
    {
        if (wanted(t, face) && touches_ < kMostTouches) touch_[touches_++] = {t, face};
    }

    /// f(t in, face, t out, face) for each span.
    template <class F>
    void each_span(F&& f) const
    {
        for (std::uint32_t i = 0; i < spans_; ++i) f(in_[i].t, in_[i].face, out_[i].t, out_[i].face);
    }
    /// f(t, face) for each touch.
    template <class F>
    void each_touching(F&& f) const
    {
        for (std::uint32_t i = 0; i < touches_; ++i) f(touch_[i].t, touch_[i].face);
    }

private:
    struct End {
        double t;
        std::uint32_t face;
    };
    bool wanted(double t, std::uint32_t face) const { return t >= from && t <= to && face != kUndrawnFace; }

    std::uint32_t spans_ = 0, touches_ = 0;
    // Filled as far as the counts say: clearing them would cost more than most shapes.
    std::array<End, kMostSpans> in_, out_;
    std::array<End, kMostTouches> touch_;
};

}  // namespace csg
