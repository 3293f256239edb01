#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// What a picture carries: its options as lines of an INI file, and the files that it was made of.
struct Carried {
    struct File {
        std::string name;  ///< below the folder that it is taken out into: "library/1/colors.inc"
        std::string bytes;
    };
    std::string folder;  ///< from which the scene's names start, where the options go; empty: the top
    std::vector<std::string> options;
    std::vector<File> files;  ///< the scene first
};

inline constexpr std::size_t kMostCarriedBytes = std::size_t{64} << 20;  ///< of all files together
inline constexpr std::size_t kMostCarriedFiles = 10'000;

/// As it stands in a picture: records, compressed by zlib. The same bytes for the same contents.
std::string packed(const Carried& carried);

/// Throws std::runtime_error for bytes that are damaged, of another form, longer than the limits above, or whose names
/// leave the folder.
Carried unpacked(std::string_view bytes);

/// Whether a name stays below the folder that it is taken out into: relative, without "..", "." and empty parts,
/// without control characters and backslashes, no part longer than file systems take.
bool is_inner_name(std::string_view name);

}  // namespace app
