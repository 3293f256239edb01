#pragma once

#include "csg/freeform/shared/intersection_list.h"

#include <array>

namespace csg {

/// Places where a ray passes a surface, sorted as they come; beyond the capacity those farthest along are forgotten.
class SortedEnds {
public:
    struct End {
        double t;
        std::uint32_t face;
    };

    void add(double t, std::uint32_t face)
    {
        if (!(t > -kInfinity && t < kInfinity)) return;
        if (count_ == kMost) {
            if (t >= ends_[count_ - 1].t) return;
            --count_;
        }
        std::uint32_t at = count_++;
        for (; at > 0 && ends_[at - 1].t > t; --at) ends_[at] = ends_[at - 1];
        ends_[at] = {t, face};
    }
    const End* begin() const { return ends_.data(); }
    const End* end() const { return ends_.data() + count_; }

private:
    static constexpr std::uint32_t kMost = 2 * IntersectionList::kMostSpans;

    std::uint32_t count_ = 0;
    std::array<End, kMost> ends_;  // filled as far as the count says
};

}  // namespace csg
