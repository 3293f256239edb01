#pragma once

#include "render/trace/photon/near_photons.h"
#include "render/trace/photon/photon_places.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trace {

/// The nearest photons around a point (spec 6, 3.7). POV-Ray goes from photon to photon and keeps a heap; here small
/// subtrees, which lie side by side, are looked at in lanes, and the nearest are parted from the others when there are
/// many. The answer is the same.
/// \tparam kFlat  the sphere is flattened off a surface
template <bool kFlat>
class PhotonSearch {
public:
    PhotonSearch(const PhotonPlaces& places, const glm::dvec3& point, const glm::dvec3& normal, int most)
        : places_(places), point_(point), normal_(normal), most_(static_cast<std::size_t>(std::max(most, 1)))
    {}

    void find(double radius, NearPhotons& out)
    {
        all_ = radius * radius;
        out.found.resize(most_ + kSpare + kLanes);
        found_ = out.found.data();
        count_ = 0;
        out.radius2 = all_;
        // One more than asked for, to know whether there are any.
        constexpr double kWider = 1.4, kFarther = 3.0;
        const double likely = kWider * out.likely2;
        out.likely2 = 0.0;
        for (double bound = likely > 0.0 ? likely : all_;; bound *= kFarther) {
            collect(std::min(bound, all_));
            if (count_ > most_ || bound >= all_) break;
        }
        if (count_ > most_) {
            part();
            out.likely2 = out.radius2 = bound_;
            if (nearest_come_first()) out.radius2 = replace_farthest();
            count_ = most_;
        }
        out.found.resize(count_);
    }

private:
    using Near = NearPhotons::Near;
    static constexpr std::size_t kLanes = 8;    ///< photons looked at together
    static constexpr std::size_t kSmall = 24;   ///< subtrees up to so many are not walked
    static constexpr std::size_t kSpare = 256;  ///< so many more than are asked for are kept before they are parted

    /// The most_ nearest come first; bound_: the farthest of them.
    void part()
    {
        std::nth_element(found_, found_ + most_ - 1, found_ + count_,
                         [](const Near& a, const Near& b) { return a.distance2 < b.distance2; });
        bound_ = found_[most_ - 1].distance2;
    }

    double distance2(double dx, double dy, double dz) const
    {
        constexpr double kFlattening = 16.0;
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

    /// At least the most_ + 1 nearest nearer than the bound, or all.
    void collect(double bound)
    {
        count_ = 0;
        bound_ = bound;
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
            if (at.distance2 >= bound_) continue;
            while (at.end - at.first > kSmall) {
                const std::size_t middle = (at.first + at.end - 1) / 2;  // of the first and the last
                const int axis = places_.axis[middle];
                const double off = places_.along(middle, axis) - point_[axis];
                if (off * off < bound_) scan(middle, middle + 1);
                Waiting& far = waiting[count];
                far = at;
                if (off > 0.0) at.end = middle, far.first = middle + 1;
                else at.first = middle + 1, far.end = middle;
                far.distance2 += off * off - far.off[axis] * far.off[axis];
                far.off[axis] = off;
                count += far.distance2 < bound_ ? 1 : 0;
            }
            scan(at.first, at.end);
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
                found_[count_] = {d2[k], photon};
                count_ += reached(photon) ? 1 : 0;
            }
            if (count_ < most_ + kSpare) continue;
            part();
            // One more has to stay.
            count_ = most_ + 1;
            for (std::size_t k = most_ + 1; k < most_ + kSpare; ++k)
                if (found_[k].distance2 < found_[most_].distance2) std::swap(found_[k], found_[most_]);
            bound_ = found_[most_].distance2;
        }
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
                if (d2 > bound_) return false;
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

    /// The farthest of the nearest gives way to the next one, whose distance is returned.
    double replace_farthest()
    {
        const Near next = *std::min_element(found_ + most_, found_ + count_,
                                            [](const Near& a, const Near& b) { return a.distance2 < b.distance2; });
        found_[most_ - 1] = next;
        return next.distance2;
    }

    const PhotonPlaces& places_;
    const glm::dvec3 point_, normal_;
    const std::size_t most_;
    double all_ = 0, bound_ = 0;
    Near* found_ = nullptr;
    std::size_t count_ = 0;
};

}  // namespace trace
