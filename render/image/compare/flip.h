#pragma once

#include <vector>

namespace image {

/// How different two pictures look when one takes the other's place on a screen, pixel by pixel, 0 to 1: Andersson,
/// Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, "FLIP: a difference evaluator for alternating images" (PACM
/// on Computer Graphics 3, 2020), for a screen of 0.7 m width and 3840 pixels seen from 0.7 m (67 pixels a degree).
/// \param reference, test three sRGB values from 0 to 1 a pixel, row by row
std::vector<float> flip(const std::vector<float>& reference, const std::vector<float>& test, int width, int height);

/// The mean of flip().
double mean_flip(const std::vector<float>& reference, const std::vector<float>& test, int width, int height);

}  // namespace image
