#pragma once

#include "render/image/codecs/write/stream_sink.h"

#include <string>
#include <vector>

namespace image {

/// Writes Radiance files: three mantissas of 8 bits and their exponent, packed by runs (Ward, Real Pixels, Graphics
/// Gems II, 1991). Three channels.
class HdrWriter final : public StreamSink<float> {
public:
    HdrWriter(const std::string& path, const FileShape& shape);
    void put(const float* levels) override;

private:
    const std::size_t width_;
    std::vector<std::uint8_t> row_;  ///< all reds, greens, blues, exponents
    std::string packed_;
};

}  // namespace image
