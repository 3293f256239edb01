#pragma once

#include "render/image/codecs/direct_readers.h"

namespace image {

/// The module with the readers of direct_readers.h that need libpng, libjpeg or giflib: few scenes have pictures, and
/// every run would wait for the libraries.
struct LibraryReaders {
    Picture (*png)(const ByteList&);
    Picture (*gif)(const ByteList&);
    std::optional<Picture> (*jpeg)(const ByteList&);
};

inline constexpr const char* kReadersModule = "libwhittle_pictures.so";
inline constexpr const char* kReadersEntry = "whittle_pictures";

}  // namespace image
