#pragma once

#include "render/image/codecs/read/direct_readers.h"
#include "render/image/files.h"
#include "tests/fuzz/scratch_file.h"

namespace fuzz {

/// What every reader promises of a picture that it hands out.
inline void check_picture(const image::Picture& picture)
{
    require(picture.width > 0 && picture.height > 0 && picture.channels > 0, "a picture without pixels");
    require(!picture.indices.empty() ||
                picture.samples.size() == picture.count() * static_cast<std::size_t>(picture.channels),
            "samples do not fit the size");
    require(picture.indices.empty() || picture.indices.size() == picture.count(), "places do not fit the size");
    require(picture.palette.size() % 4 == 0 && picture.palette.empty() == picture.indices.empty(),
            "a palette without places");
}

/// 11x7 pixels of a picture that has something of everything.
inline image::Raster any_raster(int channels, int bits)
{
    image::Raster raster{11, 7, channels, bits, {}};
    for (int i = 0; i < 77 * channels; ++i)
        raster.samples.push_back(static_cast<std::uint16_t>((i * i * 37 + i % 5 * 11) % (1 << bits)));
    for (std::size_t i = 0; i < raster.samples.size() / 3; ++i) raster.samples[i] = raster.samples[0];  // runs
    return raster;
}

inline Bytes written(const image::Raster& raster, image::FileType type)
{
    const ScratchFile file(image::extension(type));
    image::Files().write(file.path(), raster, type, image::TransferCurve::srgb());
    return image::bytes_of_file(file.path());
}

}  // namespace fuzz
