#pragma once

#include "render/image/codecs/direct_readers.h"
#include "render/image/codecs/row_sink.h"

#include <memory>
#include <string>

namespace image {

/// The module with what needs libpng, libjpeg or giflib: few runs read pictures or write JPEG, and every run would wait
/// for the libraries.
struct PictureLibraries {
    Picture (*png)(const ByteList&);
    Picture (*gif)(const ByteList&);
    std::optional<Picture> (*jpeg)(const ByteList&);
    std::unique_ptr<RowSink> (*jpeg_sink)(const std::string& path, const FileShape&, int quality);
};

inline constexpr const char* kPicturesModule = "libwhittle_pictures.so";
inline constexpr const char* kPicturesEntry = "whittle_pictures";

/// A JPEG file of 1 or 3 channels, colours at full resolution.
/// \param quality 1 to 100
std::unique_ptr<RowSink> jpeg_sink(const std::string& path, const FileShape& shape, int quality);

}  // namespace image
