#include "render/image/codecs/read/direct_readers.h"
#include "render/image/codecs/shared/little_endian.h"

#include <array>
#include <utility>
#include <vector>

namespace image {
namespace {

/// 18 bytes, an identification, the palette, the pixels.
constexpr std::size_t kHeader = 18;
constexpr std::uint8_t kMostLevel = 255;

/// Kinds of pictures; 8 is added where runs are packed.
enum Kind : std::uint8_t { kPalette = 1, kColors = 2, kGreys = 3, kPacked = 8 };

std::uint32_t pair_at(const ByteList& bytes, std::size_t at)
{
    if (const auto number = number_at(bytes, at, 2)) return *number;
    throw FileError("the Targa file ends too early");
}

/// One colour of `bits`: blue, green, red and alpha of 8 bits, or 5 bits of each in two bytes, which stand for the
/// upper bits of a byte whose others are 0; the sixteenth bit is alpha (spec 4, 12.10).
std::array<std::uint8_t, 4> color_at(const ByteList& bytes, std::size_t at, std::size_t bits)
{
    std::array<std::uint8_t, 4> color{0, 0, 0, kMostLevel};
    if (bits <= 16) {
        const std::uint32_t packed = pair_at(bytes, at);
        for (std::size_t c = 0; c < 3; ++c) color[c] = static_cast<std::uint8_t>((packed >> (10 - 5 * c) & 31u) << 3);
        if (bits == 16) color[3] = packed & 0x8000u ? kMostLevel : 0;
        return color;
    }
    if (bytes.size() < bits / 8 || at > bytes.size() - bits / 8) throw FileError("the Targa file ends too early");
    for (std::size_t c = 0; c < 3; ++c) color[c] = bytes[at + 2 - c];
    if (bits == 32) color[3] = bytes[at + 3];
    return color;
}

std::size_t bytes_of(std::size_t bits) { return (bits + 7) / 8; }

/// Pixels of `size` bytes each.
ByteList unpacked(const ByteList& bytes, std::size_t at, std::size_t count, std::size_t size, bool packed)
{
    ByteList stored;
    const auto copy = [&](std::size_t pixels) {
        const std::size_t length = pixels * size;
        if (at > bytes.size() || bytes.size() - at < length) throw FileError("the Targa file ends too early");
        stored.insert(stored.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      bytes.begin() + static_cast<std::ptrdiff_t>(at + length));
    };
    if (!packed) {
        copy(count);
        return stored;
    }
    while (stored.size() < count * size) {
        if (at >= bytes.size()) throw FileError("the Targa file ends too early");
        const std::uint8_t run = bytes[at++];
        const bool repeated = run & 0x80;
        const std::size_t pixels = (run & 0x7fu) + std::size_t{1};
        for (std::size_t i = 0; i < (repeated ? pixels : 1); ++i) copy(repeated ? 1 : pixels);
        at += (repeated ? 1 : pixels) * size;
    }
    return stored;
}

/// The file's place of each pixel, top row first. POV-Ray does not ask whether rows run from the right.
std::vector<std::size_t> places(std::size_t wide, std::size_t high, std::uint8_t order)
{
    const bool from_top = order & 0x20;
    std::vector<std::size_t> result;
    result.reserve(wide * high);
    for (std::size_t y = 0; y < high; ++y)
        for (std::size_t x = 0; x < wide; ++x) result.push_back((from_top ? y : high - 1 - y) * wide + x);
    return result;
}

}  // namespace

bool is_plain_targa(const std::string& path, const ByteList& bytes)
{
    const bool named = path.ends_with(".tga") || path.ends_with(".TGA");
    if (!named || bytes.size() <= kHeader) return false;
    const auto is_color = [](int bits) { return bits == 15 || bits == 16 || bits == 24 || bits == 32; };
    const int kind = bytes[2] & ~kPacked, bits = bytes[16];
    if (bytes[1] == 1) return kind == kPalette && bits == 8 && is_color(bytes[7]);
    return bytes[1] == 0 && ((kind == kColors && is_color(bits)) || (kind == kGreys && bits == 8));
}

Picture decode_targa(const ByteList& bytes)
{
    Picture out;
    const std::size_t wide = pair_at(bytes, 12), high = pair_at(bytes, 14);
    out.width = static_cast<int>(wide);
    out.height = static_cast<int>(high);
    if (wide == 0 || high == 0) throw FileError("the Targa file holds no picture");
    const bool packed = bytes[2] & kPacked;
    std::size_t at = kHeader + bytes[0];
    if (bytes[1] == 1) {
        const std::size_t first = pair_at(bytes, 3), colors = pair_at(bytes, 5), bits = bytes[7];
        out.palette.assign(4 * first, 0.0f);  // places below the first stored one
        for (std::size_t i = 0; i < colors; ++i, at += bytes_of(bits)) {
            for (const std::uint8_t level : color_at(bytes, at, bits))
                out.palette.push_back(static_cast<float>(level) / static_cast<float>(kMostLevel));
        }
    }
    const std::size_t bits = bytes[16], size = bytes_of(bits);
    const ByteList stored = unpacked(bytes, at, out.count(), size, packed);
    out.channels = bits == 8 ? 1 : bits == 16 || bits == 32 ? 4 : 3;
    std::vector<std::uint8_t> levels;  // or places in the palette
    levels.reserve(out.count() * static_cast<std::size_t>(out.channels));
    for (const std::size_t place : places(wide, high, bytes[17])) {
        if (bits == 8) {
            levels.push_back(stored[place]);
        } else {
            const auto color = color_at(stored, place * size, bits);
            levels.insert(levels.end(), color.begin(), color.begin() + out.channels);
        }
    }
    if (bytes[1] == 1) {
        out.indices = std::move(levels);
        finish_palette(out);
    } else {
        out.samples = {std::move(levels), kMostLevel};
    }
    return out;
}

}  // namespace image
