#include "render/image/codecs/library_readers.h"

extern "C" __attribute__((visibility("default"))) const image::LibraryReaders* whittle_pictures()
{
    static constexpr image::LibraryReaders all{image::decode_png, image::decode_gif, image::decode_jpeg};
    return &all;
}
