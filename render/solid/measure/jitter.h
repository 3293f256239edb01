#pragma once

#include "numbers/random.h"

namespace solid {

/// Numbers from 0 to 1 that depend on the key alone: the same on every run.
inline double jitter(std::uint64_t key)
{
    return static_cast<double>(numbers::stirred(key + 0x9e3779b97f4a7c15u) >> 11) * 0x1p-53;
}

}  // namespace solid
