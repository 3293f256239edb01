#pragma once

namespace test {

/// Of `cases` those that are run: all of them, or an eighth under the sanitizers, which take ten times as long and
/// watch memory and overflow, not laws.
constexpr int share(int cases)
{
#ifdef __SANITIZE_ADDRESS__
    return (cases + 7) / 8;
#else
    return cases;
#endif
}

/// Of things in a row one in so many is run.
constexpr unsigned kEvery = 8 / static_cast<unsigned>(share(8));

}  // namespace test
