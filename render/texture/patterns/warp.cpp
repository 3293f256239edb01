#include "numbers/functions/functions.h"
#include "render/texture/points/angle.h"
#include "numbers/lanes.h"
#include "numbers/rounding.h"
#include "render/texture/evaluate_points.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/noise_points.h"
#include "render/texture/points/point_lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace texture {
namespace {

constexpr double kFarthest = 1e17;  // coordinates are held within this after warping

/// A point, or a point a lane (T: a number or vector lanes).
template <class T>
struct Place {
    T x, y, z;
};

template <class T>
Place<T> orient(const T& a, const T& b, const T& c, const glm::dvec3& o)
{
    if (o == glm::dvec3(0, 0, 1)) return {a, b, c};
    return {o.x * c + o.y * a + o.z * a, o.x * b - o.y * c + o.z * b, -o.x * a + o.y * b + o.z * c};
}

template <class T>
T stretched(const T& value, const T& length, double exponent)
{
    return exponent == 0.0 ? value : value * numbers::pow(length, T(exponent));
}

/// `to`, but where `length` is 0 the point stays as it is.
template <class T>
Place<T> unless_zero(const T& length, const Place<T>& p, const Place<T>& to)
{
    const numbers::lanes::Truth<T> stays = length == T(0.0);
    return {numbers::lanes::choose(stays, p.x, to.x), numbers::lanes::choose(stays, p.y, to.y),
            numbers::lanes::choose(stays, p.z, to.z)};
}

template <class T>
Place<T> to_cylindrical(const scene::MappingWarp& w, const Place<T>& p)
{
    const T l = numbers::lanes::root_of(p.x * p.x + p.z * p.z);
    return unless_zero(l, p, orient(stretched(turn(p.x, p.z), l, w.dist_exp), p.y, l, w.orientation));
}

template <class T>
Place<T> to_spherical(const scene::MappingWarp& w, const Place<T>& p)
{
    const T zero(0.0), d = numbers::lanes::root_of(p.x * p.x + p.y * p.y + p.z * p.z);
    const T latitude = T(0.5) + numbers::asin(p.y / d) / T(std::numbers::pi);
    const numbers::lanes::Truth<T> on_x = p.x == zero, on_z = p.z == zero;
    const T theta = numbers::lanes::choose(on_x & on_z, zero, turn(p.x, p.z));
    return unless_zero(d, p,
                       orient(stretched(theta, d, w.dist_exp), stretched(latitude, d, w.dist_exp), d, w.orientation));
}

template <class T>
Place<T> to_toroidal(const scene::MappingWarp& w, const Place<T>& p)
{
    const T l = numbers::lanes::root_of(p.x * p.x + p.z * p.z), x = l - T(w.major_radius);
    const T r = numbers::lanes::root_of(x * x + p.y * p.y);
    const T below = numbers::acos(numbers::lanes::negated(x) / r) / T(kTau);
    const T around = numbers::lanes::choose(p.y > T(0.0), T(1.0) - below, below), theta = turn(p.x, p.z);
    return unless_zero(l, p,
                       orient(stretched(theta, r, w.dist_exp), stretched(around, r, w.dist_exp), r, w.orientation));
}

/// All but the cube.
template <class T>
Place<T> mapped(const scene::MappingWarp& w, const Place<T>& p)
{
    using Kind = scene::MappingWarp::Kind;
    switch (w.kind) {
    case Kind::Planar: return orient(p.x, p.y, T(w.distance), w.orientation);
    case Kind::Cylindrical: return to_cylindrical(w, p);
    case Kind::Spherical: return to_spherical(w, p);
    case Kind::Toroidal: return to_toroidal(w, p);
    case Kind::Cubic: break;
    }
    return p;
}

/// The unfolded cube: four sides in a row, top and bottom at the second.
glm::dvec3 to_cubic(const glm::dvec3& p)
{
    constexpr double kThird = 1.0 / 3.0;
    const glm::dvec3 a = glm::abs(p);
    const auto half = [](double v) { return (v + 1.0) / 2.0; };
    const auto eighth = [](double v) { return (v + 1.0) / 8.0; };
    if (p.x >= a.y && p.x >= a.z) return {0.75 - eighth(p.z / p.x), kThird + kThird * half(p.y / p.x), p.x};
    if (p.y >= a.x && p.y >= a.z) return {0.25 + eighth(p.x / p.y), 1.0 - kThird * half(p.z / p.y), p.y};
    if (p.z >= a.x && p.z >= a.y) return {0.25 + eighth(p.x / p.z), kThird + kThird * half(p.y / p.z), p.z};
    if (a.x >= a.y && a.x >= a.z) return {eighth(p.z / a.x), kThird + kThird * half(p.y / a.x), a.x};
    if (a.y >= a.x && a.y >= a.z) return {0.25 + eighth(p.x / a.y), kThird * half(p.z / a.y), a.y};
    return {1.0 - eighth(p.x / a.z), kThird + kThird * half(p.y / a.z), a.z};
}

struct Apply {
    glm::dvec3 p;

    glm::dvec3 operator()(const Affine& t) const { return t.linear * p + t.offset; }

    glm::dvec3 operator()(const scene::Turbulence& t) const
    {
        return p + t.amount * vector_turbulence(p, t.octaves, t.lambda, t.omega);
    }

    glm::dvec3 operator()(const scene::RepeatWarp& w) const
    {
        const int axis = w.width.x != 0.0 ? 0 : w.width.y != 0.0 ? 1 : 2;
        const auto width = static_cast<float>(w.width[axis]);
        if (width == 0.0f) return p;
        // Block number and its product with the width are single precision in POV-Ray.
        const auto block = static_cast<float>(std::floor(p[axis] / static_cast<double>(width)));
        glm::dvec3 q = p;
        q[axis] -= static_cast<double>(block * width);
        if (std::fmod(std::abs(block), 2.0f) == 1.0f) {
            for (int k = 0; k < 3; ++k)
                if (w.flip[k] != 0.0) q[k] = -q[k];
            if (w.flip[axis] != 0.0) q[axis] += static_cast<double>(width);
        }
        return q + static_cast<double>(block) * w.offset;
    }

    glm::dvec3 operator()(const scene::BlackHoleWarp& w) const
    {
        glm::dvec3 center = w.center;
        if (w.repeat != glm::dvec3(0)) {
            glm::dvec3 block(0);
            for (int k = 0; k < 3; ++k)
                if (w.repeat[k] >= kTiny) block[k] = std::floor(p[k] / w.repeat[k]);
            if (w.turbulence != glm::dvec3(0)) {
                const int seed = cell_hash(numbers::truncated_far(block.x), numbers::truncated_far(block.y),
                                           numbers::truncated_far(block.z));
                for (int k = 0; k < 3; ++k) center[k] += pattern_random(seed + k) * w.turbulence[k];
            }
            center += w.repeat * block;
        }
        const glm::dvec3 delta = p - center;
        const double square = glm::dot(delta, delta);
        if (square > WarpReach::hole_reach(w)) return p;  // most points are, and need no square root
        const double distance = std::sqrt(square);
        if (distance >= w.radius) return p;
        const double pull = std::min(1.0, w.strength * numbers::pow((w.radius - distance) / w.radius, w.falloff));
        return w.inverse ? p - pull * delta : p + pull * delta;
    }

    glm::dvec3 operator()(const scene::MappingWarp& w) const
    {
        if (w.kind == scene::MappingWarp::Kind::Cubic) return to_cubic(p);
        const Place<double> to = mapped(w, Place<double>{p.x, p.y, p.z});
        return {to.x, to.y, to.z};
    }
};

/// Within what cells can be numbered.
inline Double held(const Double& v)
{
    const Double least(-kFarthest), most(kFarthest), from_below = xsimd::select(v < least, least, v);
    return xsimd::select(most < from_below, most, from_below);
}

void hold(Values& v, std::size_t count)
{
    for (std::size_t i = 0; i < count; i += numbers::lanes::kDoubles) held(get(v, i)).store_aligned(v.data() + i);
}

/// A warp over many points.
struct ApplyToAll {
    Points& p;
    unsigned live;  ///< of turbulence

    /// False where some point is so far out that sums of noise may overflow: NaN times 0 is NaN.
    bool near() const
    {
        constexpr double kFar = 1e9;
        bool all = true;
        for (std::size_t i = 0; i < p.size(); ++i)
            all &= std::abs(p.x[i]) < kFar && std::abs(p.y[i]) < kFar && std::abs(p.z[i]) < kFar;
        return all;
    }

    void operator()(const Affine& t) const
    {
        transform(t, [](const Double& v) { return v; });
    }

    /// The points moved, then f of each coordinate.
    template <class F>
    void transform(const Affine& t, F&& f) const
    {
        struct Row {
            Double x, y, z, offset;
            Row(const Affine& t, int k) : x(t.linear[0][k]), y(t.linear[1][k]), z(t.linear[2][k]), offset(t.offset[k])
            {}
        };
        // Copies: the compiler can't know that points are not written over the matrix.
        const Row rows[3] = {Row(t, 0), Row(t, 1), Row(t, 2)};
        for (std::size_t i = 0; i < p.size(); i += numbers::lanes::kDoubles) {
            const Double x = get(p.x, i), y = get(p.y, i), z = get(p.z, i);
            const auto at = [&](const Row& row) { return f(row.x * x + row.y * y + row.z * z + row.offset); };
            const Double a = at(rows[0]), b = at(rows[1]), c = at(rows[2]);
            a.store_aligned(p.x.data() + i);
            b.store_aligned(p.y.data() + i);
            c.store_aligned(p.z.data() + i);
        }
    }

    void operator()(const scene::Turbulence& t) const
    {
        unsigned moved = 0;
        for (int k = 0; k < 3; ++k)
            if (t.amount[k] != 0.0) moved |= 1u << k;
        moved &= live;
        if (!near()) moved = kAllLive;
        if (moved == 0) return;
        Points d;
        vector_turbulence_points(p, t.octaves, t.lambda, t.omega, moved, d);
        const auto move = [&](unsigned bit, Values& to, const Values& by, double amount) {
            if ((moved & bit) != 0)
                for (std::size_t i = 0; i < p.size(); ++i) to[i] += amount * by[i];
        };
        move(1, p.x, d.x, t.amount.x);
        move(2, p.y, d.y, t.amount.y);
        move(4, p.z, d.z, t.amount.z);
        p.pad();
    }

    void operator()(const scene::BlackHoleWarp& w) const
    {
        if (w.repeat != glm::dvec3(0)) return one_by_one(w);
        const Double x(w.center.x), y(w.center.y), z(w.center.z), far(WarpReach::hole_reach(w));
        for (std::size_t i = 0; i < p.size(); i += numbers::lanes::kDoubles) {
            const Double dx = get(p.x, i) - x, dy = get(p.y, i) - y, dz = get(p.z, i) - z;
            const auto out = dx * dx + dy * dy + dz * dz > far;
            if (xsimd::all(out)) continue;
            for (std::size_t k = i; k < std::min(i + numbers::lanes::kDoubles, p.size()); ++k)
                p.set(k, Apply{p.at(k)}(w));
        }
        p.pad();
    }

    void operator()(const scene::MappingWarp& w) const
    {
        if (w.kind == scene::MappingWarp::Kind::Cubic) return one_by_one(w);
        for (std::size_t i = 0; i < p.size(); i += numbers::lanes::kDoubles) {
            const Place<Double> to = mapped(w, Place<Double>{get(p.x, i), get(p.y, i), get(p.z, i)});
            to.x.store_aligned(p.x.data() + i);
            to.y.store_aligned(p.y.data() + i);
            to.z.store_aligned(p.z.data() + i);
        }
    }

    template <class Other>
    void operator()(const Other& warp) const
    {
        one_by_one(warp);
    }

private:
    template <class Other>
    void one_by_one(const Other& warp) const
    {
        for (std::size_t i = 0; i < p.size(); ++i) p.set(i, Apply{p.at(i)}(warp));
        p.pad();
    }
};

/// The box around points; around everything if one is not finite.
struct PointBox {
    glm::dvec3 lower, upper;

    explicit PointBox(const Points& p)
    {
        Double size(0.0);
        const auto range = [&](const Values& v, double& low, double& high) {
            Double least = get(v, 0), most = least;
            for (std::size_t i = 0; i < p.size(); i += numbers::lanes::kDoubles) {
                const Double own = get(v, i);
                least = xsimd::min(least, own), most = xsimd::max(most, own);
                size = size + xsimd::abs(own);
            }
            alignas(64) std::array<double, numbers::lanes::kDoubles> lows, highs;
            least.store_aligned(lows.data()), most.store_aligned(highs.data());
            low = *std::min_element(lows.begin(), lows.end()), high = *std::max_element(highs.begin(), highs.end());
        };
        range(p.x, lower.x, upper.x);
        range(p.y, lower.y, upper.y);
        range(p.z, lower.z, upper.z);
        if (xsimd::all(size < Double(numbers::kInfinity))) return;
        lower = glm::dvec3(-numbers::kInfinity), upper = glm::dvec3(numbers::kInfinity);
    }
};

/// The first warp of [i, end) that may move something of the box. The box is no farther from a hole than its points are
/// by the same roundings.
std::uint32_t next_near(const WarpReach& reach, std::uint32_t i, std::uint32_t end, const PointBox& box)
{
    constexpr auto kLanes = static_cast<std::uint32_t>(numbers::lanes::kDoubles);
    const Double zero(0.0);
    const auto apart = [&](const std::vector<double>& centers, std::size_t from, double low, double high) {
        const Double center = Double::load_unaligned(centers.data() + from),
                     d = xsimd::max(zero, xsimd::max(Double(low) - center, center - Double(high)));
        return d * d;
    };
    for (; i + kLanes <= end; i += kLanes) {
        const Double square = apart(reach.x, i, box.lower.x, box.upper.x) +
                              apart(reach.y, i, box.lower.y, box.upper.y) + apart(reach.z, i, box.lower.z, box.upper.z);
        const std::uint32_t misses = numbers::lanes::mask(square > Double::load_unaligned(reach.far.data() + i));
        if (misses != (1u << kLanes) - 1) return i + static_cast<std::uint32_t>(std::countr_one(misses));
    }
    return i;
}

}  // namespace

void warp_points(const TextureSet& set, const Pattern& pattern, Points& p, unsigned live)
{
    constexpr std::uint32_t kMany = 16;  // warps left, for a look at several at once
    for (std::uint32_t i = 0; i < pattern.warp_count; ++i) {
        if (i + kMany <= pattern.warp_count && set.reach.far[pattern.first_warp + i] < numbers::kInfinity) {
            const std::uint32_t first = pattern.first_warp;
            i = next_near(set.reach, first + i, first + pattern.warp_count, PointBox(p)) - first;
            if (i == pattern.warp_count) break;
        }
        const bool last = i + 1 == pattern.warp_count && !pattern.displaces;
        const Warp& warp = set.warps[pattern.first_warp + i];
        if (const auto* affine = last ? std::get_if<Affine>(&warp) : nullptr)
            return ApplyToAll{p, live}.transform(*affine, held);
        std::visit(ApplyToAll{p, last ? live : kAllLive}, warp);
    }
    if (pattern.displaces) ApplyToAll{p, live}(pattern.turbulence);
    hold(p.x, p.size());
    hold(p.y, p.size());
    hold(p.z, p.size());
}

glm::dvec3 warp_point(const TextureSet& set, const Pattern& pattern, const glm::dvec3& p)
{
    glm::dvec3 q = p;
    for (std::uint32_t i = 0; i < pattern.warp_count; ++i) q = std::visit(Apply{q}, set.warps[pattern.first_warp + i]);
    if (pattern.displaces) q = Apply{q}(pattern.turbulence);
    return glm::clamp(q, glm::dvec3(-kFarthest), glm::dvec3(kFarthest));
}

}  // namespace texture
