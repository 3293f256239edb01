#include "render/kernel/antialias/jitter.h"

#include <array>
#include <cstdint>
#include <utility>

namespace trace {
namespace {

constexpr std::array<float, 256> kJitter = {
#include "render/kernel/antialias/jitter_table.inc"
};

constexpr std::size_t kHashSize = 4096;

/// The permutation behind jitter: exchanges driven by a 32-bit linear congruential generator that starts at 0.
std::array<std::uint16_t, kHashSize> make_permutation()
{
    std::array<std::uint16_t, kHashSize> h{};
    for (std::size_t i = 0; i < kHashSize; ++i) h[i] = static_cast<std::uint16_t>(i);
    std::uint32_t r = 0;
    for (std::size_t i = kHashSize; i-- > 0;) {
        r = r * 1812433253u + 12345u;
        std::swap(h[i], h[((r >> 16) & 0x7fffu) % kHashSize]);
    }
    return h;
}

const std::array<std::uint16_t, kHashSize> kPermutation = make_permutation();

std::uint32_t hash(std::uint32_t a, std::uint32_t b) { return kPermutation[(kPermutation[a & 4095u] ^ b) & 4095u]; }

}  // namespace

std::uint32_t permuted(std::uint32_t index) { return kPermutation[index & 4095u]; }

glm::dvec2 jitter(double x, double y)
{
    return {static_cast<double>(kJitter[hash(truncated(1021 * x), truncated(1019 * y)) & 255u]),
            static_cast<double>(kJitter[hash(truncated(1019 * x), truncated(1021 * y)) & 255u])};
}

void jitter(const double* x, const double* y, int count, double* jitter_x, double* jitter_y)
{
    // Plain loops, apart from the look-ups: the compiler puts eight numbers into a register.
    std::array<std::uint32_t, 64> ax, ay, bx, by;
    const std::size_t lanes = (static_cast<std::size_t>(count) + 7u) & ~std::size_t{7};
    for (std::size_t i = 0; i < lanes; ++i) {
        ax[i] = truncated(1021 * x[i]);
        ay[i] = truncated(1019 * y[i]);
        bx[i] = truncated(1019 * x[i]);
        by[i] = truncated(1021 * y[i]);
    }
    for (std::size_t i = 0; i < lanes; ++i) {
        jitter_x[i] = static_cast<double>(kJitter[hash(ax[i], ay[i]) & 255u]);
        jitter_y[i] = static_cast<double>(kJitter[hash(bx[i], by[i]) & 255u]);
    }
}

}  // namespace trace
