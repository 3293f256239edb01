#include "render/image/codecs/write/hdr_writer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace image {
namespace {

constexpr std::size_t kChannels = 4, kLeastWidth = 8, kMostWidth = 0x7fff;  // of rows that are packed

std::array<std::uint8_t, kChannels> pixel_of(const float* levels)
{
    constexpr float kDarkest = 1e-32f, kBrightest = 1e38f;  // what exponents of 8 bits reach
    std::array<float, 3> within{};
    for (std::size_t c = 0; c < 3; ++c) within[c] = levels[c] > 0.0f ? std::min(levels[c], kBrightest) : 0.0f;
    const float brightest = *std::max_element(within.begin(), within.end());
    if (brightest < kDarkest) return {};
    int exponent = 0;
    const float scale = std::frexp(brightest, &exponent) * 256.0f / brightest;
    const auto mantissa = [&](float level) { return static_cast<std::uint8_t>(std::min(level * scale, 255.0f)); };
    return {mantissa(within[0]), mantissa(within[1]), mantissa(within[2]), static_cast<std::uint8_t>(exponent + 128)};
}

/// One channel of a row: bytes that are repeated four times or more, and others as they are.
void pack(const std::uint8_t* bytes, std::size_t count, std::string& out)
{
    constexpr std::size_t kLeastRepeated = 4, kMostRepeated = 127, kMostPlain = 128;
    const auto run_at = [&](std::size_t at) {
        std::size_t length = 1;
        while (length < kMostRepeated && at + length < count && bytes[at + length] == bytes[at]) ++length;
        return length;
    };
    for (std::size_t at = 0; at < count;) {
        if (const std::size_t run = run_at(at); run >= kLeastRepeated) {
            out += static_cast<char>(kMostPlain + run);
            out += static_cast<char>(bytes[at]);
            at += run;
            continue;
        }
        std::size_t end = at + 1;
        while (end < count && end - at < kMostPlain && run_at(end) < kLeastRepeated) ++end;
        out += static_cast<char>(end - at);
        for (; at < end; ++at) out += static_cast<char>(bytes[at]);
    }
}

}  // namespace

HdrWriter::HdrWriter(const std::string& path, const FileShape& shape)
    : StreamSink(path), width_(static_cast<std::size_t>(shape.width)), row_(kChannels * width_)
{
    write(std::string("#?RADIANCE\nSOFTWARE=") + shape.software + "\nFORMAT=32-bit_rle_rgbe\n\n-Y " +
          std::to_string(shape.height) + " +X " + std::to_string(shape.width) + '\n');
}

void HdrWriter::put(const float* levels)
{
    const bool packs = width_ >= kLeastWidth && width_ <= kMostWidth;
    for (std::size_t x = 0; x < width_; ++x) {
        const auto pixel = pixel_of(levels + 3 * x);
        for (std::size_t c = 0; c < kChannels; ++c) row_[packs ? c * width_ + x : kChannels * x + c] = pixel[c];
    }
    packed_.clear();
    if (packs) {
        packed_ = {2, 2, static_cast<char>(width_ >> 8), static_cast<char>(width_ & 0xff)};
        for (std::size_t c = 0; c < kChannels; ++c) pack(&row_[c * width_], width_, packed_);
    } else {
        packed_.assign(row_.begin(), row_.end());
    }
    write(packed_);
}

}  // namespace image
