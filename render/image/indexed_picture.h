#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace image {

/// A picture whose pixels are places in a palette, top row first. What the palette holds is not kept.
struct IndexedPicture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> indices;
};

/// The first picture of a GIF, a PNG or Targa with a palette; nothing for other files. Throws FileError if the file is broken.
std::optional<IndexedPicture> read_indexed(const std::string& path);

/// Of the bytes of a GIF file (GIF89a specification, CompuServe 1990). Throws std::runtime_error.
IndexedPicture decode_gif(const std::vector<std::uint8_t>& bytes);

}  // namespace image
