#include "render/app/watch/block_event.h"

#include <fmt/format.h>

namespace app {

std::string base64(const std::string& bytes)
{
    static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u; };
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const unsigned three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
        out += kDigits[three >> 18];
        out += kDigits[three >> 12 & 63];
        out += i + 1 < bytes.size() ? kDigits[three >> 6 & 63] : '=';
        out += i + 2 < bytes.size() ? kDigits[three & 63] : '=';
    }
    return out;
}

std::string block_event(int generation, int pass, const trace::Block& block, const image::Image& picture,
                        const image::Encoding& encoding)
{
    image::Image part{block.width, block.height, {}, 0};
    for (int row = 0; row < block.height; ++row) {
        const float* from = picture.at(block.left, block.top + row);
        part.pixels.insert(part.pixels.end(), from, from + 4 * block.width);
    }
    const image::Raster raster = image::quantise(part, encoding);
    std::string bytes;
    bytes.reserve(raster.samples.size());
    for (const std::uint16_t sample : raster.samples) bytes += static_cast<char>(sample);
    return fmt::format(R"({{"g":{},"p":{},"W":{},"H":{},"x":{},"y":{},"w":{},"h":{},"c":{},"d":"{}"}})", generation,
                       pass, picture.width, picture.height, block.left, block.top, block.width, block.height,
                       raster.channels, base64(bytes));
}

}  // namespace app
