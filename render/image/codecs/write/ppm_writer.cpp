#include "render/image/codecs/write/ppm_writer.h"

#include "render/image/pixels/passing_failure.h"

#include <cerrno>
#include <cstring>

namespace image {

PpmWriter::PpmWriter(const std::string& path, const FileShape& shape, bool plain)
    : out_(path, std::ios::binary),
      row_samples_(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels)), bits_(shape.bits),
      channels_(shape.channels), plain_(plain)
{
    out_ << (shape.channels == 1 ? plain ? "P2" : "P5"
             : plain             ? "P3"
                                 : "P6")
         << "\n# Software: " << shape.software << '\n'
         << shape.width << ' ' << shape.height << '\n'
         << (1 << shape.bits) - 1 << '\n';
    if (!out_) fail_by_system(errno);
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
    if (!out_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()))) fail_by_system(errno);
}

void PpmWriter::finish()
{
    if (!out_.flush()) fail_by_system(errno);
}

}  // namespace image
