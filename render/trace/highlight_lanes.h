#pragma once

#include "render/texture/finish.h"
#include "render/trace/pigment_batch.h"
#include "render/trace/shade_lanes.h"

#include <cstdint>

/// Highlights of a tile's hits under one light, in vector lanes. Compiled once per instruction set. The cosines have the bits of
/// texture::phong and texture::specular, the powers are within 1e-13 of theirs (tests/render/trace/highlight_test.cpp).
namespace trace {

/// ln 2; the high part times an exponent is exact.
inline constexpr double kLn2High = 0x1.62e42fefa38p-1, kLn2Low = 0x1.ef35793c7673p-45;

/// ln c of positive numbers by 2 artanh((c - 1) / (c + 1)). Sums and products alone, not xsimd's fused ones: the same bits
/// for every instruction set.
inline csg::lanes::Double logarithm(const csg::lanes::Double& c)
{
    using csg::lanes::Double;
    xsimd::batch<std::int64_t> exponent;
    const Double half = xsimd::frexp(c, exponent);                                     // in [0.5, 1)
    const auto low = half < Double(0x1.6a09e667f3bcdp-1);
    const Double m = xsimd::select(low, half + half, half), e = xsimd::to_float(exponent) - xsimd::select(low, Double(1.0), Double(0.0));
    const Double f = (m - 1.0) / (m + 1.0), s = f * f;
    Double sum(1.0 / 23.0);
    for (int k = 21; k > 1; k -= 2) sum = sum * s + 1.0 / k;
    return e * kLn2High + (e * kLn2Low + 2.0 * (f + f * s * sum));
}

/// e^y for -700 < y <= 700, by its series about the nearest power of 2.
inline csg::lanes::Double exponential(const csg::lanes::Double& y)
{
    using csg::lanes::Double;
    const Double k = xsimd::nearbyint(y * 0x1.71547652b82fep0);
    const Double r = (y - k * kLn2High) - k * kLn2Low;
    Double sum(1.0 / 6227020800.0);   // 1 / 13!
    double inverse = 1.0 / 479001600.0;
    for (int i = 12; i >= 0; --i) {
        sum = sum * r + inverse;
        inverse *= i;
    }
    return xsimd::ldexp(sum, xsimd::to_int(k));
}

/// c^n of each pair, 0 < c <= 1; a multiple of csg::lanes::kDoubles, aligned.
inline void powers(const double* c, const double* n, std::size_t count, double* out)
{
    using csg::lanes::Double;
    for (std::size_t i = 0; i < count; i += csg::lanes::kDoubles)
        exponential(xsimd::max(Double::load_aligned(n + i) * logarithm(Double::load_aligned(c + i)), Double(-700.0))).store_aligned(out + i);
}

/// Asked for hit after hit, answered in the same order after run().
class Highlights {
public:
    /// The cosines that highlights are powers of, for hits 0 <= i < count: of the halfway vector and of the mirrored ray. n: x, y
    /// and z of the normals.
    void cosines(const csg::RayTile& rays, const double* const (&n)[3], const TileLight& light, int count)
    {
        using csg::lanes::Double;
        asked_ = powers_ = told_ = next_power_ = 0;
        for (int i = 0; i < count; i += csg::lanes::kDoubles) {
            const auto at = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
            const Double dx = at(rays.dx), dy = at(rays.dy), dz = at(rays.dz), nx = Double::load_aligned(n[0] + i), ny = Double::load_aligned(n[1] + i), nz = Double::load_aligned(n[2] + i),
                         lx = at(light.x), ly = at(light.y), lz = at(light.z);
            const Double hx = lx - dx, hy = ly - dy, hz = lz - dz;
            ((hx * nx + hy * ny + hz * nz) / xsimd::sqrt(hx * hx + hy * hy + hz * hz)).store_aligned(specular_.data() + i);
            const Double twice = Double(2.0) * (dx * nx + dy * ny + dz * nz);
            const Double mx = dx - twice * nx, my = dy - twice * ny, mz = dz - twice * nz;
            (mx * lx + my * ly + mz * lz).store_aligned(phong_.data() + i);
        }
    }

    /// The finish at hit k.
    void ask(std::size_t k, const texture::Finish& finish)
    {
        std::uint8_t count = 0;
        if (finish.phong > 0.0f && !texture::phong_vanishes(finish, phong_[k])) count += add(phong_[k], finish.phong_size, finish.phong);
        if (finish.specular > 0.0f && specular_[k] > 0.0) count += add(specular_[k], finish.specular_exponent, finish.specular);
        of_hit_[asked_++] = count;
    }

    void run()
    {
        for (std::size_t i = powers_; i % csg::lanes::kDoubles != 0; ++i) base_[i] = exponent_[i] = 1.0;
        powers(base_.data(), exponent_.data(), powers_, base_.data());
    }

    /// Strength of the next hit's highlight.
    double next()
    {
        double strength = 0.0;
        for (std::uint8_t i = of_hit_[told_++]; i > 0; --i, ++next_power_) strength += amount_[next_power_] * base_[next_power_];
        return strength;
    }

private:
    static constexpr std::size_t kMost = csg::kTileRays;

    std::uint8_t add(double cosine, float exponent, float amount)
    {
        const auto n = static_cast<double>(exponent);
        if (texture::highlight_vanishes(cosine, n)) return 0;
        base_[powers_] = cosine;
        exponent_[powers_] = n;
        amount_[powers_++] = static_cast<double>(amount);
        return 1;
    }

    alignas(64) TileLanes specular_, phong_;
    alignas(64) std::array<double, 2 * kMost> base_, exponent_;
    std::array<double, 2 * kMost> amount_;
    std::array<std::uint8_t, kMost> of_hit_;
    std::size_t asked_ = 0, powers_ = 0, told_ = 0, next_power_ = 0;
};

}  // namespace trace
