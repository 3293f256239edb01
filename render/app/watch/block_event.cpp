#include "render/app/watch/block_event.h"

#include "render/image/base64.h"

#include <fmt/format.h>

namespace app {

image::Encoding page_encoding(const Settings& settings, const scene::Description& description)
{
    image::Encoding encoding = file_settings(settings, description).encoding;
    encoding.bits = 8;
    encoding.greyscale = false;
    encoding.dither = image::Dither::None;
    return encoding;
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
                       raster.channels, image::base64(bytes));
}

}  // namespace app
