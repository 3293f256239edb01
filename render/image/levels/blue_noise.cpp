#include "render/image/levels/blue_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace image {
namespace {

constexpr int kSide = 64, kPixels = kSide * kSide;
constexpr double kReach = 1.9;  // pixels: Ulichney's 1.5 for 32x32 is a little tight for this size

/// How crowded each place is by what is lit, on a torus.
class Crowd {
public:
    Crowd()
    {
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const int dx = std::min(x, kSide - x), dy = std::min(y, kSide - y);
                weight_[static_cast<std::size_t>(y * kSide + x)] = decay(dx * dx + dy * dy);
            }
    }
    void set(int at, bool lit)
    {
        lit_[static_cast<std::size_t>(at)] = lit;
        const int ax = at % kSide, ay = at / kSide;
        const std::int64_t sign = lit ? 1 : -1;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                crowded_[static_cast<std::size_t>(y * kSide + x)] +=
                    sign *
                    weight_[static_cast<std::size_t>(((y - ay) & (kSide - 1)) * kSide + ((x - ax) & (kSide - 1)))];
    }
    bool lit(int at) const { return lit_[static_cast<std::size_t>(at)]; }
    /// The most crowded of the lit places, or the least crowded of the dark ones.
    int extreme(bool lit) const
    {
        int best = -1;
        for (int i = 0; i < kPixels; ++i) {
            if (this->lit(i) != lit) continue;
            if (best < 0 || (lit ? crowded(i) > crowded(best) : crowded(i) < crowded(best))) best = i;
        }
        return best;
    }

private:
    /// Whole numbers, so that sums are the same on every machine.
    static std::int64_t decay(int squared)
    {
        double power = 1.0;  // exp(-squared / (2 reach^2)) by its fraction for one step, multiplied up
        constexpr double kStep = 1.0 / (2.0 * kReach * kReach);
        constexpr double kFactor = 1.0 - kStep + kStep * kStep / 2.0 - kStep * kStep * kStep / 6.0;
        for (int i = 0; i < squared && power > 1e-9; ++i) power *= kFactor;
        return static_cast<std::int64_t>(power * 1e9);
    }
    std::int64_t crowded(int at) const { return crowded_[static_cast<std::size_t>(at)]; }
    std::array<std::int64_t, kPixels> weight_{}, crowded_{};
    std::array<bool, kPixels> lit_{};
};

std::vector<float> made()
{
    Crowd crowd;
    constexpr int kFirst = kPixels / 10;
    std::uint64_t drawn = 1;
    for (int placed = 0; placed < kFirst;) {
        drawn = drawn * 6364136223846793005u + 1442695040888963407u;  // Knuth's multiplier, as in MMIX
        const int at = static_cast<int>(drawn >> 52);
        if (crowd.lit(at)) continue;
        crowd.set(at, true);
        ++placed;
    }
    for (;;) {  // spread them evenly
        const int tightest = crowd.extreme(true);
        crowd.set(tightest, false);
        const int emptiest = crowd.extreme(false);
        crowd.set(emptiest, true);
        if (emptiest == tightest) break;
    }
    std::vector<int> rank(kPixels);
    const Crowd even = crowd;
    for (int place = kFirst - 1; place >= 0; --place) {
        const int at = crowd.extreme(true);
        crowd.set(at, false);
        rank[static_cast<std::size_t>(at)] = place;
    }
    crowd = even;
    for (int place = kFirst; place < kPixels; ++place) {
        const int at = crowd.extreme(false);
        crowd.set(at, true);
        rank[static_cast<std::size_t>(at)] = place;
    }
    std::vector<float> places(kPixels);
    std::transform(rank.begin(), rank.end(), places.begin(),
                   [](int place) { return (static_cast<float>(place) + 0.5f) / static_cast<float>(kPixels); });
    return places;
}

}  // namespace

float blue_noise(int x, int y)
{
    static const std::vector<float> places = made();
    return places[static_cast<std::size_t>((y & (kSide - 1)) * kSide + (x & (kSide - 1)))];
}

}  // namespace image
