#pragma once

#include "numbers/lanes.h"
#include "numbers/pack_lanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

/// The nearest of some photons parted from the others.
namespace trace {

/// Photons by distance squared and number. Behind the last there is room for kRoom more.
class PartedPhotons {
public:
    static constexpr std::size_t kRoom = 16;

    PartedPhotons(float* distances2, std::uint32_t* numbers, std::size_t count, float* scratch)
        : distance2_(distances2), number_(numbers), parted_(scratch), count_(count)
    {
        std::fill_n(distance2_ + count_, kRoom, std::numeric_limits<float>::infinity());
    }

    /// The `keep` nearest stay, of those that lie as far as the farthest of them the first ones, in their order. None
    /// is farther than the bound. \return the distance of the farthest
    float keep_nearest(std::size_t keep, float bound)
    {
        const Between between = close_in(keep, bound);
        std::size_t n = 0;
        for (std::size_t k = 0; k < count_; k += kWide) {
            const std::uint32_t here = below(k, between.high) & ~below(k, between.low);
            n += numbers::pack(here, distance2_ + k, parted_ + n);
        }
        const auto [farthest, before] = ranked(n, keep - 1 - between.nearer);
        std::size_t alike = keep - between.nearer - before;  // how many as far as the farthest stay
        std::size_t kept = 0;
        for (std::size_t k = 0; k < count_; k += kWide) {
            std::uint32_t stay = below(k, farthest);
            std::uint32_t as_far = mask(k, [far = Float(farthest)](const Float& d2) { return d2 == far; });
            for (; as_far != 0 && alike > 0; as_far &= as_far - 1, --alike) stay |= as_far & (~as_far + 1u);
            kept += numbers::pack(stay, distance2_ + k, number_ + k, distance2_ + kept, number_ + kept);
        }
        count_ = kept;
        return farthest;
    }

private:
    using Float = numbers::lanes::FloatPart;
    static constexpr std::size_t kWide = 8;

    /// The farthest that stays is not below `low`, below which there are `nearer`, but below `high`.
    struct Between {
        float low, high;
        std::size_t nearer;
    };
    /// Guesses as if they lay evenly by distance squared, as they do on a surface, a little too high and too low in
    /// turn, and half-way where that does not close in from both sides; what is left has to be put in order.
    Between close_in(std::size_t keep, float bound) const
    {
        constexpr int kGuesses = 12;
        constexpr std::size_t kFew = 12;
        constexpr float kAside = 2.5f;
        Between out{0.0f, std::nextafter(bound, std::numeric_limits<float>::infinity()), 0};
        std::size_t nearer_than_high = count_;
        int lows = 0, highs = 0;  // ends of one side in a row
        for (int i = 0; i < kGuesses && nearer_than_high - out.nearer > kFew; ++i) {
            const float wanted = static_cast<float>(keep - out.nearer) - 0.5f + (lows > 0 ? kAside : -kAside);
            const float share = lows > 1 || highs > 1 ? 0.5f
                                                      : wanted / static_cast<float>(nearer_than_high - out.nearer);
            const float guess = out.low + (out.high - out.low) * std::clamp(share, 0.01f, 0.99f);
            const std::size_t nearer = count_below(guess);
            if (nearer >= keep) {
                out.high = guess;
                nearer_than_high = nearer;
                ++highs, lows = 0;
            } else {
                out.low = guess;
                out.nearer = nearer;
                ++lows, highs = 0;
            }
        }
        return out;
    }

    std::size_t count_below(float limit) const
    {
        const Float most(limit), one(1.0f), zero(0.0f);
        const auto ones = [&](std::size_t k) {
            return xsimd::select(Float::load_unaligned(distance2_ + k) < most, one, zero);
        };
        Float even(zero), odd(zero);  // two sums wait less for each other
        for (std::size_t k = 0; k < count_; k += 2 * Float::size) {
            even += ones(k);
            odd += ones(k + Float::size);
        }
        return static_cast<std::size_t>(numbers::lanes::sum(even + odd));
    }

    struct Ranked {
        float distance2;
        std::size_t before;  ///< so many are nearer
    };
    /// What would be at this place of the n first of parted_ if they were in order. Of few each counts what is nearer,
    /// which leaves nothing for the processor to guess.
    Ranked ranked(std::size_t n, std::size_t place)
    {
        constexpr std::size_t kMany = 24;
        Ranked out{0.0f, 0};
        if (n > kMany) {
            std::nth_element(parted_, parted_ + place, parted_ + n);
            out.distance2 = parted_[place];
            for (std::size_t i = 0; i < n; ++i) out.before += parted_[i] < out.distance2 ? 1 : 0;
            return out;
        }
        std::fill_n(parted_ + n, kWide, std::numeric_limits<float>::infinity());
        for (std::size_t i = 0; i < n; ++i) {
            std::size_t nearer = 0, as_far = 0;
            for (std::size_t k = 0; k < n; k += Float::size) {
                const Float d2 = Float::load_unaligned(parted_ + k);
                nearer += static_cast<std::size_t>(std::popcount(numbers::lanes::mask(d2 < Float(parted_[i]))));
                as_far += static_cast<std::size_t>(std::popcount(numbers::lanes::mask(d2 == Float(parted_[i]))));
            }
            if (nearer <= place && place < nearer + as_far) out = {parted_[i], nearer};
        }
        return out;
    }

    template <class F>
    std::uint32_t mask(std::size_t first, F&& test) const
    {
        std::uint32_t out = 0;
        for (std::size_t i = 0; i < kWide; i += Float::size)
            out |= numbers::lanes::mask(test(Float::load_unaligned(distance2_ + first + i))) << i;
        return out;
    }
    std::uint32_t below(std::size_t first, float limit) const
    {
        return mask(first, [&](const Float& d2) { return d2 < Float(limit); });
    }

    float* distance2_;
    std::uint32_t* number_;
    float* parted_;
    std::size_t count_;
};

}  // namespace trace
