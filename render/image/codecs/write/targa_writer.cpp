#include "render/image/codecs/write/targa_writer.h"

#include "render/image/codecs/shared/little_endian.h"

#include <cmath>

namespace image {

TargaWriter::TargaWriter(const std::string& path, const FileShape& shape, bool runs)
    : StreamSink(path), shape_(shape), runs_(runs)
{
    constexpr char kColors = 2, kGreys = 3, kPacked = 8, kFromAbove = 0x20, kAlphaBits = 8;
    std::string header(12, '\0');
    header[2] = static_cast<char>((shape.channels == 1 ? kGreys : kColors) + (runs ? kPacked : 0));
    add_two(header, static_cast<unsigned>(shape.width));
    add_two(header, static_cast<unsigned>(shape.height));
    header += static_cast<char>(8 * shape.channels);
    header += static_cast<char>(kFromAbove | (shape.channels == 4 ? kAlphaBits : 0));
    write(header);
}

void TargaWriter::put(const std::uint16_t* samples)
{
    pixels_.clear();
    const auto channels = static_cast<std::size_t>(shape_.channels);
    for (std::size_t x = 0; x < static_cast<std::size_t>(shape_.width); ++x, samples += channels)
        for (std::size_t c = 0; c < channels; ++c)  // blue, green, red, alpha
            pixels_ += static_cast<char>(byte_of(samples[c < 3 && channels > 1 ? 2 - c : c], shape_.bits));
    if (runs_) add_runs();
    write(runs_ ? packed_ : pixels_);
}

/// The row as packets of up to 128 pixels: one that is repeated, or some as they are.
void TargaWriter::add_runs()
{
    constexpr std::size_t kMost = 128;
    const auto width = static_cast<std::size_t>(shape_.width), size = static_cast<std::size_t>(shape_.channels);
    const auto same = [&](std::size_t a, std::size_t b) {
        return pixels_.compare(a * size, size, pixels_, b * size, size) == 0;
    };
    packed_.clear();
    for (std::size_t x = 0, count = 1; x < width; x += count) {
        for (count = 1; count < kMost && x + count < width && same(x, x + count);) ++count;
        const bool repeated = count > 1;
        if (!repeated)
            while (count < kMost && x + count < width && (x + count + 1 == width || !same(x + count, x + count + 1)))
                ++count;
        packed_ += static_cast<char>((repeated ? 0x80u : 0u) | (count - 1));
        packed_.append(pixels_, x * size, (repeated ? 1 : count) * size);
    }
}

/// The extension area says how the picture is stored, the footer where that stands.
void TargaWriter::finish()
{
    constexpr std::size_t kProgram = 426, kGamma = 478, kKind = 494;  // places
    constexpr char kAlpha = 3;
    const auto at = static_cast<std::uint32_t>(length());
    std::string rest;
    add_two(rest, kKind + 1);  // its length
    rest.resize(kProgram);
    rest += shape_.software;
    rest.resize(kGamma);
    if (shape_.curve.kind != TransferCurve::Kind::Srgb) {
        constexpr unsigned kParts = 1000;
        add_two(rest, static_cast<unsigned>(std::lround(shape_.curve.approximate_gamma() * kParts)));
        add_two(rest, kParts);
    }
    rest.resize(kKind);
    rest += shape_.channels == 4 ? kAlpha : '\0';
    add_four(rest, at);
    add_four(rest, 0);
    rest += "TRUEVISION-XFILE.";
    rest += '\0';
    write(rest);
    StreamSink::finish();
}

}  // namespace image
