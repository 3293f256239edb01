#include "csg/freeform/field/eight_ways.h"
#include "csg/freeform/field/isosurface.h"
#include "csg/freeform/field/isosurface_search.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace csg {

/// Isosurface::intersect() of one ray by POV-Ray's bisection, which stops wherever it asks the field: the same places
/// in the same order. What lies between two places is halved by EightWays.
class Isosurface::Walk {
public:
    enum class Next { Done, Ask, Halve };

    /// Done: nothing is to be asked, and nothing is told.
    Next begin(const IsosurfaceTerms& terms, const Ray& ray, IntersectionList& out, EightWays& ways, std::size_t lane)
    {
        if (!terms.container.interval(ray, way_) || way_.exit < std::max(out.from, 0.0) || way_.entry > out.to)
            return Next::Done;
        terms_ = &terms;
        out_ = &out;
        ways_ = &ways;
        lane_ = lane;
        accuracy_ = IsosurfaceSearch::accuracy_along(terms, way_);
        ways.begin(lane, ray, IsosurfaceSearch::is_far(terms.container, ray), accuracy_, terms.max_gradient, out.to);
        begin_ = std::max(way_.entry, 0.0);
        inside_ = drawn_entry_ = drawn_exit_ = false;
        exit_value_ = std::numeric_limits<double>::quiet_NaN();
        return ask(Asking::Start, begin_);
    }

    /// `v`: the field above the threshold where it was asked.
    Next take(double v)
    {
        switch (asking_) {
        case Asking::Start: return take_start(v);
        case Asking::Beyond: inside_ = v < 0.0; return started(v);
        case Asking::Exit:
            exit_value_ = v;
            drawn_exit_ = v < 0.0;
            return search(begin_value_);
        case Asking::From: return search(v);
        case Asking::To: exit_value_ = v; return halve();
        }
        return Next::Done;
    }

    Next cross(double t)
    {
        const std::uint32_t face = left_ > 0 ? kField : kUndrawnFace;
        if (!(inside_ ? out_->leave(t, face) : out_->enter(t, face))) return Next::Done;
        inside_ = !inside_;
        from_ = t + 5.0 * accuracy_;
        if (--left_ > 0 || !out_->first_only) return way_.exit - from_ >= accuracy_ ? ask(Asking::From, from_) : end();
        if (drawn_exit_) out_->touch(way_.exit, way_.exit_face);
        return Next::Done;
    }

    Next end()
    {
        if (inside_) out_->leave(way_.exit, drawn_exit_ ? way_.exit_face : kUndrawnFace);
        return Next::Done;
    }

private:
    enum class Asking { Start, Beyond, Exit, From, To };

    Next ask(Asking what, double t)
    {
        asking_ = what;
        ways_->at(lane_) = t;
        return Next::Ask;
    }

    /// Isosurface::start().
    Next take_start(double v)
    {
        const double near = 4.0 * accuracy_ * terms_->max_gradient;
        if (begin_ > accuracy_) {
            inside_ = v < 0.0;
            drawn_entry_ = inside_ && !terms_->open;
        } else if (terms_->open ? std::abs(v) < near : v < near) {
            begin_ = 5.0 * accuracy_;
            return ask(Asking::Beyond, begin_);
        } else {
            inside_ = v < 0.0;
        }
        return started(v);
    }

    Next started(double v)
    {
        if (way_.exit - begin_ < accuracy_) return Next::Done;
        left_ = terms_->max_trace - (drawn_entry_ ? 1 : 0);
        if (inside_ && !out_->enter(way_.entry, drawn_entry_ ? way_.entry_face : kUndrawnFace)) return Next::Done;
        from_ = begin_;
        begin_value_ = v;
        if (!terms_->open && std::max(way_.entry, 0.0) <= accuracy_) return ask(Asking::Exit, way_.exit);
        return search(v);
    }

    /// IsosurfaceSearch::first() from where the last crossing was, and the field is `v`.
    Next search(double v)
    {
        if (!(way_.exit - from_ >= accuracy_)) return end();
        from_value_ = v;
        if (terms_->evaluate) ways_->grow(lane_, {terms_->growth.x, terms_->growth.y, terms_->growth.z});
        return exit_value_ == exit_value_ ? halve() : ask(Asking::To, way_.exit);
    }

    Next halve()
    {
        ways_->part(lane_, {from_, from_value_}, {way_.exit, exit_value_}, inside_ ? -1.0 : 1.0);
        return Next::Halve;
    }

    const IsosurfaceTerms* terms_ = nullptr;
    IntersectionList* out_ = nullptr;
    EightWays* ways_ = nullptr;
    std::size_t lane_ = 0;
    Interval way_;
    double accuracy_ = 0.0, begin_ = 0.0, begin_value_ = 0.0, from_ = 0.0, from_value_ = 0.0;
    double exit_value_ = 0.0;  ///< no number: not asked yet
    Asking asking_ = Asking::Start;
    bool inside_ = false, drawn_entry_ = false, drawn_exit_ = false;  ///< drawn: the container's wall
    int left_ = 0;                                                    ///< crossings to be drawn
};

void Isosurface::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    using Next = Walk::Next;
    EightWays ways;
    std::array<Walk, EightWays::kWide> walks;
    const GradientGrowth growth{terms_.growth.x, terms_.growth.y, terms_.growth.z};
    std::uint32_t busy = 0, halving = 0, searching = 0;  // halving: of the busy ones those that ask for a middle
    std::size_t ray = 0;
    // A lane whose ray is through takes the next one.
    const auto go_on = [&](std::size_t lane, Next next) {
        const std::uint32_t bit = 1u << lane;
        busy |= bit;
        halving &= ~bit;
        while (next == Next::Done) {
            if (ray == rays.size()) {
                busy &= ~bit;
                return;
            }
            next = walks[lane].begin(terms_, rays[ray], out[ray], ways, lane);
            ++ray;
        }
        if (next == Next::Halve) searching |= bit;
    };
    const auto each = [](std::uint32_t lanes, auto&& f) {
        for (; lanes != 0; lanes &= lanes - 1) f(static_cast<std::size_t>(std::countr_zero(lanes)));
    };
    each((1u << EightWays::kWide) - 1, [&](std::size_t lane) { go_on(lane, Next::Done); });
    EightPoints p;
    Eight field{};
    while (busy != 0) {
        if ((busy & (busy - 1)) == 0) {
            const auto one = static_cast<std::size_t>(std::countr_zero(busy));
            const double v = terms_.field->value(ways.point(one)) - terms_.threshold;
            searching = halving;
            if (halving != 0) ways.take_middle(one, v);
            else go_on(one, walks[one].take(v));
            if (searching == 0) continue;
            const EightWays::Piece next = ways.search_alone(one, terms_.evaluate ? &growth : nullptr);
            halving = next == EightWays::Piece::Asks ? searching : 0;
            if (halving == 0)
                go_on(one, next == EightWays::Piece::Crossed ? walks[one].cross(ways.crossing(one)) : walks[one].end());
            continue;
        }
        ways.points(busy, p);
        terms_.field->values(p, field);
        for (double& v : field.v) v -= terms_.threshold;
        searching = halving;
        ways.take_middles(halving, field);
        each(busy & ~halving, [&](std::size_t lane) { go_on(lane, walks[lane].take(field.v[lane])); });
        std::uint32_t crossed = 0;
        const std::uint32_t searched = searching;
        halving = ways.search(searched, terms_.evaluate ? &growth : nullptr, crossed);
        each(searched & ~halving, [&](std::size_t lane) {
            go_on(lane, (crossed >> lane & 1u) != 0 ? walks[lane].cross(ways.crossing(lane)) : walks[lane].end());
        });
    }
}

}  // namespace csg
