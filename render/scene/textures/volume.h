#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scene {

/// The samples of a density file, x fastest, z slowest.
struct Volume {
    std::array<std::uint32_t, 3> size{};  ///< none is 0
    double most = 255.0;                  ///< a sample of this size counts 1
    std::vector<std::uint32_t> samples;
};

}  // namespace scene
