#pragma once

#include "numbers/lane_power.h"
#include "render/texture/finish.h"
#include "render/kernel/tile/row_page.h"

#include <cstdint>

/// Highlights of a tile's hits under one light, in vector lanes. The cosines have
/// the bits of texture::phong and texture::specular, the powers are within 1e-13 of theirs
/// (tests/render/trace/highlight_test.cpp).
namespace trace {

/// Vectors of three components, one in each lane.
struct LaneVectors {
    numbers::lanes::Double x, y, z;
};

/// SpecularLobe of one vector of lanes.
struct LaneLobe {
    numbers::lanes::Double phong, phong_size, specular, exponent;
};

/// Strengths of highlights of rays along `d` about normals `n` toward `l` (unit): texture::phong + texture::specular,
/// but for the powers. Of lanes that are not asked some number.
inline numbers::lanes::Double highlight_strengths(const LaneVectors& d, const LaneVectors& n, const LaneVectors& l,
                                                  const LaneLobe& lobe, std::uint32_t asked)
{
    using numbers::lanes::Double;
    const Double zero(0.0), one(1.0);
    // Zero where the highlight vanishes (texture::highlight_vanishes) or nobody asks.
    const auto term = [&](const auto& on, const Double& cosine, const Double& exponent, const Double& amount) {
        const auto seen = on & (exponent * (one - cosine) <= Double(texture::kVanishes));
        if ((numbers::lanes::mask(seen) & asked) == 0) return zero;
        return xsimd::select(seen, amount * numbers::lanes::power(xsimd::select(seen, cosine, one), exponent), zero);
    };
    const auto has_phong = lobe.phong > zero, has_specular = lobe.specular > zero;
    Double sum = zero;
    if ((numbers::lanes::mask(has_phong) & asked) != 0) {
        const Double twice = Double(2.0) * (d.x * n.x + d.y * n.y + d.z * n.z);
        const Double mx = d.x - twice * n.x, my = d.y - twice * n.y, mz = d.z - twice * n.z;
        const Double cosine = mx * l.x + my * l.y + mz * l.z;
        const auto cut = (lobe.phong_size >= Double(60.0)) & (cosine <= Double(0.0008));  // texture::phong_vanishes
        sum = term(has_phong & (cosine > zero) & !cut, cosine, lobe.phong_size, lobe.phong);
    }
    if ((numbers::lanes::mask(has_specular) & asked) != 0) {
        const Double hx = l.x - d.x, hy = l.y - d.y, hz = l.z - d.z;
        const Double cosine = (hx * n.x + hy * n.y + hz * n.z) / xsimd::sqrt(hx * hx + hy * hy + hz * hz);
        sum = sum + term(has_specular & (cosine > zero), cosine, lobe.exponent, lobe.specular);
    }
    return sum;
}

/// The same for the hits of a mask; those of the others are some number. n: x, y and z of the normals.
inline void find_highlights(const csg::RayTile& rays, const double* const (&n)[3], const TileLight& light,
                            const SpecularLobe& lobe, HitMask hits, TileLanes& strength)
{
    using numbers::lanes::Double;
    constexpr HitMask kVector = (HitMask{1} << numbers::lanes::kDoubles) - 1;
    for (int i = 0; i < rays.count; i += numbers::lanes::kDoubles) {
        const auto asked = static_cast<std::uint32_t>(hits >> i & kVector);
        if (asked == 0) {
            Double(0.0).store_aligned(strength.data() + i);
            continue;
        }
        const auto at = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
        const auto normal = [i, &n](int c) { return Double::load_aligned(n[c] + i); };
        highlight_strengths({at(rays.dx), at(rays.dy), at(rays.dz)}, {normal(0), normal(1), normal(2)},
                            {at(light.x), at(light.y), at(light.z)},
                            {at(lobe.phong), at(lobe.phong_size), at(lobe.specular), at(lobe.exponent)}, asked)
            .store_aligned(strength.data() + i);
    }
}

}  // namespace trace
