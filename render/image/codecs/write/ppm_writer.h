#pragma once

#include "render/image/codecs/write/stream_sink.h"

#include <string>

namespace image {

/// Writes PPM (3 channels) and PGM (1 channel): a largest value of 2^bits - 1; in the binary forms two bytes a sample,
/// the upper first, where bits is above 8, in the plain ones a line of numbers a pixel. By hand, for OpenImageIO 2.4
/// writes no more than 8 bits.
class PpmWriter final : public StreamSink<std::uint16_t> {
public:
    PpmWriter(const std::string& path, const FileShape& shape, bool plain);
    void put(const std::uint16_t* samples) override;

private:
    std::size_t row_samples_;
    int bits_, channels_;
    bool plain_;
    std::string bytes_;  ///< of the row at hand
};

}  // namespace image
