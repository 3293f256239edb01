#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace files {

inline constexpr std::uint64_t kHashOfNothing = 0xcbf29ce484222325ULL;

/// FNV-1a with 64 bits over words of 8 bytes, the last one filled up with zeros: for identities and checks.
/// \param so_far  the hash of what comes before
inline std::uint64_t hash_of(const void* bytes, std::size_t count, std::uint64_t so_far = kHashOfNothing)
{
    const auto* byte = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, byte + i, std::min(sizeof word, count - i));
        so_far = (so_far ^ word) * 0x100000001b3ULL;
        so_far ^= so_far >> 32;  // a product never carries upper bits down
    }
    return so_far;
}

/// With its size, else zeros at the end would not count.
inline std::uint64_t hash_of_text(std::string_view text)
{
    const std::uint64_t size = text.size();
    return hash_of(&size, sizeof size, hash_of(text.data(), text.size()));
}

/// hash_of_text of all that stands in a file; of one that cannot be read, of nothing.
std::uint64_t hash_of_file(const std::string& path);

}  // namespace files
