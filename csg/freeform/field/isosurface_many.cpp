#include "csg/freeform/field/isosurface.h"

#include "csg/freeform/field/isosurface_search.h"
#include "csg/roots/fused_at.h"

#include <array>
#include <bit>
#include <cmath>

namespace csg {

/// Isosurface::intersect() of one ray by POV-Ray's bisection, which stops wherever it asks the field: the same places
/// in the same order.
class Isosurface::Walk {
public:
    /// False: nothing is to be asked, and nothing is told.
    bool begin(const IsosurfaceTerms& terms, const Ray& ray, IntersectionList& out)
    {
        if (!terms.container.interval(ray, way_) || way_.exit < std::max(out.from, 0.0) || way_.entry > out.to)
            return false;
        terms_ = &terms;
        ray_ = ray;
        out_ = &out;
        speed_ = std::sqrt(glm::dot(ray.direction, ray.direction));
        gradient_ = terms.max_gradient;
        accuracy_ = IsosurfaceSearch::accuracy_along(terms, way_);
        far_ = IsosurfaceSearch::is_far(terms.container, ray);
        begin_ = std::max(way_.entry, 0.0);
        inside_ = drawn_entry_ = drawn_exit_ = false;
        pending_ = 0;
        return ask(Asking::Start, begin_);
    }

    glm::dvec3 point() const { return far_ ? fused_at(ray_, at_) : ray_.at(at_); }

    /// The field at point(). False: all is told.
    bool take(double field)
    {
        const double v = field - terms_->threshold;
        switch (asking_) {
        case Asking::Start: return take_start(v);
        case Asking::Beyond: inside_ = v < 0.0; return started();
        case Asking::Exit: drawn_exit_ = v < 0.0; return search();
        case Asking::From: from_value_ = sign_ * v; return ask(Asking::To, way_.exit);
        case Asking::To: push({from_, from_value_}, {way_.exit, sign_ * v}); return bisect();
        case Asking::Middle: {
            const Sample middle{at_, sign_ * v};
            push(middle, parted_.right);
            push(parted_.left, middle);
            return bisect();
        }
        }
        return false;
    }

private:
    enum class Asking { Start, Beyond, Exit, From, To, Middle };
    struct Sample {
        double t, f;
    };
    struct Piece {
        Sample left, right;
    };

    bool ask(Asking what, double t)
    {
        asking_ = what;
        at_ = t;
        return true;
    }
    void push(const Sample& left, const Sample& right) { pieces_[pending_++] = {left, right}; }

    /// Isosurface::start().
    bool take_start(double v)
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
        return started();
    }

    bool started()
    {
        if (way_.exit - begin_ < accuracy_) return false;
        left_ = terms_->max_trace - (drawn_entry_ ? 1 : 0);
        if (inside_ && !out_->enter(way_.entry, drawn_entry_ ? way_.entry_face : kUndrawnFace)) return false;
        from_ = begin_;
        if (!terms_->open && std::max(way_.entry, 0.0) <= accuracy_) return ask(Asking::Exit, way_.exit);
        return search();
    }

    /// IsosurfaceSearch::first() from where the last crossing was.
    bool search()
    {
        if (!(way_.exit - from_ >= accuracy_)) return end();
        sign_ = inside_ ? -1.0 : 1.0;
        if (terms_->evaluate && gradient_ > terms_->growth.x) gradient_ *= terms_->growth.z;
        return ask(Asking::From, from_);
    }

    /// IsosurfaceSearch::bisect(): the pieces that wait lie behind each other, the nearest on top.
    bool bisect()
    {
        while (pending_ > 0) {
            const Piece piece = pieces_[--pending_];
            const auto& [left, right] = piece;
            if (left.t > out_->to) continue;
            const double length = right.t - left.t, world = speed_ * length;
            if (terms_->evaluate) {
                const double slope = std::abs(right.f - left.f) / world;
                if (gradient_ < slope * terms_->growth.y) gradient_ = slope * terms_->growth.y * terms_->growth.y;
            }
            const double t = left.t + 0.5 * length;
            if (length < accuracy_ || t == left.t || t == right.t) {
                if (right.f < 0.0) return cross(right.t);
                continue;
            }
            if (!(left.f + right.f - gradient_ * world < 0.0)) continue;
            parted_ = piece;
            return ask(Asking::Middle, t);
        }
        return end();
    }

    bool cross(double t)
    {
        pending_ = 0;
        const std::uint32_t face = left_ > 0 ? kField : kUndrawnFace;
        if (!(inside_ ? out_->leave(t, face) : out_->enter(t, face))) return false;
        inside_ = !inside_;
        from_ = t + 5.0 * accuracy_;
        if (--left_ > 0 || !out_->first_only) return search();
        if (drawn_exit_) out_->touch(way_.exit, way_.exit_face);
        return false;
    }

    bool end()
    {
        if (inside_) out_->leave(way_.exit, drawn_exit_ ? way_.exit_face : kUndrawnFace);
        return false;
    }

    // Halves are no shorter than 2^-40 of the way: of each length one piece waits.
    static constexpr std::size_t kMostPieces = 64;

    const IsosurfaceTerms* terms_ = nullptr;
    IntersectionList* out_ = nullptr;
    Ray ray_;
    Interval way_;
    double speed_ = 0.0, gradient_ = 0.0, accuracy_ = 0.0, begin_ = 0.0, from_ = 0.0, from_value_ = 0.0, sign_ = 1.0;
    double at_ = 0.0;  ///< where the field is asked
    Asking asking_ = Asking::Start;
    bool far_ = false, inside_ = false;
    bool drawn_entry_ = false, drawn_exit_ = false;  ///< the container's wall
    int left_ = 0;                                   ///< crossings to be drawn
    Piece parted_{};
    std::size_t pending_ = 0;
    std::array<Piece, kMostPieces> pieces_;
};

void Isosurface::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    constexpr std::size_t kWide = 8;
    std::array<Walk, kWide> walks;
    EightPoints p{};
    std::uint32_t busy = 0;
    std::size_t next = 0;
    const auto put = [&](std::size_t lane) {
        const glm::dvec3 at = walks[lane].point();
        p.x.v[lane] = at.x, p.y.v[lane] = at.y, p.z.v[lane] = at.z;
    };
    const auto take_next = [&](std::size_t lane) {
        busy &= ~(1u << lane);
        while (next < rays.size()) {
            const std::size_t k = next++;
            if (!walks[lane].begin(terms_, rays[k], out[k])) continue;
            busy |= 1u << lane;
            return put(lane);
        }
    };
    for (std::size_t lane = 0; lane < kWide; ++lane) take_next(lane);
    while (busy != 0) {
        Eight f;
        const auto one = static_cast<std::size_t>(std::countr_zero(busy));
        if ((busy & (busy - 1)) == 0) {
            f.v[one] = terms_.field->value({p.x.v[one], p.y.v[one], p.z.v[one]});
        } else {
            // Where no ray asks, what another asks for: a point of a ray that is through may be anywhere.
            for (std::size_t lane = 0; lane < kWide; ++lane)
                if ((busy >> lane & 1u) == 0)
                    p.x.v[lane] = p.x.v[one], p.y.v[lane] = p.y.v[one], p.z.v[lane] = p.z.v[one];
            terms_.field->values(p, f);
        }
        for (std::uint32_t left = busy; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            if (walks[lane].take(f.v[lane])) put(lane);
            else take_next(lane);
        }
    }
}

}  // namespace csg
