#pragma once

#include "csg/base/lanes.h"
#include "render/trace/photon/near_photons.h"
#include "render/trace/photon/photon_places.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace trace {

/// The nearest photons around a point (spec 6, 3.7). POV-Ray goes from photon to photon and keeps a heap; here those of
/// small subtrees, or of a sphere that serves several points, are looked at in lanes, and the nearest are parted from
/// the others when there are many. The answer is the same, but for photons on the wrong side of a node: whether POV-Ray
/// finds them depends on when it comes there, and here they are found if they are in reach at first. (One photon more
/// in one search of thirty, where each has more photons than it keeps.) \tparam kFlat  the sphere is flattened off a
/// surface
template <bool kFlat>
class PhotonSearch {
public:
    PhotonSearch(const PhotonPlaces& places, const glm::dvec3& point, const glm::dvec3& normal, int most)
        : places_(places), point_(point), normal_(normal), most_(static_cast<std::size_t>(std::max(most, 1)))
    {}

    void find(double radius, NearPhotons& out)
    {
        all_ = radius * radius;
        out.found.resize(2 * room());
        found_ = out.found.data();
        out.radius2 = all_;
        // One more than asked for, to know whether there are any.
        constexpr double kWider = 1.25, kFarther = 3.0;
        const bool known = out.likely2 > 0.0;
        for (double bound = known ? kWider * out.likely2 : all_;; bound *= kFarther) {
            const double here = std::min(bound, all_);
            if (known && covers(out.vicinity, here)) scan(out.vicinity, here);
            else collect(here);
            if (count_ > most_ || here == all_) break;
        }
        out.likely2 = all_;
        if (count_ > most_) {
            part();
            out.likely2 = bound_;
            if (nearest_come_first()) walk_in_order();
            double farthest = 0.0;
            for (std::size_t k = 0; k < most_; ++k)
                if (found_[k].distance2 >= static_cast<float>(bound_)) farthest = std::max(farthest, exact(found_[k]));
            out.radius2 = farthest;
            count_ = most_;
        }
        out.found.resize(count_);
    }

    /// POV-Ray's own way, whatever it costs.
    void find_in_order(double radius, NearPhotons& out)
    {
        all_ = radius * radius;
        out.found.resize(2 * room());
        found_ = out.found.data();
        walk_in_order();
        out.radius2 = bound_;
        out.found.resize(count_);
    }

private:
    using Near = NearPhotons::Near;
    static constexpr double kFlattening = 16.0;
    static constexpr double kRounding = 1.0 + 1e-6;  ///< of what is kept in single precision
    static constexpr std::size_t kLanes = 8;         ///< photons looked at together
    static constexpr std::size_t kSmall = 24;        ///< subtrees up to so many are not walked
    static constexpr std::size_t kSpare = 256;  ///< so many more than are asked for are kept before they are parted

    /// The most_ nearest come first; bound_: the farthest of them. Counted by distance first, which needs no guesses of
    /// the processor: only what lies about where they part is compared.
    void part()
    {
        constexpr std::size_t kBins = 64;
        const float scale = static_cast<float>(static_cast<double>(kBins) / bound_);
        const auto bin = [scale](const Near& near) {
            return static_cast<std::size_t>(std::min(near.distance2 * scale, static_cast<float>(kBins - 1)));
        };
        std::array<std::uint32_t, kBins> count{};
        for (std::size_t k = 0; k < count_; ++k) ++count[bin(found_[k])];
        std::size_t about = 0;
        for (std::size_t sum = count[0]; sum < most_; sum += count[++about]) {}
        Near* const others = found_ + room();
        std::size_t first = 0, rest = 0;
        for (std::size_t k = 0; k < count_; ++k) {
            const Near near = found_[k];
            const bool nearer = bin(near) < about;
            found_[first] = near;
            others[rest] = near;
            first += nearer ? 1 : 0;
            rest += nearer ? 0 : 1;
        }
        std::nth_element(others, others + (most_ - 1 - first), others + rest,
                         [](const Near& a, const Near& b) { return a.distance2 < b.distance2; });
        std::copy_n(others, rest, found_ + first);
        bound_ = static_cast<double>(found_[most_ - 1].distance2);
    }
    std::size_t room() const { return most_ + kSpare + kLanes; }
    double exact(const Near& near) const { return distance2(near.photon); }

    double distance2(double dx, double dy, double dz) const
    {
        const double d2 = dx * dx + dy * dy + dz * dz;
        if constexpr (!kFlat) return d2;
        return d2 * (1.0 + kFlattening * std::abs(normal_.x * dx + normal_.y * dy + normal_.z * dz));
    }
    double distance2(std::size_t i) const
    {
        return distance2(static_cast<double>(places_.x[i]) - point_.x, static_cast<double>(places_.y[i]) - point_.y,
                         static_cast<double>(places_.z[i]) - point_.z);
    }

    /// Whether POV-Ray comes to a photon that lies in reach.
    bool reached(std::uint32_t photon) const
    {
        const PhotonPlaces::Gates& gates = places_.gates[photon];
        if (gates.first == PhotonPlaces::kNoGate) return true;
        return passes(photon, gates.first) && (gates.second == PhotonPlaces::kNoGate || passes(photon, gates.second));
    }
    bool passes(std::uint32_t photon, std::uint32_t gate) const
    {
        const double off = places_.along(gate, places_.axis[gate]) - point_[places_.axis[gate]];
        const bool beyond = photon < gate ? !(off > 0.0) : off > 0.0;
        return !beyond || off * off < all_;
    }
    /// Whether the vicinity holds all that is nearer than the bound; it is made anew where it does not.
    bool covers(PhotonVicinity& vicinity, double bound)
    {
        constexpr double kSpareReach =
            1.35;  // shares of the radius: a wider one serves more points and holds more photons
        constexpr std::size_t kMostHeld = 2048;
        const double radius = std::sqrt(bound);
        if (glm::distance(point_, vicinity.center) + radius <= vicinity.reach) return true;
        vicinity.center = point_;
        vicinity.reach = kSpareReach * radius;
        vicinity.x.clear();
        vicinity.y.clear();
        vicinity.z.clear();
        vicinity.photon.clear();
        const double reach2 = vicinity.reach * vicinity.reach;
        walk([&] { return vicinity.photon.size() > kMostHeld ? 0.0 : reach2; },
             [&](std::size_t first, std::size_t end) {
                 for (std::size_t i = first; i < end; ++i) {
                     const glm::dvec3 off = offset(i);
                     if (!(glm::dot(off, off) < reach2)) continue;
                     vicinity.x.push_back(static_cast<float>(off.x));
                     vicinity.y.push_back(static_cast<float>(off.y));
                     vicinity.z.push_back(static_cast<float>(off.z));
                     vicinity.photon.push_back(static_cast<std::uint32_t>(i));
                 }
             });
        if (vicinity.photon.size() > kMostHeld) {
            vicinity.reach = 0.0;
            return false;
        }
        // Lanes may look beyond the last.
        for (std::vector<float>* lane : {&vicinity.x, &vicinity.y, &vicinity.z})
            lane->resize(vicinity.photon.size() + kLanes, 0.0f);
        return true;
    }

    /// The photons of a vicinity that are nearer than the bound.
    void scan(const PhotonVicinity& vicinity, double bound)
    {
        count_ = 0;
        bound_ = bound;
        using csg::lanes::FloatPart;
        const glm::vec3 from(point_ - vicinity.center), n(normal_);
        const FloatPart fx(from.x), fy(from.y), fz(from.z);
        auto limit = static_cast<float>(bound_);
        const std::size_t held = vicinity.photon.size();
        alignas(64) std::array<float, kLanes> d2;
        for (std::size_t i = 0; i < held; i += kLanes) {
            std::uint32_t near = 0;
            for (std::size_t part = 0; part < kLanes; part += csg::lanes::kFloatPart) {
                const FloatPart dx = FloatPart::load_unaligned(&vicinity.x[i + part]) - fx,
                                dy = FloatPart::load_unaligned(&vicinity.y[i + part]) - fy,
                                dz = FloatPart::load_unaligned(&vicinity.z[i + part]) - fz;
                FloatPart here = dx * dx + dy * dy + dz * dz;
                if constexpr (kFlat)
                    here = here * (FloatPart(1.0f) +
                                   FloatPart(static_cast<float>(kFlattening)) *
                                       xsimd::abs(FloatPart(n.x) * dx + FloatPart(n.y) * dy + FloatPart(n.z) * dz));
                here.store_aligned(&d2[part]);
                near |= csg::lanes::mask(here < FloatPart(limit)) << part;
            }
            if (held - i < kLanes) near &= (1u << (held - i)) - 1u;
            for (; near != 0; near &= near - 1) {
                const auto k = static_cast<std::size_t>(std::countr_zero(near));
                const std::uint32_t photon = vicinity.photon[i + k];
                found_[count_] = {d2[k], photon};
                count_ += reached(photon) ? 1 : 0;
            }
            if (count_ < most_ + kSpare) continue;
            make_room();
            limit = static_cast<float>(bound_);
        }
    }

    glm::dvec3 offset(std::size_t i) const
    {
        return {static_cast<double>(places_.x[i]) - point_.x, static_cast<double>(places_.y[i]) - point_.y,
                static_cast<double>(places_.z[i]) - point_.z};
    }

    /// At least the most_ + 1 nearest nearer than the bound, or all.
    void collect(double bound)
    {
        count_ = 0;
        bound_ = bound;
        walk([this] { return bound_; }, [this](std::size_t first, std::size_t end) { scan(first, end); });
    }

    /// f(first, end) for runs of photons, the near ones first, that hold all whose squared distance is below limit().
    template <class Limit, class F>
    void walk(Limit&& limit, F&& f) const
    {
        struct Waiting {
            std::size_t first, end;
            glm::dvec3 off;  ///< of the subtree's space from the point, along each axis
            double distance2;
        };
        std::array<Waiting, 64> waiting;
        std::size_t count = 0;
        waiting[count++] = {0, places_.size(), glm::dvec3(0), 0.0};
        while (count > 0) {
            Waiting at = waiting[--count];
            if (at.distance2 >= limit()) continue;
            while (at.end - at.first > kSmall) {
                const std::size_t middle = (at.first + at.end - 1) / 2;  // of the first and the last
                const int axis = places_.axis[middle];
                const double off = places_.along(middle, axis) - point_[axis];
                if (off * off < limit()) f(middle, middle + 1);
                Waiting& far = waiting[count];
                far = at;
                if (off > 0.0) at.end = middle, far.first = middle + 1;
                else at.first = middle + 1, far.end = middle;
                far.distance2 += off * off - far.off[axis] * far.off[axis];
                far.off[axis] = off;
                count += far.distance2 < limit() ? 1 : 0;
            }
            f(at.first, at.end);
        }
    }

    void scan(std::size_t first, std::size_t end)
    {
        for (std::size_t i = first; i < end; i += kLanes) {
            alignas(64) std::array<double, kLanes> d2;
            const float *x = &places_.x[i], *y = &places_.y[i], *z = &places_.z[i];
            for (std::size_t k = 0; k < kLanes; ++k)
                d2[k] = distance2(static_cast<double>(x[k]) - point_.x, static_cast<double>(y[k]) - point_.y,
                                  static_cast<double>(z[k]) - point_.z);
            const std::size_t lanes = std::min(kLanes, end - i);
            for (std::size_t k = 0; k < lanes; ++k) {
                if (!(d2[k] < bound_)) continue;
                const auto photon = static_cast<std::uint32_t>(i + k);
                found_[count_] = {static_cast<float>(d2[k]), photon};
                count_ += reached(photon) ? 1 : 0;
            }
            if (count_ >= most_ + kSpare) make_room();
        }
    }

    /// The nearest and one more stay.
    void make_room()
    {
        part();
        for (std::size_t k = most_ + 1; k < count_; ++k)
            if (found_[k].distance2 < found_[most_].distance2) std::swap(found_[k], found_[most_]);
        count_ = most_ + 1;
        bound_ = static_cast<double>(found_[most_].distance2);
    }

    /// Whether the first photons that POV-Ray comes to are the nearest. The first that it comes to when it has enough
    /// takes the place of the farthest of them even if it lies farther, for its limit is that of the search until then;
    /// that shows only here.
    bool nearest_come_first() const
    {
        struct Waiting {
            std::size_t first, end;
            bool alone;  ///< the node in the middle is meant, what lies below it is done
        };
        std::array<Waiting, 192> waiting;
        std::size_t count = 0, met = 0;
        waiting[count++] = {0, places_.size(), false};
        while (count > 0 && met < most_) {
            const Waiting at = waiting[--count];
            if (at.first >= at.end) continue;
            const std::size_t middle = (at.first + at.end - 1) / 2;
            if (at.alone) {
                const double d2 = distance2(middle);
                if (!(d2 < all_)) continue;
                if (d2 > bound_ * kRounding) return false;
                ++met;
                continue;
            }
            const int axis = places_.axis[middle];
            const double off = places_.along(middle, axis) - point_[axis];
            const Waiting below{at.first, middle, false}, above{middle + 1, at.end, false};
            if (off * off < all_) {
                waiting[count++] = {at.first, at.end, true};
                waiting[count++] = off > 0.0 ? above : below;
            }
            waiting[count++] = off > 0.0 ? below : above;
        }
        return met == most_;
    }

    /// POV-Ray's own way: photon by photon, with a heap. Its limit is that of the search until the heap is full, so
    /// that the first photon that comes then takes the place of the farthest even if it lies farther.
    void walk_in_order()
    {
        struct Waiting {
            std::size_t first, end;
            enum Part : std::uint8_t { Whole, Far, Node } part;
            bool within;
        };
        const auto nearer = [](const Near& a, const Near& b) { return a.distance2 < b.distance2; };
        std::array<Waiting, 192> waiting;
        std::size_t count = 0;
        waiting[count++] = {0, places_.size(), Waiting::Whole, false};
        count_ = 0;
        bound_ = all_;
        while (count > 0) {
            const Waiting at = waiting[--count];
            if (at.first >= at.end) continue;
            const std::size_t middle = (at.first + at.end - 1) / 2;
            const int axis = places_.axis[middle];
            const double off = places_.along(middle, axis) - point_[axis];
            const Waiting below{at.first, middle, Waiting::Whole, false},
                above{middle + 1, at.end, Waiting::Whole, false};
            if (at.part == Waiting::Whole) {
                waiting[count++] = {at.first, at.end, Waiting::Node, off * off < bound_};
                waiting[count++] = {at.first, at.end, Waiting::Far, false};
                waiting[count++] = off > 0.0 ? below : above;
            } else if (at.part == Waiting::Far) {
                if (off * off < bound_) waiting[count++] = off > 0.0 ? above : below;
            } else if (at.within) {
                const double d2 = distance2(middle);
                if (!(d2 < bound_)) continue;
                const Near here{static_cast<float>(d2), static_cast<std::uint32_t>(middle)};
                if (count_ < most_) {
                    found_[count_++] = here;
                    std::push_heap(found_, found_ + count_, nearer);
                    continue;
                }
                std::pop_heap(found_, found_ + count_, nearer);
                found_[count_ - 1] = here;
                std::push_heap(found_, found_ + count_, nearer);
                bound_ = exact(found_[0]);
            }
        }
    }

    const PhotonPlaces& places_;
    const glm::dvec3 point_, normal_;
    const std::size_t most_;
    double all_ = 0, bound_ = 0;
    Near* found_ = nullptr;
    std::size_t count_ = 0;
};

}  // namespace trace
