#pragma once

#include "render/image/files.h"

namespace image {

/// How far two pictures of one size are apart. Values are of the files as stored, on the scale 0 to 255 for any depth.
struct Comparison {
    double agreeing = 1.0;  ///< share of pixels within the tolerance in every channel
    double rmse = 0.0;      ///< over all channels, 0 to 255
    double psnr = 0.0;      ///< decibels, peak 255; infinite if the pictures are equal
    double ssim = 1.0;      ///< structural similarity of the luminance, 1 if equal (Wang et al. 2004, 11x11 Gaussian)
    double largest = 0.0;   ///< largest difference of any channel, 0 to 255
    int worst_x = 0, worst_y = 0;            ///< the first pixel that has it; from 0, the top left pixel is 0, 0
    float worst_a[4] = {}, worst_b[4] = {};  ///< r, g, b, alpha there, 0 to 255
};

/// Grey is compared as equal red, green and blue; a missing alpha channel as opaque. Throws FileError where the sizes
/// differ.
/// \param tolerance  largest difference per channel that still agrees, 0 to 255
Comparison compare(const Picture& a, const Picture& b, double tolerance);

/// FLIP (flip.h) of two pictures of one size, pixel by pixel, 0 to 1; alpha is left out. Throws FileError where the
/// sizes differ or a value is not finite.
/// \param a  the reference
std::vector<float> flip_map(const Picture& a, const Picture& b);

/// A map of flip_map() to look at: black where nothing is to be seen, white where nothing is alike.
Raster flip_picture(const std::vector<float>& map, int width, int height);

/// What to look at: `a` as dim grey, each pixel outside the tolerance from red (just outside) to white (255 apart).
Raster difference_picture(const Picture& a, const Picture& b, double tolerance);

}  // namespace image
