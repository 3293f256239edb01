#pragma once

#include <cstdint>

namespace solid {

/// Numbers from 0 to 1 that depend on the key alone: the same on every run (a mix of Steele and Vigna).
inline double jitter(std::uint64_t key)
{
    key += 0x9e3779b97f4a7c15u;
    key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9u;
    key = (key ^ (key >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((key ^ (key >> 31)) >> 11) * 0x1p-53;
}

}  // namespace solid
