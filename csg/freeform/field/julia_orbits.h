#pragma once

#include "numbers/lanes.h"
#include "csg/freeform/field/julia.h"
#include "csg/freeform/field/julia_functions.h"
#include "csg/freeform/field/julia_march.h"
#include "numbers/lane_power.h"

#include <array>
#include <bit>
#include <cmath>

namespace csg {

/// Julia::look() at many places together, each on a ray of its own, a place a lane: every number comes from the same
/// operations in the same order.
class Julia::Orbits {
public:
    using Double = lanes::Double;
    using Bool = Double::batch_bool_type;
    using Mask = std::uint32_t;
    static constexpr int kVectors = 4;  // so that some orbits are worked out while others wait for a sum
    static constexpr std::size_t kWide = static_cast<std::size_t>(lanes::kDoubles), kPlaces = kVectors * kWide;
    static constexpr Mask kVector = (1u << kWide) - 1u;
    using Numbers = std::array<double, kPlaces>;

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

    /// Lanes of the first so many vectors.
    static Mask first(int vectors) { return (Mask{2} << (static_cast<std::size_t>(vectors) * kWide - 1)) - 1u; }
    /// How many hold these lanes: 1, 2 or all.
    static int vectors(Mask of) { return (of & ~first(2)) != 0 ? kVectors : (of & ~kVector) != 0 ? 2 : 1; }

    explicit Orbits(const Julia& set) : set_(set) {}

    void set_ray(std::size_t lane, const Ray& ray)
    {
        ox_[lane] = ray.origin.x, oy_[lane] = ray.origin.y, oz_[lane] = ray.origin.z;
        dx_[lane] = ray.direction.x, dy_[lane] = ray.direction.y, dz_[lane] = ray.direction.z;
    }

    void move_ray(std::size_t from, std::size_t to)
    {
        for (Numbers* of : {&ox_, &oy_, &oz_, &dx_, &dy_, &dz_}) (*of)[to] = (*of)[from];
    }

    /// Which of the `asked` orbits stay. `stepping`: of these the next step is wanted too. Lanes beyond the vectors
    /// that hold those asked are left out.
    Mask look(const Numbers& places, Mask asked, Mask stepping)
    {
        switch (vectors(asked)) {
        case 1: return look<1>(places, asked, stepping);
        case 2: return look<2>(places, asked, stepping);
        default: return look<kVectors>(places, asked, stepping);
        }
    }
    /// Steps that the last look gave.
    const Numbers& steps() const { return steps_; }

private:
    struct Four {
        Double x, y, z, w;
    };
    static void pick(const Bool& which, const Four& a, Four& b)
    {
        b = {xsimd::select(which, a.x, b.x), xsimd::select(which, a.y, b.y), xsimd::select(which, a.z, b.z),
             xsimd::select(which, a.w, b.w)};
    }

    template <int V>
    Mask look(const Numbers& places, Mask asked, Mask stepping)
    {
        Four q[V];
        for (int v = 0; v < V; ++v) q[v] = point(v, load(places, v));
        const Double cx(set_.terms_.constant.x), cy(set_.terms_.constant.y), cz(set_.terms_.constant.z),
            cw(set_.terms_.constant.w);
        const auto square = [&](const Four& p, Four& rate) {
            rate = p;
            const Four s = product(p, p);
            return Four{s.x + cx, s.y + cy, s.z + cz, s.w + cw};
        };
        switch (set_.terms_.function) {
        case JuliaTerms::Function::Square:
            return quaternions<V>(q, asked, stepping, 2.0, [&](const Four& p) {
                const Double twice = Double(2.0) * p.x;
                return Four{p.x * p.x - p.y * p.y - p.z * p.z - p.w * p.w + cx, twice * p.y + cy, twice * p.z + cz,
                            twice * p.w + cw};
            });
        case JuliaTerms::Function::Cube:
            return quaternions<V>(q, asked, stepping, 3.0, [&](const Four& p) {
                const Double n = p.y * p.y + p.z * p.z + p.w * p.w, real = p.x * p.x, other = Double(3.0) * real - n;
                return Four{p.x * (real - Double(3.0) * n) + cx, p.y * other + cy, p.z * other + cz, p.w * other + cw};
            });
        case JuliaTerms::Function::HyperSquare: return hypercomplex<V, true>(q, asked, stepping, square);
        case JuliaTerms::Function::HyperCube: return hypercomplex<V, false>(q, asked, stepping, square);
        default:
            // As Julia::plain_start() has it.
            for (int v = 0; set_.terms_.as_37 && v < V; ++v) q[v].z = pick(part(stepping, v), q[v].z, q[v].y);
            return hypercomplex<V, false>(q, asked, stepping, [&](const Four& p, Four& rate) {
                rate = julia::by_parts(set_.terms_.function, p, set_.terms_.exponent);
                return Four{rate.x + cx, rate.y + cy, rate.z + cz, rate.w + cw};
            });
        }
    }

    Four point(int v, const Double& t) const
    {
        const Double x = load(ox_, v) + t * load(dx_, v), y = load(oy_, v) + t * load(dy_, v),
                     z = load(oz_, v) + t * load(dz_, v);
        return {x, y, z,
                Double(set_.offset_) -
                    (Double(set_.tilt_.x) * x + Double(set_.tilt_.y) * y + Double(set_.tilt_.z) * z)};
    }

    /// Those of the lanes `in` whose orbit has not gone.
    template <int V>
    static Mask lanes_in(const Bool (&in)[V])
    {
        Mask all = 0;
        for (int v = 0; v < V; ++v) all |= whole(lanes::mask(in[v]), v);
        return all;
    }

    /// Julia::look_quaternion().
    template <int V, class Next>
    Mask quaternions(Four (&q)[V], Mask asked, Mask stepping, double power, Next&& next)
    {
        const Double one(1.0), escape(set_.escape_);
        Double sizes[V], size_at[V], scale_at[V];  // as they were when the orbit had gone
        Bool in[V];
        for (int v = 0; v < V; ++v) {
            sizes[v] = size_at[v] = scale_at[v] = one;
            in[v] = lanes::lanes_of(part(asked, v));
        }
        Mask staying = asked;
        double scale = 1.0;
        for (int k = 0; k < set_.terms_.iterations; ++k) {
            scale *= power;
            for (int v = 0; v < V; ++v) {
                const Double size = julia::norm(q[v]);
                size_at[v] = xsimd::select(in[v], size, size_at[v]);
                scale_at[v] = xsimd::select(in[v], Double(scale), scale_at[v]);
                in[v] = in[v] & (size <= escape);
                sizes[v] = xsimd::select(in[v], sizes[v] * size, sizes[v]);
            }
            staying = lanes_in(in);
            if (staying == 0 || k + 1 == set_.terms_.iterations) break;
            for (int v = 0; v < V; ++v) q[v] = next(q[v]);
        }
        const Mask left = stepping & ~staying;
        for (int v = 0; v < V; ++v) {
            // Most logarithms are too small for more than the least step: those of which a tangent's ordinate is are
            // not worked out.
            const Double least(set_.step_), over = scale_at[v] * xsimd::sqrt(sizes[v]);
            Double most = xsimd::min(tangent<0>(size_at[v]), tangent<1>(size_at[v]));
            const Mask asking = part(left, v) & ~lanes::mask(most * Double(1.0 + 1e-9) < least * over);
            Double step = least;
            if (asking != 0) {
                const Double logarithm =
                    xsimd::select(size_at[v] < Double(kMostSize), lanes::logarithm(size_at[v]), size_at[v]);
                step = xsimd::select(lanes::lanes_of(asking), logarithm / over, least);
            }
            store(steps_, v, step);
        }
        return staying;
    }

    /// More than the logarithm, but where the two touch.
    template <int I>
    static Double tangent(const Double& x)
    {
        constexpr double kAt[2] = {8.0, 40.0}, kLogarithm[2] = {2.0794415416798357, 3.6888794541139363};
        return x * Double(1.0 / kAt[I]) + Double(kLogarithm[I] - 1.0);
    }

    /// julia::product().
    static Four product(const Four& a, const Four& b)
    {
        return {a.x * b.x - a.y * b.y - a.z * b.z + a.w * b.w, a.y * b.x + a.x * b.y - a.w * b.z - a.z * b.w,
                a.z * b.x - a.w * b.y + a.x * b.z - a.y * b.w, a.w * b.x + a.z * b.y + a.y * b.z + a.x * b.w};
    }

    /// Julia::look() by hypercomplex orbits and their derivatives.
    template <int V, bool Squares, class Next>
    Mask hypercomplex(Four (&q)[V], Mask asked, Mask stepping, Next&& next)
    {
        const Double one(1.0), escape(set_.escape_), step(set_.step_);
        Four slope[V];  // as all the others it remains where the orbit has gone
        Double factor_at[V];
        Bool in[V];
        for (int v = 0; v < V; ++v) {
            slope[v] = q[v];
            factor_at[v] = Double(2.0);
            in[v] = lanes::lanes_of(part(asked, v));
        }
        const bool slopes = stepping != 0;
        Mask staying = asked;
        double factor = 2.0;
        for (int k = 0; k < set_.terms_.iterations; ++k) {
            for (int v = 0; v < V; ++v) in[v] = in[v] & (julia::norm<Squares>(q[v]) <= escape);
            staying = lanes_in(in);
            if (staying == 0 || k + 1 == set_.terms_.iterations) break;
            if (k > 0) factor *= 2.0;
            for (int v = 0; v < V; ++v) {
                if (V > 1 && part(staying, v) == 0) continue;
                Four rate;
                const Four then = next(q[v], rate);
                if (slopes && k > 0) {
                    pick(in[v], product(rate, slope[v]), slope[v]);
                    factor_at[v] = xsimd::select(in[v], Double(factor), factor_at[v]);
                }
                pick(in[v], then, q[v]);
            }
        }
        const Mask asking = stepping & ~staying;
        for (int v = 0; v < V; ++v) {
            if (part(asking, v) == 0) {
                store(steps_, v, step);
                continue;
            }
            const Double f = set_.terms_.function == JuliaTerms::Function::HyperSquare ? factor_at[v] : one;
            const Four &s = slope[v], n{f * q[v].x, f * q[v].y, f * q[v].z, f * q[v].w};
            const Double gx = s.x * n.x + s.y * n.y + s.z * n.z + s.w * n.w,
                         gy = -s.y * n.x + s.x * n.y - s.w * n.z + s.z * n.w,
                         gz = -s.z * n.x - s.w * n.y + s.x * n.z + s.y * n.w;
            const Double along = gx * load(dx_, v) + gy * load(dy_, v) + gz * load(dz_, v), fall = Double(-2.0) * along,
                         size = julia::norm<Squares>(q[v]);
            const Bool guess = (along < Double(julia::kLeastSlope)) &
                               (size > Double(julia::kLeastGuess) * step * fall) &
                               (size < Double(julia::kMostGuess) * step * fall);
            store(steps_, v, pick(part(staying, v), step, xsimd::select(guess, size / fall, step)));
        }
        return staying;
    }

    const Julia& set_;
    alignas(64) Numbers ox_{}, oy_{}, oz_{}, dx_{}, dy_{}, dz_{}, steps_{};
};

}  // namespace csg
