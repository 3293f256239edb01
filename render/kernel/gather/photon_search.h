#pragma once

#include "render/kernel/gather/near_photons.h"
#include "numbers/pack_lanes.h"
#include "render/kernel/gather/part_nearest.h"
#include "render/kernel/gather/photon_boxes.h"
#include "render/kernel/gather/photon_distance.h"
#include "render/kernel/gather/photon_reach.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace trace {

/// The nearest photons around a point (spec 6, 3.7). POV-Ray goes from photon to photon of its tree and keeps a heap;
/// here boxes of eights are looked at in lanes (`photon_boxes.h`), and the nearest are parted from the others when
/// there are many. The answer is the same, but for photons on the wrong side of a node: whether POV-Ray finds them
/// depends on when it comes there, and here they are found if they are in reach at first. (One photon more in one
/// search of thirty, where each has more photons than it keeps.) \tparam kFlat  the sphere is flattened off a surface
template <bool kFlat>
class PhotonSearch {
public:
    PhotonSearch(const PhotonPlaces& places, const PhotonBoxes& boxes, const glm::dvec3& point,
                 const glm::dvec3& normal, int most)
        : places_(places), boxes_(boxes), from_(places, point, normal),
          most_(static_cast<std::size_t>(std::max(most, 1))), reach_(boxes)
    {}

    /// reach: of points of which this is one, and of a radius that is not less.
    void find(double radius, const PhotonReach& reach, NearPhotons& out)
    {
        reach_ = reach;
        all_ = radius * radius;
        start(out);
        out.radius2 = all_;
        // One more than asked for, to know whether there are any.
        constexpr double kFarther = 3.0;
        for (double bound = likely(out);; bound *= kFarther) {
            const double here = std::min(bound, all_);
            collect(here, out.leaves);
            if (count_ > most_ || here == all_) break;
        }
        out.likely2 = all_;
        out.asked = from_.point;
        if (count_ > most_) {
            part(most_);
            out.likely2 = bound_;
            if (nearest_come_first(out.around)) {
                walk_in_order(out);
                out.radius2 = bound_;
                return;
            }
            double farthest = 0.0;
            for (std::size_t k = 0; k < most_; ++k)
                if (distance2_[k] >= static_cast<float>(bound_))
                    farthest = std::max(farthest, from_.squared(number_[k]));
            out.radius2 = farthest;
        }
        out.found.resize(count_);
        for (std::size_t k = 0; k < count_; ++k) out.found[k] = {distance2_[k], number_[k]};
    }

    /// What find() would find, of all the photons within a larger radius.
    void find_among(const NearPhotons& wide, double radius, NearPhotons& out)
    {
        all_ = radius * radius;
        out.radius2 = out.likely2 = all_;
        out.asked = from_.point;
        out.found.clear();
        const auto limit = static_cast<float>(all_);
        for (const Near& photon : wide.found)
            if (photon.distance2 < limit && reached(photon.photon)) out.found.push_back(photon);
    }

    /// POV-Ray's own way, whatever it costs.
    void find_in_order(double radius, NearPhotons& out)
    {
        all_ = radius * radius;
        walk_in_order(out);
        out.radius2 = bound_;
    }

private:
    using Near = NearPhotons::Near;
    using Float = numbers::lanes::FloatPart;
    static constexpr double kRounding = 1.0 + 1e-6;  ///< of what is kept in single precision
    static constexpr std::size_t kLanes = PhotonBoxes::kWide;
    static constexpr std::size_t kSpare = 256;  ///< so many more than are asked for are kept before they are parted

    void start(NearPhotons& out)
    {
        const std::size_t room = most_ + kSpare + kLanes + PartedPhotons::kRoom;
        if (out.numbers.size() < room) {
            out.numbers.resize(room);
            out.distances2.resize(room);
            out.parted.resize(room);
        }
        distance2_ = out.distances2.data();
        parted_ = out.parted.data();
        number_ = out.numbers.data();
    }

    /// What should hold the nearest: around a point nearby they were found so near.
    double likely(const NearPhotons& before)
    {
        constexpr double kWider = 1.15, kSure = 1.0 + 1e-5;
        if (!(before.likely2 > 0.0)) {
            collect_nearest_first(all_);
            if (count_ <= most_) return all_;
            part(most_ + 1);
            return kSure * bound_;
        }
        if constexpr (kFlat) return kWider * before.likely2;
        const double radius = std::sqrt(before.likely2) + glm::distance(from_.point, before.asked);
        // Where that is far more than the last point's photons filled, they are as likely to lie as near here.
        constexpr double kLoose = 1.5;
        return std::min(kSure * radius * radius, kLoose * before.likely2);
    }

    /// The `keep` nearest stay, and bound_ is the farthest of them.
    void part(std::size_t keep)
    {
        PartedPhotons photons(distance2_, number_, count_, parted_);
        bound_ = static_cast<double>(photons.keep_nearest(keep, static_cast<float>(bound_)));
        count_ = keep;
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
        const double off = places_.along(gate, places_.axis[gate]) - from_.point[places_.axis[gate]];
        const bool beyond = photon < gate ? !(off > 0.0) : off > 0.0;
        return !beyond || off * off < all_;
    }
    /// At least the most_ + 1 nearest nearer than the bound, or all, in the order of the leaves.
    void collect(double bound, NearLeaves& leaves)
    {
        count_ = 0;
        bound_ = bound;
        if (reach_.nothing) return;
        const double distance = std::sqrt(bound);
        if (!leaves.serve(from_.point, distance))
            leaves.find(boxes_, reach_, from_.point, distance, leaves.beside(reach_.extent, distance));
        look(leaves.begin(), leaves.end());
    }

    /// The same, the nearest boxes first, where nothing tells how far off the photons are.
    void collect_nearest_first(double bound)
    {
        count_ = 0;
        bound_ = bound;
        if (reach_.nothing) return;
        struct Waiting {
            float distance2;
            std::uint32_t level, node;
        };
        std::array<Waiting, kLanes * 12> waiting;  // eights of eights: a map has fewer levels than that
        std::size_t count = 0;
        waiting[count++] = {0.0f, reach_.level, reach_.node};
        while (count > 0) {
            const Waiting at = waiting[--count];
            if (static_cast<double>(at.distance2) >= bound_) continue;
            alignas(64) std::array<float, kLanes> away;
            std::uint32_t near =
                boxes_near(boxes_.node(at.level, at.node), from_.split, static_cast<float>(bound_), away);
            if (at.level == 0) {
                std::array<std::uint32_t, kLanes> leaves;
                std::size_t few = 0;
                for (; near != 0; near &= near - 1) leaves[few++] = PhotonReach::child(at.node, near);
                look(leaves.data(), leaves.data() + few);
                continue;
            }
            // The nearest comes to lie on top.
            const std::size_t first = count;
            for (; near != 0; near &= near - 1) {
                const auto k = static_cast<std::uint32_t>(std::countr_zero(near));
                const Waiting child{away[k], at.level - 1, static_cast<std::uint32_t>(kLanes) * at.node + k};
                std::size_t to = count++;
                for (; to > first && waiting[to - 1].distance2 < child.distance2; --to) waiting[to] = waiting[to - 1];
                waiting[to] = child;
            }
        }
    }

    static Float load(const std::array<float, kLanes>& from, std::size_t at)
    {
        return Float::load_aligned(from.data() + at);
    }

    /// Keeps those photons of some leaves that are nearer than the bound.
    template <class Iterator>
    void look(Iterator leaves, Iterator end)
    {
        // Copies: what is written might be members otherwise.
        const PhotonDistance<kFlat> from = from_;
        const std::size_t full = most_ + kSpare;
        float* const distances2 = distance2_;
        std::uint32_t* const numbers = number_;
        std::size_t count = count_;
        Float limit(static_cast<float>(bound_));
        float gates_within = surely_passed();
        for (; leaves != end; ++leaves) {
            const PhotonBoxes::Leaf& leaf = boxes_.leaf(*leaves);
            alignas(64) std::array<float, kLanes> d2;
            std::uint32_t near = 0;
            for (std::size_t k = 0; k < kLanes; k += Float::size) {
                const Float here = from.squared(load(leaf.x, k), load(leaf.y, k), load(leaf.z, k));
                here.store_aligned(d2.data() + k);
                near |= numbers::lanes::mask(here < limit) << k;
            }
            if ((near & leaf.gated) != 0 && !(leaf.gate_off < gates_within)) [[unlikely]]
                near = without_unreached(leaf, near);
            count += numbers::pack(near, d2.data(), leaf.photon.data(), distances2 + count, numbers + count);
            if (count < full) [[likely]]
                continue;
            count_ = count;
            part(most_ + 1);  // the nearest and one more
            count = count_;
            limit = Float(static_cast<float>(bound_));
            gates_within = surely_passed();
        }
        count_ = count;
    }
    /// Photons nearer than the bound whose gates are no farther off them are reached: the gates' planes are in reach.
    float surely_passed() const
    {
        constexpr double kRound = 1e-5;
        return static_cast<float>((1.0 - kRound) * std::sqrt(all_) - (1.0 + kRound) * std::sqrt(bound_));
    }
    [[gnu::noinline]] std::uint32_t without_unreached(const PhotonBoxes::Leaf& leaf, std::uint32_t near) const
    {
        for (std::uint32_t gated = near & leaf.gated; gated != 0; gated &= gated - 1) {
            const int k = std::countr_zero(gated);
            if (!reached(leaf.photon[static_cast<std::size_t>(k)])) near &= ~(1u << k);
        }
        return near;
    }

    /// Photons of a part that are in reach. others: whether there are some that are not of the nearest; until_others:
    /// the count does not matter then.
    std::size_t count_in_reach(std::size_t first, std::size_t end, bool& others, bool until_others) const
    {
        constexpr double kSurely = 1.0 + 1e-5;
        const Float least(static_cast<float>(bound_ * kRounding * kSurely)), most(static_cast<float>(all_)),
            surely(static_cast<float>(all_ / kSurely));
        std::size_t count = 0;
        std::uint32_t beyond = 0;
        for (std::size_t i = first; i < end; i += Float::size) {
            const Float d2 = from_.squared(Float::load_unaligned(&places_.x[i]), Float::load_unaligned(&places_.y[i]),
                                           Float::load_unaligned(&places_.z[i]));
            const std::uint32_t part = end - i < Float::size ? (1u << (end - i)) - 1u : ~0u;
            count += static_cast<std::size_t>(std::popcount(numbers::lanes::mask(d2 < most) & part));
            beyond |= numbers::lanes::mask((d2 > least) & (d2 < surely)) & part;
            if (until_others && beyond != 0) break;
        }
        others = beyond != 0;
        return count;
    }

    /// Whether the first photons that POV-Ray comes to are the nearest. The first that it comes to when it has enough
    /// takes the place of the farthest of them even if it lies farther, for its limit is that of the search until then;
    /// that shows only here.
    bool nearest_come_first(PhotonCell& around) const
    {
        if (!around.holds(from_.point)) around = places_.cell(from_.point, most_);
        bool others = false;  // among those that it comes to first, as is the rule
        const std::size_t first = count_in_reach(around.first, around.end, others, true);
        if (others) return false;
        const Order order = order_of_first(most_, around, first);
        return (order == Order::Unknown ? order_of_first(0, around, first) : order) == Order::NearestFirst;
    }

    /// Parts of POV-Ray's tree of up to `together` photons are looked at as one, which may leave it unknown.
    enum class Order : std::uint8_t { NearestFirst, OthersBetween, Unknown };
    /// cell: the first of these parts, of which `in_cell` are in reach, all of them of the nearest.
    Order order_of_first(std::size_t together, const PhotonCell& cell, std::size_t in_cell) const
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
            if (at.first == cell.first && at.end == cell.end && !at.alone) {
                met += in_cell;
                continue;
            }
            if (at.end - at.first <= together && !at.alone) {
                bool others = false;
                met += count_in_reach(at.first, at.end, others, met + (at.end - at.first) <= most_);
                if (others) return met <= most_ ? Order::OthersBetween : Order::Unknown;
                continue;
            }
            const std::size_t middle = (at.first + at.end - 1) / 2;
            if (at.alone) {
                const double d2 = from_.squared(middle);
                if (!(d2 < all_)) continue;
                if (d2 > bound_ * kRounding) return Order::OthersBetween;
                ++met;
                continue;
            }
            const int axis = places_.axis[middle];
            const double off = places_.along(middle, axis) - from_.point[axis];
            const Waiting below{at.first, middle, false}, above{middle + 1, at.end, false};
            if (off * off < all_) {
                waiting[count++] = {at.first, at.end, true};
                waiting[count++] = off > 0.0 ? above : below;
            }
            waiting[count++] = off > 0.0 ? below : above;
        }
        return met >= most_ ? Order::NearestFirst : Order::OthersBetween;
    }

    /// POV-Ray's own way: photon by photon, with a heap. Its limit is that of the search until the heap is full, so
    /// that the first photon that comes then takes the place of the farthest even if it lies farther.
    void walk_in_order(NearPhotons& out)
    {
        out.found.resize(most_);
        Near* const found = out.found.data();
        struct Waiting {
            std::size_t first, end;
            enum Part : std::uint8_t { Whole, Far, Node } part;
            bool within;
        };
        const auto nearer = [](const Near& a, const Near& b) { return a.distance2 < b.distance2; };
        const auto take = [&](std::size_t photon) {
            const double d2 = from_.squared(photon);
            if (!(d2 < bound_)) return;
            const Near here{static_cast<float>(d2), static_cast<std::uint32_t>(photon)};
            if (count_ < most_) {
                found[count_++] = here;
                std::push_heap(found, found + count_, nearer);
                return;
            }
            std::pop_heap(found, found + count_, nearer);
            found[count_ - 1] = here;
            std::push_heap(found, found + count_, nearer);
            bound_ = from_.squared(found[0].photon);
        };
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
            const double off = places_.along(middle, axis) - from_.point[axis];
            const Waiting below{at.first, middle, Waiting::Whole, false},
                above{middle + 1, at.end, Waiting::Whole, false};
            if (at.part == Waiting::Whole && at.end - at.first == 1) {  // half of all: nothing lies below it
                if (off * off < bound_) take(middle);
            } else if (at.part == Waiting::Whole) {
                waiting[count++] = {at.first, at.end, Waiting::Node, off * off < bound_};
                waiting[count++] = {at.first, at.end, Waiting::Far, false};
                waiting[count++] = off > 0.0 ? below : above;
            } else if (at.part == Waiting::Far) {
                if (off * off < bound_) waiting[count++] = off > 0.0 ? above : below;
            } else if (at.within) {
                take(middle);
            }
        }
        out.found.resize(count_);
    }

    const PhotonPlaces& places_;
    const PhotonBoxes& boxes_;
    const PhotonDistance<kFlat> from_;
    const std::size_t most_;
    PhotonReach reach_;
    double all_ = 0, bound_ = 0;
    float *distance2_ = nullptr, *parted_ = nullptr;
    std::uint32_t* number_ = nullptr;
    std::size_t count_ = 0;
};

}  // namespace trace
