#include "render/image/direct_readers.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace image {
namespace {

bool begins(const ByteList& bytes, const char* text, std::size_t length)
{
    return bytes.size() >= length && std::equal(text, text + length, bytes.begin(), [](char c, std::uint8_t b) { return static_cast<std::uint8_t>(c) == b; });
}

}  // namespace

void expand_palette(Picture& picture)
{
    bool clear = false;
    for (std::size_t i = 3; i < picture.palette.size(); i += 4) clear = clear || picture.palette[i] < 1.0f;
    const std::size_t channels = clear ? 4 : 3;
    picture.channels = static_cast<int>(channels);
    picture.samples.clear();
    picture.samples.reserve(channels * picture.indices.size());
    for (const std::uint8_t index : picture.indices) {
        if (4 * std::size_t{index} >= picture.palette.size()) throw FileError("a pixel has a colour that its palette lacks");
        const float* color = &picture.palette[4 * std::size_t{index}];
        picture.samples.insert(picture.samples.end(), color, color + channels);
    }
}

std::optional<Picture> read_directly(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError("cannot read '" + path + "'");
    const ByteList bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    try {
        if (begins(bytes, "\x89PNG\r\n\x1a\n", 8)) return decode_png(bytes);
        if (begins(bytes, "GIF8", 4)) return decode_gif(bytes);
        if (begins(bytes, "\xff\xd8\xff", 3)) return decode_jpeg(bytes);
        if (is_plain_targa(path, bytes)) return decode_targa(bytes);
    } catch (const std::exception& error) {
        throw FileError("cannot read '" + path + "': " + error.what());
    }
    return std::nullopt;
}

}  // namespace image
