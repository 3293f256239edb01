#pragma once

#include "numbers/random.h"
#include "render/kernel/tile/sobol.h"

/// The random numbers of one path: dimension after dimension of a Sobol sequence that is scrambled anew for each pair.
namespace trace::path {

class Draws {
public:
    Draws() = default;
    /// \param seed  of the pixel
    /// \param index  of the sample in it
    Draws(std::uint32_t seed, std::uint32_t index) : seed_(seed), index_(index) {}

    /// The next two dimensions, each in [0, 1).
    std::array<double, 2> pair()
    {
        const std::uint64_t place = std::uint64_t{seed_} << 32 | ++dimension_;
        return sobol_point(static_cast<std::uint32_t>(numbers::stirred(place * 0x9e3779b97f4a7c15u)), index_);
    }
    double one() { return pair()[0]; }

private:
    std::uint32_t seed_ = 0, index_ = 0, dimension_ = 0;
};

}  // namespace trace::path
