#pragma once

#include "render/picture/sampling/sampled_picture.h"

#include <span>

namespace trace {

/// Samples in proportion to the spread make the error of the whole least (Neyman 1934).
struct Sharing {
    const SampledPicture& picture;
    std::span<const std::size_t> window;  ///< its pixels, by their index
    std::span<const double> variances;    ///< of one sample, of all pixels of the picture
    double growth;                        ///< most samples of a pixel after a pass, by those before it
    double most;                          ///< of a pixel

    /// How many more samples the pixels of the window get, into `wanted`. False: none.
    /// \param share  of the error as it is that is aimed at; 0: as much as there is room for
    /// \param room  samples
    bool share_out(double share, double room, std::span<std::uint32_t> wanted) const;

private:
    double want_scaled(double scale, std::span<std::uint32_t> wanted) const;
    const SampledPicture::Pixel& pixel(std::size_t at) const;
};

}  // namespace trace
