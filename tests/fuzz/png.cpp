#include "tests/fuzz/picture_checks.h"

#include <png.h>

namespace {

/// With a palette, interlaced, with clear colours: what our own writer does not make.
fuzz::Bytes stored(int type, int depth, bool interlaced)
{
    fuzz::Bytes out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &out,
        [](png_structp from, png_bytep bytes, std::size_t count) {
            static_cast<fuzz::Bytes*>(png_get_io_ptr(from))
                ->insert(static_cast<fuzz::Bytes*>(png_get_io_ptr(from))->end(), bytes, bytes + count);
        },
        nullptr);
    png_set_IHDR(png, info, 9, 6, depth, type, interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_color colors[16];
    for (int i = 0; i < 16; ++i) colors[i] = {static_cast<png_byte>(i * 16), static_cast<png_byte>(i), 77};
    png_byte alpha[] = {0, 100, 255};
    png_color_16 clear{};
    if (type == PNG_COLOR_TYPE_PALETTE) png_set_PLTE(png, info, colors, 16), png_set_tRNS(png, info, alpha, 3, nullptr);
    else png_set_tRNS(png, info, nullptr, 0, &clear);
    png_set_gAMA(png, info, 0.5);
    fuzz::Bytes row(9 * 6, 0x12);
    std::vector<png_bytep> rows(6, row.data());
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    return out;
}

}  // namespace

void fuzz::one(const Bytes& bytes)
{
    try {
        check_picture(image::decode_png(bytes));
    } catch (const image::FileError&) {}
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    std::vector<Bytes> all;
    for (const int channels : {1, 2, 3, 4})
        for (const int bits : {8, 16}) all.push_back(written(any_raster(channels, bits), image::FileType::Png));
    for (const bool interlaced : {false, true}) {
        all.push_back(stored(PNG_COLOR_TYPE_PALETTE, 4, interlaced));
        all.push_back(stored(PNG_COLOR_TYPE_GRAY, 1, interlaced));
        all.push_back(stored(PNG_COLOR_TYPE_RGB, 16, interlaced));
    }
    return all;
}
