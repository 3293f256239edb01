#pragma once

#include "render/image/codecs/read/direct_readers.h"
#include "render/image/codecs/write/jpeg_writer.h"

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

/// Opens the module. Throws FileError where there is none.
void open_picture_libraries();

inline constexpr const char* kPicturesModule = "libwhittle_pictures.so";
inline constexpr const char* kPicturesEntry = "whittle_pictures";

}  // namespace image
