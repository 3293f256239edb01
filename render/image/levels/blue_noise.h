#pragma once

namespace image {

/// The place of a pixel in a pattern of 64x64 pixels that repeats: each of (k + 0.5) / 4096 once, in (0, 1). Pixels
/// that light up one after the other are far apart, so a share of them looks even (Ulichney, The void-and-cluster
/// method for dither array generation, 1993).
float blue_noise(int x, int y);

}  // namespace image
