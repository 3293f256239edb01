#include "render/texture/noise/noise_tables.h"

#include "render/texture/noise/noise.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace texture {
namespace {

constexpr std::array<double, NoiseTables::kLatticeNumbers> kLattice{
#include "render/texture/noise/noise_lattice.inc"
};

}  // namespace

int draw15(std::uint32_t& state)
{
    state = next_lcg(state);
    return static_cast<int>((state >> 16) & 0x7FFFu);
}

NoiseTables::NoiseTables()
{
    fill_hash();
    fill_lattice();
    fill_gradients();
    std::mt19937 generator(5489u);
    for (double& r : random) r = static_cast<double>(generator()) / 4294967296.0;
}

void NoiseTables::fill_hash()
{
    for (std::size_t i = 0; i < kHashSize; ++i) hash[i] = static_cast<std::uint16_t>(i);
    std::uint32_t state = 0;
    for (std::size_t i = kHashSize - 1;; --i) {
        const auto j = static_cast<std::size_t>(draw15(state)) % kHashSize;
        std::swap(hash[i], hash[j]);
        if (i == 0) break;
    }
    hash[kHashSize] = hash[0];
    for (std::size_t i = 0; i < kHashSize; ++i) row[i] = static_cast<std::uint8_t>(hash[i] & 255u);
}

void NoiseTables::fill_lattice()
{
    for (std::size_t i = 0; i < kLatticeRows; ++i)
        std::copy_n(kLattice.begin() + i, lattice[i].size(), lattice[i].begin());
    for (std::size_t i = 0; i < singles.size(); ++i) {
        singles[i].fill(0.0f);
        for (std::size_t k = 0; k < 12; ++k) singles[i][k] = static_cast<float>(kLattice[i + k]);
    }
    for (std::size_t i = 0; i < kHashSize; ++i) single_row[i] = static_cast<std::uint16_t>(row[i] * singles[0].size());
}

void NoiseTables::fill_gradients()
{
    std::uint32_t state = 1;
    for (glm::dvec3& g : gradient) {
        double q;
        do {
            for (int k = 0; k < 3; ++k) g[k] = static_cast<double>((draw15(state) % 4096) - 2048) / 2048.0;
            q = glm::dot(g, g);
        } while (q < 1e-5 || q > 1.0);
        g /= std::sqrt(q);
    }
    for (std::size_t i = 0; i < kGradients; ++i) permutation[i] = static_cast<int>(i);
    permutation[kGradients] = 0;
    // Only even places are visited and the first swaps in the extra 0: measured, not tidied.
    for (std::size_t i = kGradients; i >= 2; i -= 2) {
        const auto j = static_cast<std::size_t>(draw15(state)) % kGradients;
        std::swap(permutation[i], permutation[j]);
    }
}

const NoiseTables kNoiseTables;

}  // namespace texture
