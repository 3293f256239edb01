#include "tests/fuzz/picture_checks.h"

void fuzz::one(const Bytes& bytes)
{
    try {
        if (const auto picture = image::decode_bmp(bytes)) check_picture(*picture);
    } catch (const image::FileError&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    Bytes runs(54 + 16);
    runs[0] = 'B';
    runs[1] = 'M';
    runs[10] = 70;
    runs[14] = 40;
    runs[18] = runs[22] = 5;
    runs[28] = 8;
    runs[30] = 1;
    runs[46] = 4;
    Bytes half = runs;
    half[28] = 4;
    half[30] = 2;
    Bytes plain = half;
    plain[30] = 0;
    const Bytes packed = {3, 1, 0, 3, 0, 1, 2, 0, 0, 0, 0, 2, 1, 1, 2, 3, 0, 0, 0, 1, 1, 2, 3, 4};
    for (Bytes* one : {&runs, &half, &plain}) one->insert(one->end(), packed.begin(), packed.end());
    return {written(any_raster(3, 8), image::FileType::Bmp), written(any_raster(4, 8), image::FileType::Bmp), runs,
            half, plain};
}
