#pragma once

#include "tests/csg/support.h"

#include <catch2/catch.hpp>

namespace csg_test {

/// f(degree, random numbers) for each degree from `first` to `last` and each seed; a failure tells both.
template <class F>
void each_degree(int first, int last, std::uint32_t seeds, F&& f)
{
    for (int degree = first; degree <= last; ++degree)
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            INFO("degree " << degree << ", seed " << seed);
            Rng rng(1000u * static_cast<std::uint32_t>(degree) + seed);
            f(degree, rng);
        }
}

}  // namespace csg_test
