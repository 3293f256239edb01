#pragma once

#include "render/image/codecs/write/row_sink.h"

#include <memory>
#include <string>

namespace image {

/// How hard zlib tries. Usual: a picture of 800x600 took 57 ms to write, 176 ms with zlib's own choice, and was 15 %
/// larger. None: as fast as the disk, for pictures that nobody keeps.
enum class PngEffort { None = 0, Usual = 2 };  // of zlib's levels

/// Writes a PNG with zlib alone (PNG specification, 2nd ed.). libpng tries a row's filters a byte at a time, which took
/// more than all else of a plain picture but its tracing. The entries that tell how samples are meant are those of
/// POV-Ray: gAMA, sRGB (perceptual) for that curve, sBIT, Software; no time, so that equal pictures are equal files. Up
/// to 8 bits are stored as 8, more as 16.
class PngWriter final : public RowSink {
public:
    PngWriter(const std::string& path, const FileShape& shape, PngEffort effort = PngEffort::Usual);
    ~PngWriter() override;
    void put(const std::uint16_t* samples) override;
    void finish() override;

private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace image
