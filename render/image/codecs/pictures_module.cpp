#include "render/image/codecs/picture_libraries.h"

extern "C" __attribute__((visibility("default"))) const image::PictureLibraries* whittle_pictures()
{
    static constexpr image::PictureLibraries all{image::decode_png, image::decode_gif, image::decode_jpeg,
                                                 image::jpeg_sink};
    return &all;
}
