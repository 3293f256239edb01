#pragma once

#include "numbers/instructions.h"

#include <cstdint>

namespace numbers {

/// The low bits of `bits`, in order, at the ones of the mask.
inline std::uint64_t deposited(std::uint64_t bits, std::uint64_t mask)
{
#if defined(__BMI2__)
    return _pdep_u64(bits, mask);
#else
    std::uint64_t out = 0;
    for (; mask != 0; mask &= mask - 1, bits >>= 1)
        if ((bits & 1) != 0) out |= mask & -mask;
    return out;
#endif
}

}  // namespace numbers
