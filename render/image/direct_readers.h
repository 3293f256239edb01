#pragma once

#include "render/image/picture.h"

#include <optional>
#include <string>

namespace image {

using ByteList = std::vector<std::uint8_t>;

/// Of PNG, JPEG and GIF files and most Targa files, which need no library that takes long to load and whose palettes are of
/// interest; nothing for other files. Throws FileError if the file is not there or broken.
std::optional<Picture> read_directly(const std::string& path);

/// Of the bytes of a file of that type. Throw FileError, whose text names no file.
Picture decode_png(const ByteList& bytes);  ///< with libpng
Picture decode_gif(const ByteList& bytes);  ///< the first picture (GIF89a specification, CompuServe 1990)
std::optional<Picture> decode_jpeg(const ByteList& bytes);  ///< with libjpeg; nothing for four colour components
Picture decode_targa(const ByteList& bytes);  ///< what is_plain_targa() accepts (Truevision TGA specification 2.0)

/// A Targa file has no signature: its name and the fields for a palette of 8-bit places, 8-bit greys or 24-bit colours.
bool is_plain_targa(const std::string& path, const ByteList& bytes);

}  // namespace image
