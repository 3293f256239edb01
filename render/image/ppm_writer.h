#pragma once

#include "render/image/image.h"

#include <string>

namespace image {

/// Writes the binary forms of PPM (3 channels) and PGM (1 channel): a largest value of 2^bits - 1, two bytes a sample, the
/// upper first, where bits is above 8. By hand, for OpenImageIO 2.4 writes no more than 8 bits.
/// Throws FileError, whose text names no file.
void write_ppm(const std::string& path, const Raster& raster, const char* software);

}  // namespace image
