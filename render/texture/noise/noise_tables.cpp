#include "render/texture/noise/noise_tables.h"

#include <algorithm>
#include <utility>

// Each table is a constant by itself: a compiler counts the steps of one, and gives up after a million.
namespace texture {
namespace {

using Tables = NoiseTables;

constexpr std::array<double, Tables::kLatticeNumbers> kLattice{
#include "render/texture/noise/noise_lattice.inc"
};

constexpr auto kHash = [] {
    decltype(Tables::hash) hash{};
    for (std::size_t i = 0; i < Tables::kHashSize; ++i) hash[i] = static_cast<std::uint16_t>(i);
    std::uint32_t state = 0;
    for (std::size_t i = Tables::kHashSize; i-- > 0;)
        std::swap(hash[i], hash[static_cast<std::size_t>(draw15(state)) % Tables::kHashSize]);
    hash[Tables::kHashSize] = hash[0];
    return hash;
}();

constexpr auto kRow = [] {
    decltype(Tables::row) row{};
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = static_cast<std::uint8_t>(kHash[i] & 255u);
    return row;
}();

constexpr auto kRows = [] {
    decltype(Tables::lattice) lattice{};
    for (std::size_t i = 0; i < lattice.size(); ++i)
        for (std::size_t k = 0; k < lattice[i].size(); ++k) lattice[i][k] = kLattice[i + k];
    return lattice;
}();

constexpr auto kLines = [] {
    decltype(Tables::singles) singles{};
    for (std::size_t i = 0; i < singles.size(); ++i)
        for (std::size_t k = 0; k < 12; ++k) singles[i][k] = static_cast<float>(kLattice[i + k]);
    return singles;
}();

constexpr auto kSingleRow = [] {
    decltype(Tables::single_row) places{};
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = static_cast<std::uint16_t>(kRow[i] * kLines[0].size());
    return places;
}();

/// The double nearest to the root of a whole number from 1 to 2^24, as std::sqrt() gives it when the program runs.
constexpr double root_of(std::uint32_t whole)
{
    double guess = 1024.0;
    for (double last = 0.0; guess != last && whole + guess != whole + last;) {
        last = guess;
        guess = 0.5 * (guess + whole / guess);
    }
    // With 53 bits: half a unit above and below enclose the root.
    double unit = 1.0;
    while (guess / unit < 4503599627370496.0) unit *= 0.5;
    auto root = static_cast<std::uint64_t>(guess / unit);
    __extension__ using Wide = unsigned __int128;
    Wide square = whole;
    for (double u = unit; u < 1.0; u *= 2.0) square *= 4;
    while (static_cast<Wide>(root) * root + root < square) ++root;
    while (static_cast<Wide>(root) * root - root >= square) --root;
    return static_cast<double>(root) * unit;
}

struct Gradients {
    decltype(Tables::gradient) gradient{};
    std::uint32_t state = 1;
};

constexpr Gradients kGradients = [] {
    Gradients all;
    for (glm::dvec3& g : all.gradient) {
        int x, y, z, q;  // in 2048ths
        do {
            x = draw15(all.state) % 4096 - 2048;
            y = draw15(all.state) % 4096 - 2048;
            z = draw15(all.state) % 4096 - 2048;
            q = x * x + y * y + z * z;
        } while (q < 42 || q > 2048 * 2048);  // 1e-5 and 1
        const double length = root_of(static_cast<std::uint32_t>(q));
        g = glm::dvec3(x / length, y / length, z / length);
    }
    return all;
}();

constexpr auto kPermutation = [] {
    decltype(Tables::permutation) permutation{};
    for (std::size_t i = 0; i < Tables::kGradients; ++i) permutation[i] = static_cast<int>(i);
    // Only even places are visited and the first swaps in the extra 0: measured, not tidied.
    std::uint32_t state = kGradients.state;
    for (std::size_t i = Tables::kGradients; i >= 2; i -= 2)
        std::swap(permutation[i], permutation[static_cast<std::size_t>(draw15(state)) % Tables::kGradients]);
    return permutation;
}();

/// The Mersenne twister's first numbers (Matsumoto and Nishimura 1998; std::mt19937 with its own seed, which is no
/// constant).
constexpr auto kRandom = [] {
    constexpr std::size_t kState = 624, kShift = 397;
    std::array<std::uint32_t, kState> state{5489u};
    for (std::size_t i = 1; i < kState; ++i)
        state[i] = 1812433253u * (state[i - 1] ^ state[i - 1] >> 30) + static_cast<std::uint32_t>(i);
    decltype(Tables::random) random{};
    std::size_t at = 0;
    for (double& r : random) {
        const std::uint32_t joined = (state[at] & 0x80000000u) | (state[(at + 1) % kState] & 0x7fffffffu);
        std::uint32_t y = state[at] = state[(at + kShift) % kState] ^ joined >> 1 ^ (joined & 1u) * 0x9908b0dfu;
        at = (at + 1) % kState;
        y ^= y >> 11;
        y ^= y << 7 & 0x9d2c5680u;
        y ^= y << 15 & 0xefc60000u;
        y ^= y >> 18;
        r = y / 4294967296.0;
    }
    return random;
}();

}  // namespace

constexpr NoiseTables kNoiseTables{kHash, kRow, kRows, kLines, kSingleRow, kGradients.gradient, kPermutation, kRandom};

}  // namespace texture
