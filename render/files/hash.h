#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace files {

/// FNV-1a with 64 bits over words of 8 bytes, the last one filled up with zeros: for identities and checks.
/// \param so_far  the hash of what comes before
inline std::uint64_t hash_of(const void* bytes, std::size_t count, std::uint64_t so_far = 0xcbf29ce484222325ULL)
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

}  // namespace files
