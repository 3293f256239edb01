#include "render/image/codecs/write/bmp_writer.h"

#include "render/image/codecs/shared/little_endian.h"

namespace image {
namespace {

/// Bytes of a row: of whole groups of four.
std::size_t row_length(std::size_t width, std::size_t channels)
{
    return (width * (channels == 4 ? 4 : 3) + 3) / 4 * 4;
}

}  // namespace

BmpWriter::BmpWriter(const std::string& path, const FileShape& shape)
    : StreamSink(path), width_(static_cast<std::size_t>(shape.width)),
      channels_(static_cast<std::size_t>(shape.channels)), bits_(shape.bits)
{
    constexpr std::uint32_t kHeaders = 54, kSecond = 40;
    const auto pixels =
        static_cast<std::uint32_t>(row_length(width_, channels_) * static_cast<std::size_t>(shape.height));
    std::string header = "BM";
    add_four(header, kHeaders + pixels);
    add_four(header, 0);
    add_four(header, kHeaders);
    add_four(header, kSecond);
    add_four(header, static_cast<std::uint32_t>(shape.width));
    add_four(header, static_cast<std::uint32_t>(shape.height));  // above 0: rows from below
    add_two(header, 1);
    add_two(header, channels_ == 4 ? 32 : 24);
    add_four(header, 0);  // as they are
    add_four(header, pixels);
    header.resize(kHeaders);
    write(header);
}

void BmpWriter::put(const std::uint16_t* samples)
{
    row_.clear();
    for (std::size_t x = 0; x < width_; ++x, samples += channels_) {
        for (std::size_t c = 3; c-- > 0;) row_ += static_cast<char>(byte_of(samples[channels_ > 1 ? c : 0], bits_));
        if (channels_ == 4) row_ += static_cast<char>(byte_of(samples[3], bits_));
    }
    row_.resize(row_length(width_, channels_));
    write(row_);
}

}  // namespace image
