#pragma once

#include "render/solid/files/write.h"

/// 3MF through lib3mf, which stays in a module that is opened when such a file is asked for.
namespace solid {

/// A part of a 3MF file, in the space of the files, as plain memory: the module shares nothing with the program.
struct ThreeMfPart {
    const char* name;
    unsigned char color[3];  ///< sRGB
    const float* vertices;   ///< three numbers each
    std::uint32_t vertex_count;
    const std::uint32_t* triangles;  ///< three indices each
    std::uint32_t triangle_count;
    const unsigned char* colors;  ///< sRGB by vertex, three bytes each; null: `color` alone
};

inline constexpr const char* kThreeMfModule = "libwhittle_3mf.so";
inline constexpr const char* kThreeMfEntry = "whittle_write_3mf";

/// Writes; on failure false, with the reason in `reason` (cut at `room`).
using WriteThreeMf = bool (*)(const char* path, const ThreeMfPart* parts, std::uint32_t count, char* reason,
                              std::uint32_t room);

/// \param module the file of the module. Throws std::runtime_error.
void write_three_mf(const std::string& module, const std::string& path, const std::vector<FilePart>& parts);

}  // namespace solid
