#pragma once

#include "numbers/lanes.h"
#include "render/kernel/gather/photon_boxes.h"
#include "render/kernel/gather/photon_reach.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace trace {

/// A point as the sum of two numbers in single precision: what is subtracted from them is right to the last.
struct SplitPoint {
    explicit SplitPoint(const glm::dvec3& point) : high(point), low(point - glm::dvec3(high)) {}
    glm::vec3 high, low;
};

/// How far off a point the boxes of a node are, squared, and which of them are nearer than a limit.
inline std::uint32_t boxes_near(const PhotonBoxes::Node& node, const SplitPoint& point, float limit,
                                std::array<float, PhotonBoxes::kWide>& away)
{
    using Float = numbers::lanes::FloatPart;
    constexpr std::size_t kLanes = PhotonBoxes::kWide;
    // Rounding may put a box farther off than it is: by less than this share.
    constexpr float kNearer = 1.0f - 1e-5f;
    const Float zero(0.0f), x(point.high.x), y(point.high.y), z(point.high.z), rest_x(point.low.x), rest_y(point.low.y),
        rest_z(point.low.z), most(limit);
    std::uint32_t near = 0;
    for (std::size_t k = 0; k < kLanes; k += Float::size) {
        const auto off = [&](const std::array<float, kLanes>& low, const std::array<float, kLanes>& high, Float at,
                             Float rest) {
            return xsimd::max(xsimd::max((Float::load_aligned(low.data() + k) - at) - rest,
                                         rest - (Float::load_aligned(high.data() + k) - at)),
                              zero);
        };
        const Float dx = off(node.low_x, node.high_x, x, rest_x), dy = off(node.low_y, node.high_y, y, rest_y),
                    dz = off(node.low_z, node.high_z, z, rest_z);
        const Float d2 = Float(kNearer) * (dx * dx + dy * dy + dz * dz);
        d2.store_unaligned(away.data() + k);
        near |= numbers::lanes::mask(d2 < most) << k;
    }
    return near;
}

/// The leaves of PhotonBoxes around a point, in their order, kept for the points beside it.
class NearLeaves {
public:
    void forget() { reach_ = -1.0; }

    /// Whether the kept leaves include all within `distance` of a point, and not many more.
    bool serve(const glm::dvec3& point, double distance) const
    {
        constexpr std::size_t kFew = 32;
        constexpr double kMuchFarther = 3.0;
        return distance + glm::distance(point, middle_) <= reach_ &&
               (leaves_.size() <= kFew || reach_ <= kMuchFarther * distance);
    }

    /// How much farther than `distance` to collect leaves around the first of many points that spread over `extent`; 0
    /// where each should search for itself. The extra leaves pay when they serve most points, or when they are few.
    double beside(double extent, double distance) const
    {
        constexpr std::size_t kFew = 8;
        if (extent <= 0.5 * distance) return extent;
        return reach_ >= 0.0 && leaves_.size() <= kFew && extent <= 3.0 * distance ? std::min(extent, distance) : 0.0;
    }

    /// Collects the leaves up to `distance + farther` from a point.
    void find(const PhotonBoxes& boxes, const PhotonReach& from, const glm::dvec3& point, double distance,
              double farther)
    {
        middle_ = point;
        distance += farther;
        reach_ = distance;
        leaves_.clear();
        if (from.nothing) return;
        constexpr double kSure = 1.0 + 1e-5;
        const SplitPoint around(point);
        const double most = kSure * distance * distance;
        const auto limit = static_cast<float>(std::min(most, static_cast<double>(std::numeric_limits<float>::max())));
        std::array<float, PhotonBoxes::kWide> away;
        struct Waiting {
            std::uint32_t level, node, near;
        };
        std::array<Waiting, 16> waiting;  // one of each level
        std::size_t count = 0;
        waiting[count++] = {from.level, from.node, boxes_near(boxes.node(from.level, from.node), around, limit, away)};
        while (count > 0) {
            Waiting& at = waiting[count - 1];
            if (at.near == 0) {
                --count;
                continue;
            }
            const std::uint32_t first = PhotonReach::child(at.node, at.near), level = at.level;
            at.near &= at.near - 1;
            if (level == 0) leaves_.push_back(first);
            else waiting[count++] = {level - 1, first, boxes_near(boxes.node(level - 1, first), around, limit, away)};
        }
    }

    const std::uint32_t* begin() const { return leaves_.data(); }
    const std::uint32_t* end() const { return leaves_.data() + leaves_.size(); }

private:
    std::vector<std::uint32_t> leaves_;
    glm::dvec3 middle_{0};
    double reach_ = -1.0;  ///< less than 0: not those of any point
};

}  // namespace trace
