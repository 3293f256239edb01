#pragma once

#include "render/image/picture.h"

#include <optional>
#include <string>

namespace image {

using ByteList = std::vector<std::uint8_t>;

/// Of PNG, GIF and Targa files with a palette, which need no library that takes long to load and whose palettes are of
/// interest; nothing for other files. Throws FileError if the file is not there or broken.
std::optional<Picture> read_directly(const std::string& path);

/// Of the bytes of a file of that type. Throw FileError, whose text names no file.
Picture decode_png(const ByteList& bytes);  ///< with libpng
Picture decode_gif(const ByteList& bytes);  ///< the first picture (GIF89a specification, CompuServe 1990)
Picture decode_targa_palette(const ByteList& bytes);  ///< (Truevision TGA specification 2.0)

}  // namespace image
