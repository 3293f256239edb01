#pragma once

#include "numbers/float_mask.h"
#include "render/kernel/tile/hit_mask.h"

#include <array>

namespace trace {

using numbers::FloatMask;
using numbers::lanes::FloatPart;
using numbers::lanes::kFloatPart;

/// A mask as a number a lane, 0 or 1: what loops over all hits choose by without a branch.
struct LaneMask {
    alignas(64) std::array<std::uint32_t, csg::kTileRays> of;

    explicit LaneMask(HitMask mask)
    {
        const auto low = static_cast<std::uint32_t>(mask), high = static_cast<std::uint32_t>(mask >> 32);
        for (std::uint32_t k = 0; k < 32; ++k) {
            of[k] = low >> k & 1u;
            of[k + 32] = high >> k & 1u;
        }
    }
    std::uint32_t operator[](std::size_t k) const { return of[k]; }
};

/// f(i, which of them are in the mask) for the first `count` places of a tile as each_place() rounds them, a register
/// of floats from i on at a time. For arrays of which the compiler cannot tell that they lie apart.
template <class F>
inline void each_part(int count, HitMask mask, F&& f)
{
    constexpr std::size_t kBlock = 16, kPart = static_cast<std::size_t>(kFloatPart);
    for (std::size_t first = 0; first < static_cast<std::size_t>(count); first += kBlock)
        for (std::size_t i = first; i < first + kBlock; i += kPart) f(i, FloatMask(mask >> i));
}
/// The same for the registers alone that have some of the mask: a page of rows often has few of a tile's hits.
template <class F>
inline void each_part_of(HitMask mask, F&& f)
{
    constexpr std::size_t kPart = static_cast<std::size_t>(kFloatPart);
    constexpr HitMask kRegister = (HitMask{1} << kPart) - 1;
    for (std::size_t i = 0; i < csg::kTileRays; i += kPart)
        if ((mask >> i & kRegister) != 0) f(i, FloatMask(mask >> i));
}
/// Places of an array of floats from i on.
inline FloatPart part(const std::array<float, csg::kTileRays>& of, std::size_t i)
{
    return FloatPart::load_aligned(of.data() + i);
}

}  // namespace trace
