#include "render/image/compare/compare.h"

#include "render/image/compare/flip.h"
#include "render/image/compare/ssim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace image {

namespace {

constexpr float kScale = 255.0f;

/// Share of an agreeing pixel's brightness that the difference picture keeps.
constexpr float kDim = 0.25f;

using Pixel = std::array<float, 4>;

Pixel pixel_of(const Picture& picture, int x, int y)
{
    const std::array<float, 4> p = picture.at(x, y);
    Pixel out{0, 0, 0, kScale};
    for (std::size_t c = 0; c < 3; ++c) out[c] = kScale * (picture.channels < 3 ? p[0] : p[c]);
    if (picture.channels == 2) out[3] = kScale * p[1];
    if (picture.channels >= 4) out[3] = kScale * p[3];
    return out;
}

float largest_difference(const Pixel& a, const Pixel& b)
{
    float largest = 0.0f;
    for (std::size_t c = 0; c < 4; ++c) {
        const float difference = std::fabs(a[c] - b[c]);
        if (std::isnan(difference)) return std::numeric_limits<float>::infinity();  // never within a tolerance
        largest = std::max(largest, difference);
    }
    return largest;
}

/// Levels are multiples of 1/255 or 1/65535 that went through a float: this much rounding is not a difference.
constexpr double kRounding = 1e-3;

bool agrees(double difference, double tolerance) { return difference <= tolerance + kRounding; }

void require_same_size(const Picture& a, const Picture& b)
{
    if (a.width == b.width && a.height == b.height) return;
    throw FileError("the pictures differ in size: " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                    " and " + std::to_string(b.width) + "x" + std::to_string(b.height));
}

std::vector<float> colors_of(const Picture& picture)
{
    std::vector<float> out;
    out.reserve(3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const Pixel p = pixel_of(picture, x, y);
            for (std::size_t c = 0; c < 3; ++c) {
                if (!std::isfinite(p[c]))
                    throw FileError("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is not finite");
                out.push_back(p[c] / kScale);
            }
        }
    }
    return out;
}

std::vector<float> luminance_of(const Picture& picture)
{
    std::vector<float> grey;
    grey.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const Pixel p = pixel_of(picture, x, y);
            grey.push_back(luminance(p[0], p[1], p[2]) / kScale);
        }
    }
    return grey;
}

}  // namespace

Comparison compare(const Picture& a, const Picture& b, double tolerance)
{
    require_same_size(a, b);
    Comparison result;
    const bool has_alpha = a.channels % 2 == 0 || b.channels % 2 == 0;
    const std::size_t channels = has_alpha ? 4 : 3;
    double squares = 0.0;
    std::size_t agreeing = 0;
    double largest = -1.0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const Pixel p = pixel_of(a, x, y), q = pixel_of(b, x, y);
            const auto difference = static_cast<double>(largest_difference(p, q));
            if (agrees(difference, tolerance)) ++agreeing;
            for (std::size_t c = 0; c < channels; ++c)
                squares += static_cast<double>(p[c] - q[c]) * static_cast<double>(p[c] - q[c]);
            if (difference <= largest) continue;
            largest = difference;
            result.worst_x = x;
            result.worst_y = y;
            std::copy(p.begin(), p.end(), result.worst_a);
            std::copy(q.begin(), q.end(), result.worst_b);
        }
    }
    const double pixels = static_cast<double>(a.width) * static_cast<double>(a.height);
    result.largest = largest;
    result.agreeing = static_cast<double>(agreeing) / pixels;
    result.rmse = std::sqrt(squares / (pixels * static_cast<double>(channels)));
    result.psnr = result.rmse > 0.0 ? 20.0 * std::log10(static_cast<double>(kScale) / result.rmse)
                                    : std::numeric_limits<double>::infinity();
    result.ssim = structural_similarity(luminance_of(a), luminance_of(b), a.width, a.height);
    return result;
}

std::vector<float> flip_map(const Picture& a, const Picture& b)
{
    require_same_size(a, b);
    return flip(colors_of(a), colors_of(b), a.width, a.height);
}

Raster flip_picture(const std::vector<float>& map, int width, int height)
{
    Raster out{width, height, 3, 8, {}};
    out.samples.reserve(3 * map.size());
    for (const float v : map) out.samples.insert(out.samples.end(), 3, quantised(v, 8));
    return out;
}

Raster difference_picture(const Picture& a, const Picture& b, double tolerance)
{
    require_same_size(a, b);
    Raster out{a.width, a.height, 3, 8, {}};
    out.samples.reserve(3 * static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height));
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const Pixel p = pixel_of(a, x, y), q = pixel_of(b, x, y);
            const float difference = largest_difference(p, q);
            if (agrees(static_cast<double>(difference), tolerance)) {
                out.samples.insert(out.samples.end(), 3, quantised(kDim * luminance(p[0], p[1], p[2]) / kScale, 8));
            } else {
                const std::uint16_t pale = quantised(difference / kScale, 8);
                out.samples.insert(out.samples.end(), {std::uint16_t{255}, pale, pale});
            }
        }
    }
    return out;
}

}  // namespace image
