#pragma once

#include "render/image/codecs/write/stream_sink.h"

#include <string>

namespace image {

/// Writes Targa files of 8 bits a channel, 1, 3 or 4 of them (Truevision TGA specification 2.0), rows from above as
/// POV-Ray's, plain or in runs. By hand, for OpenImageIO takes ten times as long to load as a small picture to render.
class TargaWriter final : public StreamSink<std::uint16_t> {
public:
    TargaWriter(const std::string& path, const FileShape& shape, bool runs);
    void put(const std::uint16_t* samples) override;
    void finish() override;

private:
    void add_runs();

    const FileShape shape_;
    const bool runs_;
    std::string pixels_, packed_;  ///< of the row at hand
};

}  // namespace image
