#pragma once

#include "render/image/codecs/write/stream_sink.h"

#include <string>

namespace image {

/// Writes BMP files of 24 bits, or of 32 where there is alpha, as POV-Ray's: put() takes rows from below, as the file
/// has them. By hand for the same cause as Targa files.
class BmpWriter final : public StreamSink<std::uint16_t> {
public:
    BmpWriter(const std::string& path, const FileShape& shape);
    void put(const std::uint16_t* samples) override;

private:
    const std::size_t width_, channels_;
    const int bits_;
    std::string row_;
};

}  // namespace image
