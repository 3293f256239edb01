#pragma once

#include "render/texture/points/points.h"

#include <array>
#include <bit>
#include <cstdint>
#include <random>

/// Points as patterns meet them, at random, and how the bits of results are compared.
namespace texture {

inline std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v); }
inline std::uint32_t bits(float v) { return std::bit_cast<std::uint32_t>(v); }

struct Rng {
    std::mt19937 engine;
    explicit Rng(std::uint32_t seed) : engine(seed) {}
    double uniform(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine()) / 4294967296.0);
    }
    int below(int n) { return static_cast<int>(engine() % static_cast<std::uint32_t>(n)); }
    bool flip() { return below(2) == 0; }
    glm::dvec3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
};

/// Within one lattice cell, over many, as far out as warped points get, on the lattice itself, or at y = 0 or z = 0 as
/// those of terrains and pictures, of which some may have left it.
inline Points random_points(Rng& rng)
{
    Points p;
    const double spread = std::array{0.01, 1.0, 100.0, 1e6, 1e15}[static_cast<std::size_t>(rng.below(5))];
    const bool whole = rng.below(6) == 0;
    const glm::dvec3 middle = rng.vector(50.0);
    for (int i = 0, count = 1 + rng.below(kMostPoints); i < count; ++i) {
        const glm::dvec3 q = middle + rng.vector(spread);
        p.add(whole ? glm::round(q) : q);
    }
    Values* const flat[] = {nullptr, &p.y, &p.z};
    Values* const zero = flat[rng.below(3)];
    const bool all = rng.flip();
    for (std::size_t i = 0; zero != nullptr && i < p.size(); ++i)
        if (all || rng.below(20) != 0) (*zero)[i] = rng.flip() ? 0.0 : -0.0;
    p.pad();
    return p;
}

}  // namespace texture
