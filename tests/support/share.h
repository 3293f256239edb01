#pragma once

namespace test {

/// The sanitizers take ten times as long and watch memory and overflow, not laws: one case in eight is run there.
#ifdef __SANITIZE_ADDRESS__
inline constexpr int kEvery = 8;
#else
inline constexpr int kEvery = 1;
#endif

/// Of `cases` those that are run.
constexpr int share(int cases) { return (cases + kEvery - 1) / kEvery; }

}  // namespace test
