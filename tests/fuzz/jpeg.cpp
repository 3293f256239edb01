#include "tests/fuzz/picture_checks.h"

void fuzz::one(const Bytes& bytes)
{
    try {
        if (const auto picture = image::decode_jpeg(bytes)) check_picture(*picture);
    } catch (const image::FileError&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    return {written(any_raster(1, 8), image::FileType::Jpeg), written(any_raster(3, 8), image::FileType::Jpeg)};
}
