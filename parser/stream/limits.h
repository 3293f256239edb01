#pragma once

#include <cstddef>

/// What ends a text that would never end, and tolerances of directives: the same for the reader of tokens and for
/// compiled blocks.
namespace parser {

/// Far more than POV-Ray's 98; reached only by a recursion without end.
inline constexpr std::size_t kDeepestCalls = 2000;
/// Conditionals, loops and macro calls inside each other.
inline constexpr std::size_t kMostBlocks = 10'000;
/// Expressions and blocks of the grammar inside each other: deep enough for any real scene, shallow enough for an 8 MB
/// stack also in a sanitizer build.
inline constexpr int kMostNesting = 400;

/// Of `#for`: the last value may miss the end by this much (spec 1, 9.5).
inline constexpr double kSlackOfFor = 1e-10;

/// Whether a `#for` has another pass.
inline bool for_goes_on(double value, double limit, double step)
{
    return step > 0 ? value < limit + kSlackOfFor : value > limit - kSlackOfFor;
}

}  // namespace parser
