#pragma once

#include "tests/fuzz/target.h"

#include <random>

namespace fuzz {

/// Input `number` of those that begin with `seeds`: the seeds as they are, then seeds with a few changes. The same
/// number gives the same bytes everywhere.
class Mutator {
public:
    Mutator(const std::vector<Bytes>& seeds, std::uint32_t number) : seeds_(seeds), number_(number), random_(number) {}

    Bytes input()
    {
        if (number_ < seeds_.size()) return seeds_[number_];
        Bytes bytes = seeds_[below(seeds_.size())];
        for (std::size_t changes = 1 + below(4) * below(3); changes > 0; --changes) change(bytes);
        if (bytes.size() > kMost) bytes.resize(kMost);
        return bytes;
    }

private:
    static constexpr std::size_t kMost = std::size_t{1} << 20;

    std::size_t below(std::size_t count) { return random_() % count; }

    /// Headers stand in front: half of all changes are made there.
    std::size_t place(const Bytes& bytes)
    {
        return below(below(2) ? bytes.size() : std::min<std::size_t>(bytes.size(), 64));
    }

    void change(Bytes& bytes)
    {
        static constexpr std::uint8_t kOdd[] = {0x00, 0x01, 0x7f, 0x80, 0xff, 0x0a, 0x20, 0x30};
        if (bytes.empty()) {
            bytes.push_back(static_cast<std::uint8_t>(random_()));
            return;
        }
        const std::size_t at = place(bytes), run = std::min(bytes.size() - at, 1 + below(below(4) ? 8 : 200));
        const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(at), to = from + static_cast<std::ptrdiff_t>(run);
        switch (below(9)) {
        case 0: bytes[at] ^= static_cast<std::uint8_t>(1u << below(8)); break;
        case 1: bytes[at] = static_cast<std::uint8_t>(random_()); break;
        case 2: bytes[at] = kOdd[below(std::size(kOdd))]; break;
        case 3:
            std::fill(from, from + static_cast<std::ptrdiff_t>(std::min<std::size_t>(run, 4)),
                      kOdd[below(std::size(kOdd))]);
            break;
        case 4: bytes.erase(from, to); break;
        case 5: {
            const Bytes copy(from, to);
            bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(place(bytes)), copy.begin(), copy.end());
            break;
        }
        case 6: bytes.resize(at); break;
        case 7: {
            const Bytes& other = seeds_[below(seeds_.size())];
            const std::size_t cut = other.empty() ? 0 : below(other.size());
            bytes.insert(from, other.begin() + static_cast<std::ptrdiff_t>(cut),
                         other.begin() + static_cast<std::ptrdiff_t>(std::min(other.size(), cut + run)));
            break;
        }
        default: bytes[at] = static_cast<std::uint8_t>(bytes[at] + below(35) - 17);
        }
    }

    const std::vector<Bytes>& seeds_;
    const std::uint32_t number_;
    std::mt19937 random_;
};

}  // namespace fuzz
