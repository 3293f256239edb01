#include "render/image/codecs/read/direct_readers.h"
#include "render/image/codecs/shared/little_endian.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace image {
namespace {

constexpr std::size_t kFileHeader = 14, kOldHeader = 12, kUsualHeader = 40;

enum Packing : std::uint32_t { kPlain = 0, kRuns8 = 1, kRuns4 = 2 };

FileError ends_early() { return FileError("the BMP file is broken (it ends too early)"); }

std::uint32_t field(const ByteList& bytes, std::size_t at, std::size_t length)
{
    if (const auto number = number_at(bytes, at, length)) return *number;
    throw ends_early();
}

struct BmpHeader {
    std::size_t pixels = 0, palette = 0;  ///< where they begin
    std::size_t colors = 0, color_size = 4;
    std::int64_t width = 0, height = 0;
    std::uint32_t bits = 0, packing = kPlain;
    bool from_above = false;
};

BmpHeader header_of(const ByteList& bytes)
{
    BmpHeader out;
    const std::size_t length = field(bytes, kFileHeader, 4);
    out.pixels = field(bytes, 10, 4);
    out.palette = kFileHeader + length;
    if (length == kOldHeader) {
        out.width = field(bytes, 18, 2);
        out.height = field(bytes, 20, 2);
        out.bits = field(bytes, 24, 2);
        out.color_size = 3;
    } else {
        out.width = static_cast<std::int32_t>(field(bytes, 18, 4));
        out.height = static_cast<std::int32_t>(field(bytes, 22, 4));
        out.bits = field(bytes, 28, 2);
        out.packing = field(bytes, 30, 4);
        out.colors = field(bytes, 46, 4);
    }
    out.from_above = out.height < 0;
    out.height = std::abs(out.height);
    const std::size_t most = out.bits <= 8 ? std::size_t{1} << out.bits : 0;
    out.colors = out.colors == 0 ? most : std::min(out.colors, most);
    return out;
}

void read_palette(const ByteList& bytes, const BmpHeader& header, Picture& out)
{
    constexpr float kMost = 255.0f;
    for (std::size_t i = 0; i < header.colors; ++i) {
        const std::size_t at = header.palette + i * header.color_size;
        if (at + 3 > bytes.size()) throw ends_early();
        for (std::size_t c = 3; c-- > 0;) out.palette.push_back(static_cast<float>(bytes[at + c]) / kMost);
        out.palette.push_back(1.0f);
    }
    out.palette.resize(std::size_t{4} << header.bits, 0.0f);  // colours that the file does not name
    for (std::size_t i = header.colors; i < out.palette.size() / 4; ++i) out.palette[4 * i + 3] = 1.0f;
}

/// Rows in the order of the file. Of colours: `channels` levels a pixel, red first; else places in the palette.
ByteList plain_rows(const ByteList& bytes, const BmpHeader& header, std::size_t channels)
{
    const auto wide = static_cast<std::size_t>(header.width), high = static_cast<std::size_t>(header.height);
    const std::size_t row = (wide * header.bits + 31) / 32 * 4;
    if (header.pixels > bytes.size() || (bytes.size() - header.pixels) / row < high - 1 ||
        bytes.size() - header.pixels < row * (high - 1) + (wide * header.bits + 7) / 8)
        throw ends_early();
    ByteList out;
    out.reserve(wide * high * std::max<std::size_t>(channels, 1));
    for (std::size_t y = 0; y < high; ++y) {
        const std::uint8_t* const from = &bytes[header.pixels + y * row];
        for (std::size_t x = 0; x < wide; ++x) {
            if (channels == 0) {
                const std::size_t bit = x * header.bits, shift = 8 - header.bits - bit % 8;
                out.push_back(static_cast<std::uint8_t>(from[bit / 8] >> shift & ((1u << header.bits) - 1u)));
                continue;
            }
            const std::uint8_t* const pixel = from + x * channels;
            for (std::size_t c = 3; c-- > 0;) out.push_back(pixel[c]);
            if (channels == 4) out.push_back(pixel[3]);
        }
    }
    return out;
}

/// Rows that are packed: a count and a value, or 0 and what it is: the end of a row or of all, a step, values as they
/// are. What is passed over has the last colour of the palette (spec 4, 12.10).
class Runs {
public:
    Runs(const ByteList& bytes, const BmpHeader& header)
        : bytes_(bytes), header_(header), wide_(static_cast<std::size_t>(header.width)),
          high_(static_cast<std::size_t>(header.height)), at_(header.pixels)
    {}

    ByteList unpacked()
    {
        out_.assign(wide_ * high_, static_cast<std::uint8_t>(std::max<std::size_t>(header_.colors, 1) - 1));
        while (y_ < high_) {
            const std::size_t count = next(), value = next();
            if (count > 0) add(count, [&](std::size_t) { return static_cast<std::uint8_t>(value); });
            else if (value == 0) end_row();
            else if (value == 1) break;
            else if (value == 2) step();
            else copy(value);
        }
        return std::move(out_);
    }

private:
    std::uint8_t next()
    {
        if (at_ >= bytes_.size()) throw ends_early();
        return bytes_[at_++];
    }
    void end_row()
    {
        x_ = 0;
        ++y_;
    }
    void step()
    {
        x_ += next();
        y_ += next();
    }
    void copy(std::size_t count)
    {
        const bool half = header_.packing == kRuns4;
        const std::size_t first = at_, length = half ? (count + 1) / 2 : count;
        if (first > bytes_.size() || bytes_.size() - first < length) throw ends_early();
        add(count, [&](std::size_t i) { return bytes_[first + (half ? i / 2 : i)]; });
        at_ = first + (length + 1) / 2 * 2;
    }
    /// Pixels of one row; byte(i) holds the i-th, of 4 bits with the one before or after.
    template <class Byte>
    void add(std::size_t count, Byte&& byte)
    {
        for (std::size_t i = 0; i < count; ++i, ++x_) {
            if (x_ >= wide_ || y_ >= high_) continue;
            const std::uint8_t value = byte(i);
            const bool half = header_.packing == kRuns4;
            out_[y_ * wide_ + x_] = static_cast<std::uint8_t>(!half ? value : i % 2 == 0 ? value >> 4 : value & 15);
        }
    }

    const ByteList& bytes_;
    const BmpHeader& header_;
    const std::size_t wide_, high_;
    std::size_t at_, x_ = 0, y_ = 0;
    ByteList out_;
};

}  // namespace

std::optional<Picture> decode_bmp(const ByteList& bytes)
{
    constexpr std::size_t kMostPixelsPerByte = 255, kSmall = 65536;
    constexpr std::int64_t kMostSide = 1 << 24;
    const BmpHeader header = header_of(bytes);
    const bool indexed = header.bits == 1 || header.bits == 4 || header.bits == 8;
    const bool known = header.packing == kPlain ? indexed || header.bits == 24 || header.bits == 32
                                                : (header.packing == kRuns8 && header.bits == 8) ||
                                                      (header.packing == kRuns4 && header.bits == 4);
    if (!known || (header.palette < kFileHeader + kUsualHeader && header.color_size == 4)) return std::nullopt;
    if (header.width <= 0 || header.height <= 0 || header.width > kMostSide || header.height > kMostSide)
        throw FileError("the BMP file holds no picture");
    Picture out;
    out.width = static_cast<int>(header.width);
    out.height = static_cast<int>(header.height);
    if (out.count() > kSmall + kMostPixelsPerByte * bytes.size()) throw ends_early();
    out.channels = indexed ? 0 : static_cast<int>(header.bits / 8);
    ByteList rows = header.packing == kPlain ? plain_rows(bytes, header, static_cast<std::size_t>(out.channels))
                                             : Runs(bytes, header).unpacked();
    if (!header.from_above) {
        const std::size_t row = rows.size() / static_cast<std::size_t>(out.height);
        for (std::size_t low = 0, high = rows.size() - row; low < high; low += row, high -= row)
            std::swap_ranges(rows.begin() + static_cast<std::ptrdiff_t>(low),
                             rows.begin() + static_cast<std::ptrdiff_t>(low + row),
                             rows.begin() + static_cast<std::ptrdiff_t>(high));
    }
    if (indexed) {
        read_palette(bytes, header, out);
        out.indices = std::move(rows);
        finish_palette(out);
    } else {
        out.samples = {std::move(rows), 255};
    }
    return out;
}

}  // namespace image
