#pragma once

#include "numbers/instructions.h"

#include <bit>
#include <cstdint>

/// Rounding without a call: to single precision in one direction, as boxes and rays are for every query; to integers.
namespace numbers {

/// The float below `f`; finite or +infinity.
inline float next_below(float f)
{
    const auto bits = std::bit_cast<std::int32_t>(f);
    constexpr std::int32_t kLeastNegative = std::bit_cast<std::int32_t>(-0x1p-149f);
    return std::bit_cast<float>(bits > 0 ? bits - 1 : bits == 0 ? kLeastNegative : bits + 1);
}

/// The largest float that is not above `v`.
inline float rounded_down(double v)
{
    const auto f = static_cast<float>(v);
    return static_cast<double>(f) <= v ? f : next_below(f);
}

/// The smallest float that is not below `v`.
inline float rounded_up(double v) { return -rounded_down(-v); }

/// Towards 0; out of range the least integer, as in lanes.
inline int truncated(double v) { return _mm_cvttsd_si32(_mm_set_sd(v)); }
/// The same in 64 bits. A plain conversion is another number there on processors of another kind.
inline long long truncated_far(double v)
{
#if defined(__x86_64__)
    return static_cast<long long>(v);  // the same instruction; by its name it would keep clang from taking loops apart
#else
    return _mm_cvttsd_si64(_mm_set_sd(v));
#endif
}

}  // namespace numbers
