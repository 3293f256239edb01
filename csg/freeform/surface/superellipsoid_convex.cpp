#include "csg/freeform/surface/superellipsoid.h"
#include "csg/base/hit.h"
#include "numbers/lane_power.h"

#include <array>
#include <bit>
#include <cmath>

namespace csg {

/// Newton for rays against a length that is convex along each of them. One ray and rays in lanes go through the same
/// formulas, so they are told the same to the last bit.
class Superellipsoid::Convex {
public:
    Convex(const Superellipsoid& shape, std::span<const Ray> rays, IntersectionList* out)
        : shape_(shape), rays_(rays), out_(out)
    {}

    void run()
    {
        if (std::isnan(shape_.across_) || std::isnan(shape_.along_)) return;
        const Set left = leave_out(prepare());
        const auto enter = [&](std::size_t k) { return out_[k].enter(start_[k] + in_[k], 0); };
        Set passing = 0, left_again = 0;
        if (few(left) && which(left, [&](std::size_t k) { return may_leave(k); }) != 0) {
            const Ways both = both_ways(left);
            passing = which(both.forth, enter);
            // The ends were looked for as far as the ranges begin, not the entries. Steps only grow.
            left_again = which(passing & both.back, [&](std::size_t k) { return exit_[k] <= -in_[k]; });
        } else {
            passing = which(newton(left, 1.0, from_, to_, in_), enter);
            each(passing, [&](std::size_t k) {
                from_[k] = -to_[k];
                to_[k] = -in_[k];
            });
            left_again = newton(passing, -1.0, from_, to_, exit_);
        }
        each(passing,
             [&](std::size_t k) { out_[k].leave(start_[k] - ((left_again >> k & 1u) != 0 ? exit_[k] : -in_[k]), 0); });
    }

    /// Superellipsoid::meets_no_more().
    bool meets_no_more(const Ray& ray, double from, double to) const
    {
        alignas(64) std::array<double, kWide> t;
        t.fill(to);
        t[0] = from;
        const Double at = Double::load_aligned(t.data());
        const glm::dvec3 &o = ray.origin, &d = ray.direction;
        const Slope<Double> here =
            slope<Double>({o.x + at * d.x, o.y + at * d.y, o.z + at * d.z}, {Double(d.x), Double(d.y), Double(d.z)});
        const std::uint32_t outside = bits(here.value > Double(kOff)), inside = bits(here.value < Double(-kOff));
        return (outside & bits(here.rate > Double(kOff)) & 1u) != 0 || (inside & 3u) == 3u;
    }

private:
    using Double = lanes::Double;
    using Set = std::uint64_t;  ///< bit k: ray k
    using Numbers = std::array<double, kTileRays>;
    static constexpr std::size_t kWide = static_cast<std::size_t>(lanes::kDoubles);

    static constexpr double kClear = 1.0 + 1e-9;  // Newton begins so far outside
    static constexpr double kRounding =
        1e-15;                              // of the length near 1: nine roundings of one half unit in the last place
    static constexpr double kClose = 1e-9;  // a step so short, local units: the next would be its square
    static constexpr double kSure = 1e-9;   // of the length and its rate: by more than they can be off
    static constexpr double kOff = 3e-14;   // of the length and its rate: what Newton tells is nearer to the surface
    static constexpr int kMostSteps = 80;   // where the ray grazes, each step halves the way left

    template <class F>
    static void each(Set rays, F&& f)
    {
        for (; rays != 0; rays &= rays - 1) f(static_cast<std::size_t>(std::countr_zero(rays)));
    }
    template <class F>
    static Set which(Set rays, F&& holds)
    {
        Set out = 0;
        each(rays, [&](std::size_t k) { out |= Set{holds(k) ? 1u : 0u} << k; });
        return out;
    }
    /// So few that entries and exits fit in the lanes together.
    static bool few(Set rays) { return 2 * std::popcount(rays) <= lanes::kDoubles; }
    /// Whether the end may be asked for: not if the entry is the nearest one wanted.
    bool may_leave(std::size_t k) const { return !(out_[k].first_only && begin(k) <= from_[k]); }
    double begin(std::size_t k) const { return out_[k].from - start_[k]; }
    double end(std::size_t k) const { return out_[k].to - start_[k]; }

    static std::uint32_t bits(bool b) { return b ? 1u : 0u; }
    template <class Bool>
    static std::uint32_t bits(const Bool& b)
    {
        return lanes::mask(b);
    }
    static double load(double, const double* from) { return *from; }
    static Double load(const Double&, const double* from) { return Double::load_aligned(from); }
    static void store(double v, double* to) { *to = v; }
    static void store(const Double& v, double* to) { v.store_aligned(to); }
    static double root(double v) { return std::sqrt(v); }
    static Double root(const Double& v) { return xsimd::sqrt(v); }
    static double size(double v) { return std::abs(v); }
    static Double size(const Double& v) { return xsimd::abs(v); }

    /// (u^p + v^p)^(1/p) of numbers that are not negative, and its derivatives by both.
    template <class T>
    struct Norm {
        T value, by_u, by_v;

        Norm(const T& u, const T& v, double p)
        {
            using lanes::choose;
            const auto swapped = u < v;
            const T zero(0.0), one(1.0), most = choose(swapped, v, u), least = choose(swapped, u, v);
            const auto some = most > zero;
            const T ratio = choose(some, least / most, zero);
            const auto thin = ratio <= zero;
            const T raised = choose(thin, zero, lanes::power(choose(thin, one, ratio), T(p))), sum = one + raised;
            const T scale = lanes::power(sum, T(1.0 / p));
            value = choose(some, most * scale, zero);
            const T by_most = scale / sum;
            // At 0 the limit: |v| itself where p = 1, flat above.
            const T by_least = choose(thin, T(p == 1.0 ? 1.0 : 0.0), by_most * (raised / ratio));
            by_u = choose(some, choose(swapped, by_least, by_most), zero);
            by_v = choose(some, choose(swapped, by_most, by_least), zero);
        }
    };

    template <class T>
    struct Vector {
        T x, y, z;
    };
    template <class T>
    struct Slope {
        T value, rate;  ///< of the length less 1
    };

    /// The length at p and how it grows along d.
    template <class T>
    Slope<T> slope(const Vector<T>& p, const Vector<T>& d) const
    {
        const T zero(0.0);
        const Norm<T> flat(size(p.x), size(p.y), shape_.across_), whole(flat.value, size(p.z), shape_.along_);
        const auto part = [&](const T& by, const T& at, const T& along) {
            const T grows = lanes::choose(at > zero, along, lanes::choose(at == zero, size(along), -along));
            return lanes::choose(along == zero, zero, by * grows);
        };
        return {whole.value - T(1.0), part(whole.by_u * flat.by_u, p.x, d.x) + part(whole.by_u * flat.by_v, p.y, d.y) +
                                          part(whole.by_v, p.z, d.z)};
    }

    /// The part of each ray in the cube and, as the shape is convex, between planes across its edges and corners. From
    /// the point nearest to the middle, so that the way there does not set the rounding. Returns the rays that have
    /// such a part in their range.
    Set prepare()
    {
        for (std::size_t k = 0; k < rays_.size(); ++k) {
            const Ray& ray = rays_[k];
            ox_[k] = ray.origin.x, oy_[k] = ray.origin.y, oz_[k] = ray.origin.z;
            dx_[k] = ray.direction.x, dy_[k] = ray.direction.y, dz_[k] = ray.direction.z;
        }
        Set met = 0;
        if (rays_.size() == 1) {
            met = clip(0.0, 0);
        } else {
            for (std::size_t k = rays_.size(); k % kWide != 0; ++k)
                ox_[k] = oy_[k] = oz_[k] = dx_[k] = dy_[k] = dz_[k] = 0.0;
            for (std::size_t k = 0; k < rays_.size(); k += kWide) met |= Set{clip(Double(0.0), k)} << k;
        }
        return which(met, [&](std::size_t k) {
            return k < rays_.size() && !(start_[k] + from_[k] > out_[k].to || start_[k] + to_[k] < out_[k].from);
        });
    }

    template <class T>
    std::uint32_t clip(const T& zero, std::size_t k)
    {
        const auto at = [&](const Numbers& from) { return load(zero, from.data() + k); };
        const Vector<T> d{at(dx_), at(dy_), at(dz_)};
        Vector<T> o{at(ox_), at(oy_), at(oz_)};
        const T length = root(d.x * d.x + d.y * d.y + d.z * d.z),
                start = -(o.x * d.x + o.y * d.y + o.z * d.z) / (length * length);
        o = {o.x + start * d.x, o.y + start * d.y, o.z + start * d.z};
        T from(-kInfinity), to(kInfinity);
        const auto cut = [&](const T& origin, const T& direction, double reach) {
            using lanes::choose;
            const T inverse = T(1.0) / direction, a = (T(-reach) - origin) * inverse, b = (T(reach) - origin) * inverse;
            const T near = choose(b < a, b, a), far = choose(a < b, b, a);
            const auto along = direction == zero;
            const T beyond = choose(size(origin) > T(reach), T(-kInfinity), to);
            from = choose(along, from, choose(from < near, near, from));
            to = choose(along, beyond, choose(far < to, far, to));
        };
        cut(o.x, d.x, kClear);
        cut(o.y, d.y, kClear);
        cut(o.z, d.z, kClear);
        if (bits(from < to) == 0) return 0;
        cut(o.x + o.y, d.x + d.y, shape_.edge_);
        cut(o.x - o.y, d.x - d.y, shape_.edge_);
        for (const double side : {1.0, -1.0}) {
            const T z = T(side) * o.z, along = T(side) * d.z;
            cut(o.x + z, d.x + along, shape_.rim_);
            cut(o.y + z, d.y + along, shape_.rim_);
            cut(o.x + o.y + z, d.x + d.y + along, shape_.corner_);
            cut(o.x - o.y + z, d.x - d.y + along, shape_.corner_);
        }
        const auto put = [&](const T& v, Numbers& into) { store(v, into.data() + k); };
        put(o.x, ox_), put(o.y, oy_), put(o.z, oz_), put(start, start_), put(from, from_), put(to, to_);
        return bits(from < to) & bits(size(start) < T(kInfinity));
    }

    /// Leaves out the rays that are outside where their range begins and go away from there, or where it ends and still
    /// come nearer: a convex length meets 1 no more.
    Set leave_out(Set rays) const
    {
        alignas(64) std::array<double, kWide> px, py, pz, dx, dy, dz;
        std::array<std::size_t, kWide> of{};
        std::size_t count = 0;
        const auto ask_all = [&] {
            const auto away = [&](auto zero) {
                using T = decltype(zero);
                const auto at = [&](const std::array<double, kWide>& from) { return load(zero, from.data()); };
                const Slope<T> here = slope<T>({at(px), at(py), at(pz)}, {at(dx), at(dy), at(dz)});
                return bits(here.value > T(kSure)) & bits(here.rate > T(kSure));
            };
            for (std::size_t k = count; k < kWide; ++k) px[k] = py[k] = pz[k] = dx[k] = dy[k] = dz[k] = 0.0;
            const std::uint32_t missed = count == 1 ? away(0.0) : away(Double(0.0));
            for (std::size_t i = 0; i < count; ++i)
                if ((missed >> i & 1u) != 0) rays &= ~(Set{1} << of[i]);
            count = 0;
        };
        const auto ask = [&](std::size_t k, double t, double side) {
            of[count] = k;
            px[count] = ox_[k] + t * dx_[k], py[count] = oy_[k] + t * dy_[k], pz[count] = oz_[k] + t * dz_[k];
            dx[count] = side * dx_[k], dy[count] = side * dy_[k], dz[count] = side * dz_[k];
            if (++count == kWide) ask_all();
        };
        each(which(rays, [&](std::size_t k) { return begin(k) > from_[k]; }),
             [&](std::size_t k) { ask(k, begin(k), 1.0); });
        each(which(rays, [&](std::size_t k) { return end(k) < to_[k]; }), [&](std::size_t k) { ask(k, end(k), -1.0); });
        if (count != 0) ask_all();
        return rays;
    }

    /// Where the rays come in between `from` and `to`, along their directions or against them. Newton from outside
    /// never steps over an entry: the length lies above its tangents. A lane that is through takes the next ray.
    /// Returns the rays that do come in.
    Set newton(Set rays, double way, const Numbers& from, const Numbers& to, Numbers& found) const
    {
        if ((rays & (rays - 1)) == 0) {
            if (rays == 0) return 0;
            const auto k = static_cast<std::size_t>(std::countr_zero(rays));
            return newton_alone(k, way, from[k], to[k], found[k]) ? rays : 0;
        }
        Set met = 0;
        alignas(64) std::array<double, kWide> ox{}, oy{}, oz{}, dx{}, dy{}, dz{}, t{}, end{};
        std::array<std::size_t, kWide> of{};
        std::array<int, kWide> steps{};
        std::uint32_t busy = 0;
        const auto take_next = [&](std::size_t lane) {
            busy &= ~(1u << lane);
            if (rays == 0) return;
            const auto k = static_cast<std::size_t>(std::countr_zero(rays));
            rays &= rays - 1;
            ox[lane] = ox_[k], oy[lane] = oy_[k], oz[lane] = oz_[k];
            dx[lane] = way * dx_[k], dy[lane] = way * dy_[k], dz[lane] = way * dz_[k];
            t[lane] = from[k], end[lane] = to[k], of[lane] = k, steps[lane] = 0;
            busy |= 1u << lane;
        };
        for (std::size_t lane = 0; lane < kWide; ++lane) take_next(lane);
        const auto at = [](const std::array<double, kWide>& numbers) { return Double::load_aligned(numbers.data()); };
        while (busy != 0) {
            const Step<Double> step = next_step(Vector<Double>{at(ox), at(oy), at(oz)},
                                                Vector<Double>{at(dx), at(dy), at(dz)}, at(t), at(end));
            step.t.store_aligned(t.data());
            std::uint32_t through = busy & (step.met | step.missed);
            for (std::size_t lane = 0; lane < kWide; ++lane)
                if (++steps[lane] == kMostSteps) through |= busy & 1u << lane;
            for (; through != 0; through &= through - 1) {
                const auto lane = static_cast<std::size_t>(std::countr_zero(through));
                if ((step.met >> lane & 1u) != 0) {
                    met |= Set{1} << of[lane];
                    found[of[lane]] = t[lane];
                }
                take_next(lane);
            }
        }
        return met;
    }

    /// Rays that come in along their directions, and those that do against them, into in_ and exit_.
    struct Ways {
        Set forth = 0, back = 0;
    };
    /// newton() both ways at once, of few rays: those back in the lanes behind the others.
    Ways both_ways(Set rays)
    {
        alignas(64) std::array<double, kWide> ox{}, oy{}, oz{}, dx{}, dy{}, dz{}, t{}, end{};
        std::array<std::size_t, kWide> of{};
        const auto count = static_cast<std::size_t>(std::popcount(rays));
        std::size_t lane = 0;
        for (const double way : {1.0, -1.0})
            each(rays, [&](std::size_t k) {
                ox[lane] = ox_[k], oy[lane] = oy_[k], oz[lane] = oz_[k];
                dx[lane] = way * dx_[k], dy[lane] = way * dy_[k], dz[lane] = way * dz_[k];
                t[lane] = way > 0.0 ? from_[k] : -to_[k], end[lane] = way > 0.0 ? to_[k] : -from_[k];
                of[lane++] = k;
            });
        const auto at = [](const std::array<double, kWide>& numbers) { return Double::load_aligned(numbers.data()); };
        const Vector<Double> o{at(ox), at(oy), at(oz)}, d{at(dx), at(dy), at(dz)};
        const Double last = at(end);
        std::uint32_t busy = (1u << lane) - 1u;
        Ways met;
        for (int i = 0; i < kMostSteps && busy != 0; ++i) {
            const Step<Double> step = next_step(o, d, at(t), last);
            step.t.store_aligned(t.data());
            for (std::uint32_t found = busy & step.met; found != 0; found &= found - 1) {
                const auto which = static_cast<std::size_t>(std::countr_zero(found));
                const bool forth = which < count;
                (forth ? in_ : exit_)[of[which]] = t[which];
                (forth ? met.forth : met.back) |= Set{1} << of[which];
            }
            busy &= ~(step.met | step.missed);
        }
        return met;
    }

    bool newton_alone(std::size_t k, double way, double from, double to, double& found) const
    {
        const Vector<double> o{ox_[k], oy_[k], oz_[k]}, d{way * dx_[k], way * dy_[k], way * dz_[k]};
        found = from;
        for (int i = 0; i < kMostSteps; ++i) {
            const Step<double> step = next_step(o, d, found, to);
            found = step.t;
            if (step.met != 0) return true;
            if ((step.missed & 1u) != 0) return false;
        }
        return false;
    }

    template <class T>
    struct Step {
        T t;
        std::uint32_t met, missed;
    };
    template <class T>
    Step<T> next_step(const Vector<T>& o, const Vector<T>& d, const T& t, const T& end) const
    {
        const Slope<T> here = slope<T>({o.x + t * d.x, o.y + t * d.y, o.z + t * d.z}, d);
        const auto there = here.value <= T(kRounding);
        const T by = -here.value / here.rate, next = t + by;
        const std::uint32_t inside = bits(there), goes = bits(here.rate < T(0.0)) & bits(next <= end);
        const std::uint32_t close = goes & bits(by * root(d.x * d.x + d.y * d.y + d.z * d.z) < T(kClose));
        return {lanes::choose(there, t, next), inside | close, ~(inside | goes)};
    }

    const Superellipsoid& shape_;
    std::span<const Ray> rays_;
    IntersectionList* out_;
    alignas(64) Numbers ox_, oy_, oz_, dx_, dy_, dz_;  ///< of the rays, from the point nearest to the middle
    alignas(64) Numbers start_;                        ///< of that point in the ray's parameter
    alignas(64) Numbers from_, to_;                    ///< where Newton begins and ends
    Numbers in_, exit_;
};

void Superellipsoid::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    Convex(*this, rays, out).run();
}

bool Superellipsoid::meets_no_more(const Ray& ray, double from, double to) const
{
    return convex_ && Convex(*this, {}, nullptr).meets_no_more(ray, from, to);
}

}  // namespace csg
