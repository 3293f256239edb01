#pragma once

#include "render/image/files.h"
#include "render/image/codecs/write/row_sink.h"

#include <memory>
#include <string>

namespace image {

inline constexpr const char* kSoftware = "Whittle";

struct TypeFacts {
    FileType type;
    const char* extension;
    bool alpha, greyscale, linear_light, sixteen_bits;
    int largest_side;  ///< that its header can hold
    int packing;       ///< few pictures get smaller than one part in so many of their plain bytes
};

const TypeFacts& facts(FileType type);

/// The file that takes integers, or light.
/// \param quick  see FileSettings
std::unique_ptr<RowSink> integer_sink(FileType type, const std::string& path, const FileShape& shape, int jpeg_quality,
                                      bool quick);
std::unique_ptr<LevelSink> level_sink(IoLoader& loader, FileType type, const std::string& path, const FileShape& shape);

}  // namespace image
