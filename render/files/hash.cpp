#include "render/files/hash.h"

#include <array>
#include <fstream>

namespace files {

std::uint64_t hash_of_file(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::array<char, 1 << 16> some;  // whole words, but for the last
    std::uint64_t size = 0, hash = kHashOfNothing;
    while (in.read(some.data(), some.size()) || in.gcount() > 0) {
        const auto count = static_cast<std::size_t>(in.gcount());
        hash = hash_of(some.data(), count, hash);
        size += count;
    }
    return hash_of(&size, sizeof size, hash);
}

}  // namespace files
