#pragma once

#include "render/image/pixels/picture.h"

#include <optional>
#include <string>

namespace image {

using ByteList = std::vector<std::uint8_t>;

/// All of a file. This and all readers below throw FileError, whose text names no file.
ByteList bytes_of_file(const std::string& path);

/// "PNG", "TIFF", ...: what the first bytes say, or the name of a Targa file; null for what is no picture of a known
/// kind.
const char* kind_of_file(const std::string& path, const ByteList& bytes);

/// Of PNG, JPEG, GIF, PPM, PGM and Radiance files and most BMP and Targa files, which need no library that takes long
/// to load, and whose palettes and last digits are of interest; nothing for other files.
std::optional<Picture> decode_directly(const std::string& path, const ByteList& bytes);

/// Of the bytes of a file of that type.
Picture decode_png(const ByteList& bytes);                  ///< with libpng
Picture decode_gif(const ByteList& bytes);                  ///< the first picture, with giflib
std::optional<Picture> decode_jpeg(const ByteList& bytes);  ///< with libjpeg; nothing for four colour components
std::optional<Picture> decode_bmp(const ByteList& bytes);   ///< nothing for colours of 16 bits and by masks
Picture decode_pnm(const ByteList& bytes);                  ///< what is_plain_pnm() accepts
Picture decode_hdr(const ByteList& bytes);                  ///< Radiance's pixels of one exponent, rows from above
Picture decode_targa(const ByteList& bytes);  ///< what is_plain_targa() accepts (Truevision TGA specification 2.0)

/// PPM and PGM files, as text or bytes.
bool is_plain_pnm(const ByteList& bytes);

/// A Targa file has no signature: its name and the fields for a palette of 8-bit places, 8-bit greys or colours of 15,
/// 16, 24 or 32 bits.
bool is_plain_targa(const std::string& path, const ByteList& bytes);

}  // namespace image
