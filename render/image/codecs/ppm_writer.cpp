#include "render/image/codecs/ppm_writer.h"

#include "render/image/pixels/passing_failure.h"

#include <cerrno>
#include <cstring>

namespace image {

PpmWriter::PpmWriter(const std::string& path, const FileShape& shape)
    : out_(path, std::ios::binary),
      row_samples_(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.channels)), bits_(shape.bits)
{
    out_ << (shape.channels == 1 ? "P5" : "P6") << "\n# Software: " << shape.software << '\n'
         << shape.width << ' ' << shape.height << '\n'
         << (1 << shape.bits) - 1 << '\n';
    if (!out_) fail_by_system(errno);
}

void PpmWriter::put(const std::uint16_t* samples)
{
    bytes_.clear();
    for (std::size_t i = 0; i < row_samples_; ++i) {
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
