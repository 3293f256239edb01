#pragma once

#include "render/image/codecs/write/row_sink.h"

#include <memory>
#include <string>

namespace image {

/// A JPEG file of 1 or 3 channels, colours as fine as brightness; by libjpeg.
/// \param quality 1 to 100
std::unique_ptr<RowSink> jpeg_sink(const std::string& path, const FileShape& shape, int quality);

}  // namespace image
