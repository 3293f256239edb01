#include "render/image/pixels/picture.h"

namespace image {

void expand_palette(Picture& picture)
{
    bool clear = false;
    for (std::size_t i = 3; i < picture.palette.size(); i += 4) clear = clear || picture.palette[i] < 1.0f;
    const std::size_t channels = clear ? 4 : 3;
    picture.channels = static_cast<int>(channels);
    picture.samples.clear();
    picture.samples.reserve(channels * picture.indices.size());
    for (const std::uint8_t index : picture.indices) {
        if (4 * std::size_t{index} >= picture.palette.size())
            throw FileError("a pixel has a colour that its palette lacks");
        const float* color = &picture.palette[4 * std::size_t{index}];
        picture.samples.insert(picture.samples.end(), color, color + channels);
    }
}

}  // namespace image
