#pragma once

#include "csg/base/types.h"

#include <array>

namespace csg {

/// Where one of several rays passes walls of an outline, sorted as they come. Kept small, for there is one a lane: a
/// ray that passes more is asked by itself.
class OutlineWalls {
public:
    struct Wall {
        double t;
        std::uint32_t face;
    };

    /// False: there is no more room.
    bool add(double t, std::uint32_t face)
    {
        if (count_ == kMost) return false;
        std::uint32_t at = count_++;
        for (; at > 0 && walls_[at - 1].t > t; --at) walls_[at] = walls_[at - 1];
        walls_[at] = {t, face};
        return true;
    }
    bool empty() const { return count_ == 0; }
    const Wall* begin() const { return walls_.data(); }
    const Wall* end() const { return walls_.data() + count_; }

private:
    static constexpr std::uint32_t kMost = 16;
    std::uint32_t count_ = 0;
    std::array<Wall, kMost> walls_;  // filled as far as the count says
};

}  // namespace csg
