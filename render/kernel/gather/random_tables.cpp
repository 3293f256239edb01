#include "render/kernel/gather/random_tables.h"

#include <random>

namespace trace {

const std::vector<double>& JitterStream::table()
{
    static const std::vector<double> numbers = [] {
        std::mt19937 twister;  // its usual seed
        std::vector<double> made(kLength);
        for (double& number : made) number = static_cast<double>(twister()) / 4294967296.0;
        return made;
    }();
    return numbers;
}

LibraryRandom::LibraryRandom()
{
    // Park and Miller's generator fills the words, from 1 on; ten times their number is thrown away.
    constexpr std::int64_t kFactor = 16807, kModulus = 2147483647;
    std::int64_t word = 1;
    for (std::uint32_t& to : words_) {
        to = static_cast<std::uint32_t>(word);
        word = kFactor * word % kModulus;
    }
    for (std::size_t i = 0; i < 10 * kWords; ++i) draw();
}

std::uint32_t LibraryRandom::draw()
{
    // Word i becomes the sum of itself, 31 numbers ago, and the one 3 numbers ago.
    std::uint32_t& word = words_[at_];
    word += words_[(at_ + kWords - kTap) % kWords];
    at_ = (at_ + 1) % kWords;
    return word >> 1;
}

}  // namespace trace
