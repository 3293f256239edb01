#include "render/image/direct_readers.h"

namespace image {
namespace {

/// 18 bytes, an identification, the palette, the pixels.
constexpr std::size_t kHeader = 18;

std::uint32_t pair_at(const ByteList& bytes, std::size_t at)
{
    if (at + 1 >= bytes.size()) throw FileError("the Targa file ends too early");
    return static_cast<std::uint32_t>(bytes[at] | bytes[at + 1] << 8);
}

/// Blue, green, red of 8 bits, or 5 bits of each in two bytes.
void read_palette(const ByteList& bytes, std::size_t at, std::size_t count, std::size_t entry, Picture& picture)
{
    for (std::size_t i = 0; i < count; ++i, at += entry) {
        float color[4] = {0.0f, 0.0f, 0.0f, 1.0f};
        if (entry == 2) {
            const std::uint32_t packed = pair_at(bytes, at);
            for (int c = 0; c < 3; ++c) color[c] = static_cast<float>((packed >> (10 - 5 * c)) & 31u) / 31.0f;
        } else {
            if (at + 2 >= bytes.size()) throw FileError("the Targa file ends too early");
            for (std::size_t c = 0; c < 3; ++c) color[c] = static_cast<float>(bytes[at + 2 - c]) / 255.0f;
        }
        picture.palette.insert(picture.palette.end(), color, color + 4);
    }
}

ByteList unpacked(const ByteList& bytes, std::size_t at, std::size_t count, bool run_length)
{
    const auto next = [&] {
        if (at >= bytes.size()) throw FileError("the Targa file ends too early");
        return bytes[at++];
    };
    ByteList stored;
    while (stored.size() < count) {
        if (!run_length) {
            stored.push_back(next());
            continue;
        }
        const std::uint8_t run = next();
        const bool repeated = run & 0x80;
        std::uint8_t value = repeated ? next() : std::uint8_t{0};
        for (int i = 0; i <= (run & 0x7f); ++i) {
            if (!repeated) value = next();
            stored.push_back(value);
        }
    }
    return stored;
}

}  // namespace

Picture decode_targa_palette(const ByteList& bytes)
{
    Picture out;
    const std::size_t wide = pair_at(bytes, 12), high = pair_at(bytes, 14), first = pair_at(bytes, 3), colors = pair_at(bytes, 5);
    out.width = static_cast<int>(wide);
    out.height = static_cast<int>(high);
    const std::size_t entry = (bytes[7] + std::size_t{7}) / 8, palette = kHeader + bytes[0];
    out.palette.assign(4 * first, 0.0f);  // places below the first stored one
    read_palette(bytes, palette, colors, entry, out);
    const ByteList stored = unpacked(bytes, palette + colors * entry, out.count(), bytes[2] == 9);
    const bool from_top = bytes[17] & 0x20, from_right = bytes[17] & 0x10;
    out.indices.resize(out.count());
    for (std::size_t y = 0; y < high; ++y)
        for (std::size_t x = 0; x < wide; ++x)
            out.indices[(from_top ? y : high - 1 - y) * wide + (from_right ? wide - 1 - x : x)] = stored[y * wide + x];
    expand_palette(out);
    return out;
}

}  // namespace image
