#pragma once

#include "render/image/image.h"
#include "render/image/transfer_curve.h"

#include <string>

namespace image {

/// Writes a PNG with libpng itself: a picture of 80x60 takes 1 ms so, and 200 ms through OpenImageIO, nearly all of it
/// the loading of libraries for other formats. The entries that tell how samples are meant are those of POV-Ray: gAMA,
/// sRGB (perceptual) for that curve, sBIT, Software; no time, so that equal pictures are equal files.
/// `wide`: the raster's samples over the full 16 bits. Up to 8 bits are stored as 8, more as 16.
/// Throws FileError, whose text names no file.
void write_png(const std::string& path, const Raster& raster, const std::vector<std::uint16_t>& wide, const TransferCurve& file_curve,
               const char* software);

}  // namespace image
