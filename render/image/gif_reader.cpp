#include "render/image/direct_readers.h"

#include <array>
#include <optional>

namespace image {
namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 30;

/// Bytes in order; past the end is an error.
class Bytes {
public:
    explicit Bytes(const ByteList& bytes) : bytes_(bytes) {}
    std::uint32_t next()
    {
        if (at_ >= bytes_.size()) throw FileError("the file ends too early");
        return bytes_[at_++];
    }
    std::uint32_t next_pair()
    {
        const std::uint32_t low = next();
        return low | next() << 8;
    }
    void skip(std::size_t count)
    {
        for (; count > 0; --count) next();
    }
    void skip_blocks()
    {
        while (const std::uint32_t size = next()) skip(size);
    }
    bool more() const { return at_ < bytes_.size(); }

private:
    const ByteList& bytes_;
    std::size_t at_ = 0;
};

/// Codes of growing length out of a chain of blocks.
class Codes {
public:
    explicit Codes(Bytes& bytes) : bytes_(bytes) {}
    std::uint32_t next(int bits)
    {
        while (held_ < bits) {
            if (left_ == 0) left_ = bytes_.next();
            if (left_ == 0) throw FileError("the pixels end too early");
            --left_;
            buffer_ |= bytes_.next() << held_;
            held_ += 8;
        }
        const std::uint32_t code = buffer_ & ((1u << bits) - 1u);
        buffer_ >>= bits;
        held_ -= bits;
        return code;
    }

private:
    Bytes& bytes_;
    std::uint32_t left_ = 0, buffer_ = 0;
    int held_ = 0;
};

/// Variable-length-code LZW: each code is a string, the string before it and one more pixel.
std::vector<std::uint8_t> unpack(Bytes& bytes, std::size_t count)
{
    constexpr int kMostBits = 12;
    const int first_bits = static_cast<int>(bytes.next());
    if (first_bits < 1 || first_bits > 8) throw FileError("its pixels have a size that no GIF has");
    const std::uint32_t clear = 1u << first_bits, stop = clear + 1, none = 1u << kMostBits;
    struct Entry {
        std::uint32_t before;
        std::uint8_t last, first;
    };
    std::array<Entry, 1u << kMostBits> table{};
    for (std::uint32_t i = 0; i < clear; ++i) table[i] = {none, static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i)};
    Codes codes(bytes);
    std::vector<std::uint8_t> out, reversed;
    std::uint32_t size = stop + 1, previous = none;
    int bits = first_bits + 1;
    while (out.size() < count) {
        const std::uint32_t code = codes.next(bits);
        if (code == stop) throw FileError("pixels are missing");
        if (code == clear) {
            size = stop + 1;
            bits = first_bits + 1;
            previous = none;
            continue;
        }
        if (code > size || (code == size && previous == none)) throw FileError("a code of its pixels means nothing");
        if (previous != none && size < none) {
            table[size] = {previous, code == size ? table[previous].first : table[code].first, table[previous].first};
            ++size;
            if (size == 1u << bits && bits < kMostBits) ++bits;
        }
        reversed.clear();
        for (std::uint32_t c = code; c != none; c = table[c].before) reversed.push_back(table[c].last);
        out.insert(out.end(), reversed.rbegin(), reversed.rend());
        previous = code;
    }
    out.resize(count);
    return out;
}

/// Rows in the order of an interlaced file, put in place.
std::vector<std::uint8_t> woven(const std::vector<std::uint8_t>& rows, std::uint32_t width, std::uint32_t height)
{
    std::vector<std::uint8_t> out(rows.size());
    std::size_t from = 0;
    constexpr std::array<std::array<std::uint32_t, 2>, 4> kPasses{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
    for (const auto& [first, step] : kPasses)
        for (std::uint32_t y = first; y < height; y += step, from += width)
            for (std::uint32_t x = 0; x < width; ++x) out[std::size_t{y} * width + x] = rows[from + x];
    return out;
}

/// As many colours as the flags of their block say.
std::vector<float> palette_of(Bytes& bytes, std::uint32_t flags)
{
    std::vector<float> palette;
    for (std::uint32_t left = 2u << (flags & 7); left > 0; --left) {
        for (int c = 0; c < 3; ++c) palette.push_back(static_cast<float>(bytes.next()) / 255.0f);
        palette.push_back(1.0f);
    }
    return palette;
}

}  // namespace

Picture decode_gif(const ByteList& file)
{
    Bytes bytes(file);
    Picture out;
    bytes.skip(6 + 4);  // signature, size of the screen
    const std::uint32_t flags = bytes.next();
    bytes.skip(2);
    if (flags & 0x80) out.palette = palette_of(bytes, flags);
    std::optional<std::uint32_t> clear;  // the transparent place in the palette
    for (;;) {
        const std::uint32_t block = bytes.next();
        if (block == '!') {
            constexpr std::uint32_t kGraphicControl = 0xf9;
            if (bytes.next() == kGraphicControl) {
                bytes.skip(1);  // its length
                const std::uint32_t control = bytes.next();
                bytes.skip(2);
                const std::uint32_t place = bytes.next();
                clear = control & 1u ? std::optional(place) : std::nullopt;
            }
            bytes.skip_blocks();
        } else if (block == ',') {
            break;
        } else {
            throw FileError("it holds no picture");
        }
    }
    bytes.skip(4);
    const std::uint32_t width = bytes.next_pair(), height = bytes.next_pair();
    out.width = static_cast<int>(width);
    out.height = static_cast<int>(height);
    const std::uint32_t own = bytes.next();
    if (own & 0x80) out.palette = palette_of(bytes, own);
    const std::uint64_t count = out.count();
    if (count > kMostPixels) throw FileError("it is too large");
    if (clear && std::size_t{*clear} * 4 + 3 < out.palette.size()) out.palette[std::size_t{*clear} * 4 + 3] = 0.0f;
    out.indices = unpack(bytes, count);
    if (own & 0x40) out.indices = woven(out.indices, width, height);
    expand_palette(out);
    return out;
}

}  // namespace image
