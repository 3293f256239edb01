#pragma once

#include "csg/freeform/field/blob_follower.h"
#include "csg/freeform/shared/bernstein_lanes.h"

#include <bit>
#include <cmath>
#include <utility>

/// Rays in lanes through a blob, or the part of one, that has no more than so many components. Most rays end where the
/// stretches are known that they have in each one's reach; the others are followed one by one.
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
    using Points = lanes::Points;
    using Numbers = std::array<double, kWide>;
    struct alignas(64) AlignedNumbers : Numbers {};

    /// A stretch of each lane that is in `lanes`.
    struct Laid {
        alignas(64) Numbers enter, leave, ref, w0, w1, w2, most;
        double strength;
        std::uint32_t lanes;
    };

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
        const Points origin{of(o[0]), of(o[1]), of(o[2])};
        inverse_ = Double(1.0) / lanes::dot(direction_, direction_);
        const Double start = lanes::negated(lanes::dot(lanes::difference(origin, blob_.middle_), direction_)) *
                             inverse_;
        origin_ = lanes::advanced(origin, start, direction_);
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
        const Chord<Points> chord(lanes::difference(origin_, field.middle), direction_, inverse_, from_, to_,
                                  Double(field.reach2));
        const std::uint32_t met = started_ & lanes::mask(chord.meets);
        if (met == 0) return;
        if (field.is_sphere) return keep(field, met, chord.course(field, inverse_), chord.ref);
        capsule(field, met);
    }

    void capsule(const Field& field, std::uint32_t met)
    {
        const Points u = field.unit(origin_), d = lanes::times(field.to_unit, direction_);
        if (field.length == 0.0) return slice(field, met, u, d, lanes::before(), lanes::beyond());
        // Along a slice the ray has one part, found elsewhere.
        const std::uint32_t level = met & lanes::mask(d.z == Double(0.0));
        alone_ |= level;
        met &= ~level;
        each_slice(field, u, d, [&](const Points& o, const Points& v, const Double& low, const Double& high) {
            slice(field, met, o, v, low, high);
        });
    }

    void slice(const Field& field, std::uint32_t met, const Points& o, const Points& v, const Double& low,
               const Double& high)
    {
        Course<Double> course;
        Double top;
        met &= lanes::mask(in_unit_sphere(o, v, low, high, from_, to_, top, course));
        if (met != 0) keep(field, met, course, top);
    }

    void keep(const Field& field, std::uint32_t met, const Course<Double>& course, const Double& top)
    {
        Laid& laid = laid_[count_++];
        const Double most = course.most(field.strength, top, from_, to_);
        most_ = most_ + xsimd::select(lanes::lanes_of(met), most, Double(0.0));
        course.enter.store_aligned(laid.enter.data());
        course.leave.store_aligned(laid.leave.data());
        course.ref.store_aligned(laid.ref.data());
        course.w0.store_aligned(laid.w0.data());
        course.w1.store_aligned(laid.w1.data());
        course.w2.store_aligned(laid.w2.data());
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
            walk.stretches[walk.stretch_count++] = {
                {s.enter[lane], s.leave[lane], s.ref[lane], s.w0[lane], s.w1[lane], s.w2[lane]},
                s.strength,
                s.most[lane]};
        }
        return walk;
    }

    const Blob& blob_;
    Points origin_, direction_;  ///< origins are moved to where the rays are nearest to the blob
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
