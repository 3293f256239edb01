#pragma once

#include "render/image/codecs/row_sink.h"

#include <fstream>
#include <string>

namespace image {

/// Writes the binary forms of PPM (3 channels) and PGM (1 channel): a largest value of 2^bits - 1, two bytes a sample,
/// the upper first, where bits is above 8. By hand, for OpenImageIO 2.4 writes no more than 8 bits.
class PpmWriter final : public RowSink {
public:
    PpmWriter(const std::string& path, const FileShape& shape);
    void put(const std::uint16_t* samples) override;
    void finish() override;

private:
    std::ofstream out_;
    std::size_t row_samples_;
    int bits_;
    std::string bytes_;  ///< of the row at hand
};

}  // namespace image
