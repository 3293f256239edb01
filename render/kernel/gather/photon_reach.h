#pragma once

#include "numbers/lanes.h"
#include "render/kernel/gather/photon_boxes.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace trace {

/// What the photons near some points that lie together have in common.
class PhotonReach {
public:
    /// Points may lie anywhere: searches begin with all photons.
    explicit PhotonReach(const PhotonBoxes& boxes) { begin_at_root(boxes); }

    /// Points between low and high, and photons up to `radius` from one of them.
    PhotonReach(const PhotonBoxes& boxes, const glm::dvec3& low, const glm::dvec3& high, double radius)
    {
        begin_at_root(boxes);
        extent = glm::distance(low, high);
        if (nothing) return;
        constexpr double kSure = 1.0 + 1e-5;  // searches measure in single precision
        constexpr float kMost = std::numeric_limits<float>::max();
        const Ends ends{rounded(low - kSure * radius, -kMost), rounded(high + kSure * radius, kMost)};
        std::uint32_t near = met(boxes.node(level, node), ends);
        for (; level > 0 && std::has_single_bit(near); near = met(boxes.node(level, node), ends))
            node = child(node, near), --level;
        nothing = !leaf_below(boxes, ends, near);
    }

    std::uint32_t level = 0, node = 0;  ///< of the lowest node that has all of them below it
    bool nothing = false;               ///< there are no photons near these points
    double extent = kAnywhere;          ///< how far apart they lie at most

    static constexpr double kAnywhere = std::numeric_limits<double>::infinity();

    /// The first of a node's children that are marked.
    static std::uint32_t child(std::uint32_t node, std::uint32_t near)
    {
        return static_cast<std::uint32_t>(kLanes) * node + static_cast<std::uint32_t>(std::countr_zero(near));
    }

private:
    using Float = numbers::lanes::FloatPart;
    static constexpr std::size_t kLanes = PhotonBoxes::kWide;
    struct Ends {
        glm::vec3 low, high;
    };

    void begin_at_root(const PhotonBoxes& boxes)
    {
        nothing = boxes.levels() == 0;
        if (!nothing) level = static_cast<std::uint32_t>(boxes.levels() - 1);
    }

    /// Never infinite: boxes that are nowhere would overlap.
    static glm::vec3 rounded(const glm::dvec3& place, float towards)
    {
        const double most = std::abs(static_cast<double>(towards));
        const glm::vec3 near(glm::clamp(place, -most, most));
        return {std::nextafter(near.x, towards), std::nextafter(near.y, towards), std::nextafter(near.z, towards)};
    }

    /// Which boxes of a node overlap.
    static std::uint32_t met(const PhotonBoxes::Node& at, const Ends& ends)
    {
        std::uint32_t out = 0;
        for (std::size_t k = 0; k < kLanes; k += Float::size) {
            const auto overlap = [&](const std::array<float, kLanes>& low, const std::array<float, kLanes>& high,
                                     float from, float to) {
                return (Float::load_aligned(low.data() + k) <= Float(to)) &
                       (Float::load_aligned(high.data() + k) >= Float(from));
            };
            out |= numbers::lanes::mask(overlap(at.low_x, at.high_x, ends.low.x, ends.high.x) &
                                        overlap(at.low_y, at.high_y, ends.low.y, ends.high.y) &
                                        overlap(at.low_z, at.high_z, ends.low.z, ends.high.z))
                   << k;
        }
        return out;
    }

    /// Whether a box of photons overlaps below those of this node that do.
    bool leaf_below(const PhotonBoxes& boxes, const Ends& ends, std::uint32_t near) const
    {
        if (level == 0 || near == 0) return near != 0;
        struct Waiting {
            std::uint32_t level, node, near;
        };
        std::array<Waiting, 16> waiting;  // one of each level
        std::size_t count = 0;
        waiting[count++] = {level, node, near};
        while (count > 0) {
            Waiting& at = waiting[count - 1];
            if (at.near == 0) {
                --count;
                continue;
            }
            const std::uint32_t first = child(at.node, at.near);
            at.near &= at.near - 1;
            const std::uint32_t below = met(boxes.node(at.level - 1, first), ends);
            if (below == 0) continue;
            if (at.level == 1) return true;
            waiting[count++] = {at.level - 1, first, below};
        }
        return false;
    }
};

}  // namespace trace
