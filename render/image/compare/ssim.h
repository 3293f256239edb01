#pragma once

#include <vector>

namespace image {

/// Mean structural similarity of two grey pictures with values 0 to 1: Wang, Bovik, Sheikh, Simoncelli, "Image quality
/// assessment: from error visibility to structural similarity" (IEEE Trans. Image Processing 13, 2004), equation 13
/// with an 11x11 Gaussian window of sigma 1.5. At the border the window is cut off and its weights are scaled to sum 1.
double structural_similarity(const std::vector<float>& a, const std::vector<float>& b, int width, int height);

}  // namespace image
