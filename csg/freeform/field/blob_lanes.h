#pragma once

#include "numbers/lanes.h"
#include "csg/freeform/shared/bernstein_lanes.h"
#include "csg/freeform/field/blob_follower.h"

#include <bit>
#include <cmath>
#include <utility>

/// Rays in lanes through a blob, or the part of one, that has no more than so many components: the stretches that they
/// have in each one's reach come from the same operations in the same order as in blob_ray.cpp. Most rays end there;
/// the others are followed one by one.
namespace csg {

template <std::size_t components>
class Blob::Lanes {
public:
    static constexpr std::size_t kWide = static_cast<std::size_t>(lanes::kDoubles);

    explicit Lanes(const Blob& blob) : blob_(blob) {}

    /// kWide rays at most.
    void run(std::span<const Ray> rays, IntersectionList* out)
    {
        load(rays, out);
        if (!gather(rays.size(), out)) {
            for (std::size_t lane = 0; lane < rays.size(); ++lane) blob_.intersect(rays[lane], out[lane]);
            return;
        }
        // As follow() asks: no sum of fields reaches the threshold.
        const double threshold = blob_.threshold_;
        std::uint32_t left = started_ & ~alone_;
        if (threshold >= 0.0) left &= ~lanes::mask(most_ < Double(threshold));
        follow(left, out);
        each(alone_, [&](std::size_t lane) { blob_.intersect(rays[lane], out[lane]); });
    }

private:
    using Double = lanes::Double;
    using Bool = Double::batch_bool_type;
    using Numbers = std::array<double, kWide>;
    struct alignas(64) AlignedNumbers : Numbers {};

    struct Vector {
        Double x, y, z;

        friend Double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    };
    /// A stretch of each lane that is in `lanes`.
    struct Laid {
        alignas(64) Numbers enter, leave, ref, w0, w1, w2, most;
        double strength;
        std::uint32_t lanes;
    };

    // What std::max(a, b), std::min(a, b) and a minus are, numbers that are none and signs of zero included.
    static Double larger(const Double& a, const Double& b) { return xsimd::select(a < b, b, a); }
    static Double smaller(const Double& a, const Double& b) { return xsimd::select(b < a, b, a); }
    static Double minus(const Double& a) { return a ^ Double(-0.0); }
    static Double finite_or(const Double& a, const Double& other)
    {
        return xsimd::select(xsimd::abs(a) < Double(kInfinity), a, other);
    }
    static Vector times(const glm::dmat3& m, const Vector& v)
    {
        const auto row = [&](int i) { return Double(m[0][i]) * v.x + Double(m[1][i]) * v.y + Double(m[2][i]) * v.z; };
        return {row(0), row(1), row(2)};
    }

    void load(std::span<const Ray> rays, const IntersectionList* out)
    {
        alignas(64) Numbers o[3], d[3], from, to;
        for (std::size_t lane = 0; lane < kWide; ++lane) {
            const std::size_t k = std::min(lane, rays.size() - 1);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                o[axis][lane] = rays[k].origin[static_cast<int>(axis)];
                d[axis][lane] = rays[k].direction[static_cast<int>(axis)];
            }
            from[lane] = out[k].from;
            to[lane] = out[k].to;
        }
        const auto of = [](const Numbers& n) { return Double::load_aligned(n.data()); };
        direction_ = {of(d[0]), of(d[1]), of(d[2])};
        const Vector origin{of(o[0]), of(o[1]), of(o[2])};
        const glm::dvec3& m = blob_.middle_;
        inverse_ = Double(1.0) / dot(direction_, direction_);
        const Vector way{origin.x - Double(m.x), origin.y - Double(m.y), origin.z - Double(m.z)};
        const Double start = minus(dot(way, direction_)) * inverse_;
        origin_ = {origin.x + start * direction_.x, origin.y + start * direction_.y, origin.z + start * direction_.z};
        from_ = of(from) - start;
        to_ = of(to) - start;
        start.store_aligned(start_.data());
        started_ = lanes::mask(xsimd::abs(start) < Double(kInfinity)) & ((1u << rays.size()) - 1);
        alone_ = 0;
        most_ = Double(0.0);
        count_ = 0;
    }

    /// False: there are more components than there is room for.
    bool gather(std::size_t count, const IntersectionList* out)
    {
        if (blob_.tree_.nodes.empty()) {
            for (const Field& field : blob_.fields_) gather(field);
            return true;
        }
        static_assert(kWide <= kMostTogether);
        alignas(64) Numbers o[3], d[3];
        const Double *from[] = {&origin_.x, &origin_.y, &origin_.z},
                     *way[] = {&direction_.x, &direction_.y, &direction_.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            from[axis]->store_aligned(o[axis].data());
            way[axis]->store_aligned(d[axis].data());
        }
        std::array<Part, kWide> parts;
        std::size_t known = 0;
        for (std::size_t lane = 0; lane < count; ++lane)
            if ((started_ >> lane & 1u) != 0)
                parts[known++] = {{{o[0][lane], o[1][lane], o[2][lane]}, {d[0][lane], d[1][lane], d[2][lane]}},
                                  out[lane].from - start_[lane],
                                  out[lane].to - start_[lane]};
        thread_local std::vector<std::uint32_t> near;
        blob_.find_near({parts.data(), known}, near);
        if (near.size() > components) return false;
        for (const std::uint32_t component : near) gather(blob_.fields_[component]);
        return true;
    }

    void gather(const Field& field)
    {
        // Blob::Chord
        const glm::dvec3& c = field.middle;
        Vector foot{origin_.x - Double(c.x), origin_.y - Double(c.y), origin_.z - Double(c.z)};
        const Double ref = minus(dot(foot, direction_)) * inverse_;
        foot = {foot.x + ref * direction_.x, foot.y + ref * direction_.y, foot.z + ref * direction_.z};
        const Double zero(0.0), inside2 = Double(field.reach2) - dot(foot, foot);
        const Bool in = inside2 > zero;
        const Double half = xsimd::sqrt(xsimd::select(in, inside2 * inverse_, zero));
        const Bool beside = (ref + half < from_) | (ref - half > to_);
        const std::uint32_t met = started_ & lanes::mask(in) & ~lanes::mask(beside);
        if (met == 0) return;
        if (!field.is_sphere) return capsule(field, met);
        const double scale = 1.0 / field.reach2;
        keep(field, met, ref,
             {ref - half, ref + half, ref, inside2 * Double(scale), Double(-2.0 * scale) * dot(foot, direction_),
              Double(-scale) / inverse_});
    }

    void capsule(const Field& field, std::uint32_t met)
    {
        Vector u = times(field.to_unit, origin_);
        u = {u.x + Double(field.offset.x), u.y + Double(field.offset.y), u.z + Double(field.offset.z)};
        const Vector d = times(field.to_unit, direction_);
        const Double zero(0.0), least(-kInfinity), most(kInfinity);
        if (field.length == 0.0) return part(field, met, u, d, least, most);
        // Along a slice the ray has one part, found elsewhere.
        const std::uint32_t level = met & lanes::mask(d.z == zero);
        alone_ |= level;
        met &= ~level;
        const Double upper_z = u.z - Double(field.length), at_low = minus(u.z) / d.z, at_high = minus(upper_z) / d.z;
        const Bool up = d.z > zero;
        part(field, met, {u.x, u.y, xsimd::select(up, u.z, upper_z)}, d, least, xsimd::select(up, at_low, at_high));
        part(field, met, {u.x, u.y, zero}, {d.x, d.y, zero}, smaller(at_low, at_high), larger(at_low, at_high));
        part(field, met, {u.x, u.y, xsimd::select(up, upper_z, u.z)}, d, xsimd::select(up, at_high, at_low), most);
    }

    /// The stretch of lines o + t v in the unit sphere between `low` and `high`.
    void part(const Field& field, std::uint32_t met, const Vector& o, const Vector& v, Double low, Double high)
    {
        const auto in_range = [&] { return (low < high) & !(high < from_) & !(low > to_); };
        met &= lanes::mask(in_range());
        if (met == 0) return;
        const Double zero(0.0), a = dot(v, v);
        const Double nearest = finite_or(xsimd::select(a > zero, minus(dot(o, v)) / a, zero), zero);
        const Double ref = smaller(larger(nearest, finite_or(low, nearest)), finite_or(high, nearest));
        const Vector foot{o.x + ref * v.x, o.y + ref * v.y, o.z + ref * v.z};
        const Double w0 = Double(1.0) - dot(foot, foot), half = minus(dot(foot, v));
        const Double discriminant = half * half + a * w0;
        const Bool crosses = discriminant > zero;
        met &= lanes::mask(crosses | ((a == zero) & (w0 > zero)));
        if (met == 0) return;
        const Double root = xsimd::sqrt(xsimd::select(crosses, discriminant, zero));
        const Double q = half + (root | (half & Double(-0.0)));
        const Double s1 = q / a, s2 = minus(w0) / q;
        const Bool ends = crosses & (a > zero);
        low = larger(xsimd::select(ends, larger(low, ref + smaller(s1, s2)), low), Double(-1e300));
        high = smaller(xsimd::select(ends, smaller(high, ref + larger(s1, s2)), high), Double(1e300));
        met &= lanes::mask(in_range());
        if (met == 0) return;
        keep(field, met, nearest, {low, high, ref, w0, Double(2.0) * half, minus(a)});
    }

    /// enter, leave, ref, w0, w1, w2 of a stretch, and the vertex of its field.
    void keep(const Field& field, std::uint32_t met, const Double& top, const std::array<Double, 6>& s)
    {
        Laid& laid = laid_[count_++];
        Double most(kRounding * std::abs(field.strength));
        if (field.strength > 0.0) {
            const Double at = smaller(larger(smaller(larger(top, s[0]), s[1]), from_), to_) - s[2];
            const Double w = s[3] + at * (s[4] + at * s[5]);
            most = most + Double(field.strength) * w * w;
        }
        most_ = most_ + xsimd::select(lanes::lanes_of(met), most, Double(0.0));
        Numbers* to[] = {&laid.enter, &laid.leave, &laid.ref, &laid.w0, &laid.w1, &laid.w2};
        for (std::size_t i = 0; i < s.size(); ++i) s[i].store_aligned(to[i]->data());
        most.store_aligned(laid.most.data());
        laid.strength = field.strength;
        laid.lanes = met;
    }

    template <class F>
    static void each(std::uint32_t lanes, F&& f)
    {
        for (; lanes != 0; lanes &= lanes - 1) f(static_cast<std::size_t>(std::countr_zero(lanes)));
    }

    void follow(std::uint32_t left, IntersectionList* out)
    {
        std::uint32_t asking = 0;
        const auto go_on = [&](std::size_t lane) {
            if (!followers_[lane].next()) return;
            asking |= 1u << lane;
            for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i][lane] = followers_[lane].sum()[i];
        };
        each(left, [&](std::size_t lane) {
            followers_[lane] = {blob_.threshold_, walk(lane), start_[lane], out[lane]};
            go_on(lane);
        });
        while (asking != 0) {
            std::array<Double, 5> sums;
            for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = Double::load_aligned(sums_[i].data());
            alignas(64) Numbers places;
            lanes::only_changes(sums, asking).store_aligned(places.data());
            each(std::exchange(asking, 0), [&](std::size_t lane) {
                followers_[lane].found(places[lane]);
                go_on(lane);
            });
        }
    }

    Walk walk(std::size_t lane)
    {
        Walk walk = rooms_[lane].walk();
        for (std::size_t i = 0; i < count_; ++i) {
            const Laid& s = laid_[i];
            if ((s.lanes >> lane & 1u) == 0) continue;
            walk.stretches[walk.stretch_count++] = {s.enter[lane], s.leave[lane], s.ref[lane], s.w0[lane],
                                                    s.w1[lane],    s.w2[lane],    s.strength,  s.most[lane]};
        }
        return walk;
    }

    const Blob& blob_;
    Vector origin_, direction_;  ///< origins are moved to where the rays are nearest to the blob
    Double inverse_, from_, to_, most_;
    alignas(64) Numbers start_;
    std::uint32_t started_ = 0;  ///< lanes with a ray
    std::uint32_t alone_ = 0;    ///< of these, rays that are asked for one by one
    std::size_t count_ = 0;
    std::array<Laid, Walk::kStretches * components> laid_;
    std::array<WalkRoom<components>, kWide> rooms_;
    std::array<Follower, kWide> followers_;
    std::array<AlignedNumbers, 5> sums_{};  ///< of followers that ask
};

}  // namespace csg
