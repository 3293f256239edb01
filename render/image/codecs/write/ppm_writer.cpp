#include "render/image/codecs/write/ppm_writer.h"

#include <string>

namespace image {

PpmWriter::PpmWriter(const std::string& path, const FileShape& shape, bool plain)
    : StreamSink(path), row_samples_(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels)),
      bits_(shape.bits), channels_(shape.channels), plain_(plain)
{
    const char* const form = shape.channels == 1 ? plain ? "P2" : "P5" : plain ? "P3" : "P6";
    write(std::string(form) + "\n# Software: " + shape.software + '\n' + std::to_string(shape.width) + ' ' +
          std::to_string(shape.height) + '\n' + std::to_string((1 << shape.bits) - 1) + '\n');
}

void PpmWriter::put(const std::uint16_t* samples)
{
    bytes_.clear();
    const auto channels = static_cast<std::size_t>(channels_);
    for (std::size_t i = 0; i < row_samples_; ++i) {
        if (plain_) {
            bytes_ += std::to_string(samples[i]) + (i % channels + 1 == channels ? '\n' : ' ');
            continue;
        }
        if (bits_ > 8) bytes_ += static_cast<char>(samples[i] >> 8);
        bytes_ += static_cast<char>(samples[i] & 0xff);
    }
    write(bytes_);
}

}  // namespace image
