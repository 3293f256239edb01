#include "csg/freeform/field/julia.h"
#include "csg/freeform/field/julia_march.h"
#include "csg/base/lanes.h"

#include <array>
#include <bit>
#include <cmath>

namespace csg {

/// Julia::intersect() of many rays, a ray a lane: every number comes from the same operations in the same order. What a
/// lane does is told by bits of masks, not by branches: rays that march and rays that close in on a crossing follow
/// their orbits together. A lane whose ray is done takes the next one.
class Julia::Lanes {
public:
    Lanes(const Julia& set, std::span<const Ray> rays, IntersectionList* out) : set_(set), rays_(rays), out_(out) {}

    void run()
    {
        for (std::size_t lane = 0; lane < kRays; ++lane) take_next(lane);
        while ((first_ | second_ | stepping_ | halving_) != 0) look();
    }

private:
    using Double = lanes::Double;
    using Bool = Double::batch_bool_type;
    using Mask = std::uint32_t;
    static constexpr int kVectors = 2;  // so that one's orbit is worked out while the other's waits for a sum
    static constexpr std::size_t kWide = static_cast<std::size_t>(lanes::kDoubles), kRays = kVectors * kWide;
    static constexpr Mask kVector = (1u << kWide) - 1u;
    using Numbers = std::array<double, kRays>;
    struct Four {
        Double x, y, z, w;
        Double norm() const { return x * x + y * y + z * z + w * w; }
    };
    static Double load(const Numbers& from, int v)
    {
        return Double::load_aligned(from.data() + static_cast<std::size_t>(v) * kWide);
    }
    static void store(Numbers& to, int v, const Double& what)
    {
        what.store_aligned(to.data() + static_cast<std::size_t>(v) * kWide);
    }
    static Mask part(Mask of, int v) { return of >> (static_cast<std::size_t>(v) * kWide) & kVector; }
    static Mask whole(Mask of, int v) { return of << (static_cast<std::size_t>(v) * kWide); }
    static Double pick(Mask bits, const Double& a, const Double& b)
    {
        return xsimd::select(lanes::lanes_of(bits), a, b);
    }
    static void pick(const Bool& which, const Four& a, Four& b)
    {
        b = {xsimd::select(which, a.x, b.x), xsimd::select(which, a.y, b.y), xsimd::select(which, a.z, b.z),
             xsimd::select(which, a.w, b.w)};
    }
    static void set_bit(Mask& of, Mask bit, bool on) { of = on ? of | bit : of & ~bit; }

    void leave(std::size_t lane)
    {
        const Mask rest = ~(1u << lane);
        first_ &= rest, second_ &= rest, stepping_ &= rest, halving_ &= rest;
    }

    /// The next ray that comes into the sphere.
    void take_next(std::size_t lane)
    {
        leave(lane);
        while (next_ray_ < rays_.size()) {
            const std::size_t k = next_ray_++;
            const julia::Way way(rays_[k], set_.radius_, out_[k]);
            if (!way.meets) continue;
            ox_[lane] = way.unit.origin.x, oy_[lane] = way.unit.origin.y, oz_[lane] = way.unit.origin.z;
            dx_[lane] = way.unit.direction.x, dy_[lane] = way.unit.direction.y, dz_[lane] = way.unit.direction.z;
            t_[lane] = way.begin, end_[lane] = way.end, nearest_[lane] = way.nearest;
            marches_[lane] = {way, &out_[k], 0.0, false};
            first_ |= 1u << lane;
            return;
        }
    }

    /// On from t by the step that a look gave.
    void march_on(std::size_t lane, double step)
    {
        leave(lane);
        step_[lane] = std::max(step, set_.step_);
        if (step_[lane] < kInfinity && t_[lane] + step_[lane] <= end_[lane]) stepping_ |= 1u << lane;
        else finish(lane);
    }

    void finish(std::size_t lane)
    {
        const March& m = marches_[lane];
        if ((inside_ >> lane & 1u) != 0) m.out->leave(m.way.world(m.way.exit), kUndrawnFace);
        take_next(lane);
    }

    /// The interval where the ray goes in or out is as short as it has to be.
    void cross(std::size_t lane)
    {
        const March& m = marches_[lane];
        const bool leaves = (inside_ >> lane & 1u) != 0;
        const bool more = leaves ? m.out->leave(m.way.world(same_[lane]), 0)
                                 : m.out->enter(m.way.world(same_[lane], step_[lane]), 0);
        if (!more || m.out->first_only) return take_next(lane);
        t_[lane] = behind_[lane];
        set_bit(inside_, 1u << lane, m.inside_behind);
        march_on(lane, m.step_behind);
    }

    /// Where each lane looks: at t, a step beyond it, or half of an interval beyond `same`.
    Four point(int v) const
    {
        const Double at = load(t_, v), step = load(step_, v);
        const Double t = pick(part(stepping_, v), at + step, pick(part(halving_, v), load(same_, v) + step, at));
        const Double x = load(ox_, v) + t * load(dx_, v), y = load(oy_, v) + t * load(dy_, v),
                     z = load(oz_, v) + t * load(dz_, v);
        return {x, y, z,
                Double(set_.offset_) -
                    (Double(set_.tilt_.x) * x + Double(set_.tilt_.y) * y + Double(set_.tilt_.z) * z)};
    }

    /// One look of every lane, and what follows from it.
    void look()
    {
        Four q[kVectors];
        for (int v = 0; v < kVectors; ++v) q[v] = point(v);
        const Double cx(set_.terms_.constant.x), cy(set_.terms_.constant.y), cz(set_.terms_.constant.z),
            cw(set_.terms_.constant.w);
        Mask in = 0;
        switch (set_.terms_.function) {
        case JuliaTerms::Function::Square:
            in = quaternions(q, 2.0, [&](const Four& p) {
                const Double twice = Double(2.0) * p.x;
                return Four{p.x * p.x - p.y * p.y - p.z * p.z - p.w * p.w + cx, twice * p.y + cy, twice * p.z + cz,
                            twice * p.w + cw};
            });
            break;
        case JuliaTerms::Function::Cube:
            in = quaternions(q, 3.0, [&](const Four& p) {
                const Double n = p.y * p.y + p.z * p.z + p.w * p.w, square = p.x * p.x,
                             other = Double(3.0) * square - n;
                return Four{p.x * (square - Double(3.0) * n) + cx, p.y * other + cy, p.z * other + cz,
                            p.w * other + cw};
            });
            break;
        default:
            in = hypercomplex(q, [&](const Four& p) {
                const Four s = product(p, p);
                return Four{s.x + cx, s.y + cy, s.z + cz, s.w + cw};
            });
        }
        settle(in);
    }

    /// Julia::look_quaternion(). Returns the lanes whose orbits stay; steps of those that look go to found_.
    template <class Next>
    Mask quaternions(Four (&q)[kVectors], double power, Next&& next)
    {
        const Double one(1.0), escape(set_.escape_);
        Double sizes[kVectors], size_at[kVectors], sizes_at[kVectors], scale_at[kVectors];
        Bool in[kVectors];
        for (int v = 0; v < kVectors; ++v) {
            sizes[v] = size_at[v] = sizes_at[v] = scale_at[v] = one;
            in[v] = lanes::lanes_of(part(busy(), v));
        }
        Mask staying = busy();
        double scale = 1.0;
        for (int k = 0; k < set_.terms_.iterations && staying != 0; ++k) {
            scale *= power;
            staying = 0;
            for (int v = 0; v < kVectors; ++v) {
                const Double size = q[v].norm();
                const Bool stays = size <= escape, gone = in[v] & !stays;
                size_at[v] = xsimd::select(gone, size, size_at[v]);
                sizes_at[v] = xsimd::select(gone, sizes[v], sizes_at[v]);
                scale_at[v] = xsimd::select(gone, Double(scale), scale_at[v]);
                in[v] = in[v] & stays;
                staying |= whole(lanes::mask(in[v]), v);
                sizes[v] = sizes[v] * size;
                q[v] = next(q[v]);
            }
        }
        const Mask asking = busy() & ~halving_ & ~staying;
        for (int v = 0; v < kVectors; ++v) {
            if (part(asking, v) == 0) {
                store(found_, v, Double(set_.step_));
                continue;
            }
            alignas(64) Numbers logarithm;
            store(logarithm, v, size_at[v]);
            for (Mask left = whole(part(asking, v), v); left != 0; left &= left - 1) {
                double& one_of = logarithm[static_cast<std::size_t>(std::countr_zero(left))];
                one_of = std::log(one_of);
            }
            store(found_, v,
                  pick(part(staying, v), Double(set_.step_),
                       load(logarithm, v) / (scale_at[v] * xsimd::sqrt(sizes_at[v]))));
        }
        return staying;
    }

    /// julia::product().
    static Four product(const Four& a, const Four& b)
    {
        return {a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
                a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
    }

    /// Julia::look() by hypercomplex orbits and their derivatives.
    template <class Next>
    Mask hypercomplex(Four (&q)[kVectors], Next&& next)
    {
        const Double one(1.0), escape(set_.escape_), step(set_.step_);
        Four slope[kVectors], last[kVectors], slope_at[kVectors];
        Double factor_at[kVectors];
        Bool in[kVectors];
        for (int v = 0; v < kVectors; ++v) {
            slope[v] = q[v];
            last[v] = slope_at[v] = {one, one, one, one};
            factor_at[v] = one;
            in[v] = lanes::lanes_of(part(busy(), v));
        }
        const bool slopes = (busy() & ~halving_) != 0;
        Mask staying = busy();
        double factor = 2.0;
        for (int k = 0; k < set_.terms_.iterations && staying != 0; ++k) {
            staying = 0;
            for (int v = 0; v < kVectors; ++v) {
                const Bool stays = q[v].norm() <= escape, gone = in[v] & !stays;
                in[v] = in[v] & stays;
                staying |= whole(lanes::mask(in[v]), v);
                if (slopes) {
                    if (lanes::mask(gone) != 0) {
                        pick(gone, q[v], last[v]);
                        pick(gone, slope[v], slope_at[v]);
                        factor_at[v] = xsimd::select(gone, Double(factor), factor_at[v]);
                    }
                    if (k > 0) slope[v] = product(q[v], slope[v]);
                }
                q[v] = next(q[v]);
            }
            if (k > 0) factor *= 2.0;
        }
        const Mask asking = busy() & ~halving_ & ~staying;
        for (int v = 0; v < kVectors; ++v) {
            if (part(asking, v) == 0) {
                store(found_, v, step);
                continue;
            }
            const Double f = set_.terms_.function == JuliaTerms::Function::HyperSquare ? factor_at[v] : one;
            const Four &s = slope_at[v], n{f * last[v].x, f * last[v].y, f * last[v].z, f * last[v].w};
            const Double gx = s.x * n.x + s.y * n.y + s.z * n.z + s.w * n.w,
                         gy = -s.y * n.x + s.x * n.y - s.w * n.z + s.z * n.w,
                         gz = -s.z * n.x - s.w * n.y + s.x * n.z + s.y * n.w;
            const Double along = gx * load(dx_, v) + gy * load(dy_, v) + gz * load(dz_, v), fall = Double(-2.0) * along,
                         size = last[v].norm();
            const Bool guess = (along < Double(julia::kLeastSlope)) &
                               (size > Double(julia::kLeastGuess) * step * fall) &
                               (size < Double(julia::kMostGuess) * step * fall);
            store(found_, v, pick(part(staying, v), step, xsimd::select(guess, size / fall, step)));
        }
        return staying;
    }

    /// What follows from a look: most rays step on or halve once more, the others one by one.
    void settle(Mask in)
    {
        const Mask changed = stepping_ & (in ^ inside_), going = stepping_ & ~changed;
        Mask special = first_ | second_;
        for (int v = 0; v < kVectors; ++v) {
            const Mask goes = part(going, v), halves = part(halving_, v), change = part(changed, v),
                       same = halves & ~(part(in, v) ^ part(inside_, v));
            const Double step = load(step_, v), here = load(t_, v), low = load(same_, v), there = here + step;
            const Double found = load(found_, v), least(set_.step_);
            const Double wide = xsimd::select(found < least, least, found);
            store(t_, v, pick(goes, there, here));
            store(same_, v, pick(change, here, pick(same, low + step, low)));
            store(behind_, v, pick(change, there, load(behind_, v)));
            // An interval with a change just found is treated as one that was halved.
            const Mask more = (halves | change) & lanes::mask(step > load(nearest_, v));
            const Mask ends = goes &
                              ~(lanes::mask(wide < Double(kInfinity)) & lanes::mask(there + wide <= load(end_, v)));
            store(step_, v, pick(goes, wide, pick(more, step * Double(0.5), step)));
            special |= whole(ends | ((halves | change) & ~more), v);
        }
        for (Mask left = changed; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            marches_[lane].inside_behind = (in >> lane & 1u) != 0;
            marches_[lane].step_behind = found_[lane];
        }
        stepping_ &= ~changed;
        halving_ |= changed;
        for (; special != 0; special &= special - 1)
            settle_one(static_cast<std::size_t>(std::countr_zero(special)), in);
    }

    void settle_one(std::size_t lane, Mask looked)
    {
        const Mask bit = 1u << lane;
        const bool in = (looked & bit) != 0;
        if ((halving_ & bit) != 0) return cross(lane);
        if ((stepping_ & bit) != 0) return finish(lane);
        set_bit(inside_, bit, in);
        const March& m = marches_[lane];
        if ((first_ & bit) != 0 && in) {  // once more, a little farther on
            t_[lane] += 2.0 * julia::kNearest;
            first_ &= ~bit, second_ |= bit;
            return;
        }
        if (in && !m.out->enter(m.way.world(m.way.entry), kUndrawnFace)) return take_next(lane);
        march_on(lane, found_[lane]);
    }

    Mask busy() const { return first_ | second_ | stepping_ | halving_; }

    /// What a ray seldom needs.
    struct March {
        julia::Way way;
        IntersectionList* out;
        double step_behind;  ///< what the look behind a crossing gave
        bool inside_behind;
    };

    const Julia& set_;
    std::span<const Ray> rays_;
    IntersectionList* out_;
    std::size_t next_ray_ = 0;
    Mask first_ = 0, second_ = 0, stepping_ = 0, halving_ = 0;  ///< what a lane looks for; none: it has no ray
    Mask inside_ = 0;                                           ///< at t
    // A lane without a ray looks all the same.
    alignas(64) Numbers ox_{}, oy_{}, oz_{}, dx_{}, dy_{}, dz_{}, t_{}, end_{}, nearest_{};
    alignas(64) Numbers step_{};    ///< to the next look, or half of the interval
    alignas(64) Numbers same_{};    ///< still as at t: begin of the interval
    alignas(64) Numbers behind_{};  ///< where the step led that found a change
    alignas(64) Numbers found_{};   ///< steps that looks gave
    std::array<March, kRays> marches_;
};

void Julia::intersect_many(std::span<const Ray> rays, IntersectionList* out) const { Lanes(*this, rays, out).run(); }

}  // namespace csg
