#include "render/image/pixels/picture.h"

namespace image {

void finish_palette(Picture& picture)
{
    bool clear = false;
    for (std::size_t i = 3; i < picture.palette.size(); i += 4) clear = clear || picture.palette[i] < 1.0f;
    picture.channels = clear ? 4 : 3;
    for (const std::uint8_t index : picture.indices)
        if (4 * std::size_t{index} >= picture.palette.size())
            throw FileError("a pixel has a colour that its palette lacks");
}

}  // namespace image
