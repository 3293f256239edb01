#pragma once

#include "csg/spans/span.h"

#include <cstdint>
#include <utility>

namespace csg {

/// Sorted, disjoint spans in memory that the caller provides. A push beyond the capacity is dropped; callers size
/// the memory from Program, so that it does not happen.
class SpanList {
public:
    SpanList() = default;
    SpanList(Span* memory, std::uint32_t capacity) : spans_(memory), capacity_(capacity) {}

    const Span* begin() const { return spans_; }
    const Span* end() const { return spans_ + size_; }
    Span* begin() { return spans_; }
    Span* end() { return spans_ + size_; }
    std::uint32_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    const Span& operator[](std::uint32_t i) const { return spans_[i]; }
    void clear() { size_ = 0; }

    /// Appends a span that begins at or after the end of the last one. Ignores NaN and reversed ends.
    void push(const Span& span)
    {
        if (span.in.t <= span.out.t && size_ < capacity_) spans_[size_++] = span;
    }

    /// Whether the solid holds the point at t. Ends within `slack` of t count as exactly at t, where the solid's
    /// own convention (closed or open) decides: that keeps coincident faces from speckling.
    bool contains(double t, double slack = 0.0) const
    {
        return contains(t, slack, [](const Crossing& own) { return own.closed; });
    }

    /// The same where holds(end) tells of an end within the slack whether it belongs to the solid.
    template <class Holds>
    bool contains(double t, double slack, Holds&& holds) const
    {
        for (const Span& span : *this) {
            if (t < span.in.t - slack) return false;
            const bool begun = t > span.in.t + slack || holds(span.in);
            const bool ended = t > span.out.t + slack || (t >= span.out.t - slack && !holds(span.out));
            if (begun && !ended) return true;
        }
        return false;
    }

private:
    Span* spans_ = nullptr;
    std::uint32_t size_ = 0, capacity_ = 0;
};

/// Spans with their memory: for tests and for what runs once per scene.
template <std::uint32_t Capacity>
class FixedSpans : public SpanList {
public:
    FixedSpans() : SpanList(memory_, Capacity) {}
    FixedSpans(const FixedSpans& other) : FixedSpans() { *this = other; }
    FixedSpans& operator=(const FixedSpans& other)
    {
        clear();
        for (const Span& span : other) push(span);
        return *this;
    }

private:
    Span memory_[Capacity];
};

namespace detail {

// An end lies just before or just after its parameter, depending on whether the point there belongs to the span:
// [t starts at (t, 0), (t at (t, 1); t] stops at (t, 1), t) at (t, 0). With that order sets with closed and open ends
// are merged without special cases.
inline bool precedes(double a, bool a_after, double b, bool b_after)
{
    return a < b || (a == b && !a_after && b_after);
}
inline bool in_before_in(const Crossing& a, const Crossing& b) { return precedes(a.t, !a.closed, b.t, !b.closed); }
inline bool out_before_out(const Crossing& a, const Crossing& b) { return precedes(a.t, a.closed, b.t, b.closed); }
inline bool out_before_in(const Crossing& out, const Crossing& in)
{
    return precedes(out.t, out.closed, in.t, !in.closed);
}
inline bool in_before_out(const Crossing& in, const Crossing& out)
{
    return precedes(in.t, !in.closed, out.t, out.closed);
}

}  // namespace detail

/// result := a or b, in one pass. `result` must not share memory with a or b and holds up to a.size() + b.size().
inline void unite(const SpanList& a, const SpanList& b, SpanList& result)
{
    result.clear();
    const Span *p = a.begin(), *q = b.begin();
    const Span *p_end = a.end(), *q_end = b.end();
    if (p == p_end) std::swap(p, q), std::swap(p_end, q_end);
    while (p != p_end) {
        if (q != q_end && detail::in_before_in(q->in, p->in)) std::swap(p, q), std::swap(p_end, q_end);
        Span joined = *p++;
        for (;;) {  // absorb everything that begins before the joined span ends
            if (p != p_end && !detail::out_before_in(joined.out, p->in)) {
                if (detail::out_before_out(joined.out, p->out)) joined.out = p->out;
                ++p;
            } else if (q != q_end && !detail::out_before_in(joined.out, q->in)) {
                if (detail::out_before_out(joined.out, q->out)) joined.out = q->out;
                ++q;
            } else {
                break;
            }
        }
        result.push(joined);
        if (p == p_end) std::swap(p, q), std::swap(p_end, q_end);
    }
}

/// result := a and b, in one pass. `result` must not share memory with a or b and holds up to a.size() + b.size().
inline void intersect(const SpanList& a, const SpanList& b, SpanList& result)
{
    result.clear();
    const Span *p = a.begin(), *q = b.begin();
    while (p != a.end() && q != b.end()) {
        const Crossing& in = detail::in_before_in(p->in, q->in) ? q->in : p->in;
        const bool p_first = detail::out_before_out(p->out, q->out);
        const Crossing& out = p_first ? p->out : q->out;
        if (detail::in_before_out(in, out)) result.push({in, out});
        if (p_first) ++p;
        else ++q;
    }
}

/// result := what a does not hold; ends change sides and become inverted. `result` must not share memory with a and
/// holds up to a.size() + 1.
inline void complement(const SpanList& a, SpanList& result)
{
    const auto normal_flipped = [](Crossing c) {
        c.inverted = !c.inverted;
        c.closed = !c.closed;
        return c;
    };
    result.clear();
    Crossing begin{.t = -kInfinity};
    bool open = true;  // the part before the next span is not empty
    for (const Span& span : a) {
        const Crossing end = normal_flipped(span.in);
        if (open && span.in.t > -kInfinity && detail::in_before_out(begin, end)) result.push({begin, end});
        begin = normal_flipped(span.out);
        open = span.out.t < kInfinity;
    }
    if (open) result.push({begin, {.t = kInfinity}});
}

/// result := a and not b, in one pass; b's ends become inverted. `result` must not share memory with a or b and holds
/// up to a.size() + b.size().
inline void subtract(const SpanList& a, const SpanList& b, SpanList& result)
{
    result.clear();
    const auto normal_flipped = [](Crossing c) {
        c.inverted = !c.inverted;
        c.closed = !c.closed;
        return c;
    };
    const Span* q = b.begin();
    for (const Span& span : a) {
        Crossing in = span.in;
        bool left = true;  // something of the span from `in` on may remain
        while (left && q != b.end() && detail::in_before_out(q->in, span.out)) {
            const Crossing again = normal_flipped(q->out);
            if (detail::in_before_in(in, again)) {  // else the cut ended before this span began
                const Crossing stop = normal_flipped(q->in);
                if (detail::in_before_out(in, stop)) result.push({in, stop});
                in = again;
                left = detail::in_before_out(in, span.out);
                if (!left) break;  // the cut may reach into the next span
            }
            ++q;
        }
        if (left) result.push({in, span.out});
    }
}

}  // namespace csg
