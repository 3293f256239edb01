#include "tests/fuzz/picture_checks.h"

void fuzz::one(const Bytes& bytes)
{
    try {
        if (image::is_plain_targa("x.tga", bytes)) check_picture(image::decode_targa(bytes));
    } catch (const image::FileError&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    Bytes places = {1, 1,    9,   0, 0, 2, 0, 24, 0, 0,    0, 0,    3, 0, 2, 0,
                    8, 0x20, 'i', 1, 2, 3, 4, 5,  6, 0x82, 0, 0x02, 1, 0, 1};
    Bytes short_colors = places;
    short_colors[7] = 16;
    return {written(any_raster(3, 8), image::FileType::Targa),
            written(any_raster(3, 8), image::FileType::TargaRunLength),
            written(any_raster(1, 8), image::FileType::TargaRunLength), places, short_colors};
}
