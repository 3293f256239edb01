#include "render/image/compare/ssim.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace image {

namespace {

constexpr int kReach = 5;            // the window is 2 * 5 + 1 pixels wide
constexpr double kSigma = 1.5;       // pixels
constexpr double kC1 = 0.01 * 0.01;  // (K1 L)^2 with L = 1, keeps dark windows stable
constexpr double kC2 = 0.03 * 0.03;  // (K2 L)^2

using Plane = std::vector<double>;

std::array<double, 2 * kReach + 1> window()
{
    std::array<double, 2 * kReach + 1> weights{};
    for (int i = -kReach; i <= kReach; ++i)
        weights[static_cast<std::size_t>(i + kReach)] = std::exp(-i * i / (2.0 * kSigma * kSigma));
    return weights;
}

/// Weighted means along one axis: `count` positions `step` apart.
void blur_line(const double* from, double* to, int count, std::size_t step)
{
    static const auto weights = window();
    for (int i = 0; i < count; ++i) {
        double sum = 0.0, weight_sum = 0.0;
        for (int j = std::max(0, i - kReach); j <= std::min(count - 1, i + kReach); ++j) {
            const double weight = weights[static_cast<std::size_t>(j - i + kReach)];
            sum += weight * from[static_cast<std::size_t>(j) * step];
            weight_sum += weight;
        }
        to[static_cast<std::size_t>(i) * step] = sum / weight_sum;
    }
}

Plane blurred(const Plane& plane, int width, int height)
{
    Plane rows(plane.size()), out(plane.size());
    const auto row = static_cast<std::size_t>(width);
    for (int y = 0; y < height; ++y)
        blur_line(&plane[static_cast<std::size_t>(y) * row], &rows[static_cast<std::size_t>(y) * row], width, 1);
    for (int x = 0; x < width; ++x)
        blur_line(&rows[static_cast<std::size_t>(x)], &out[static_cast<std::size_t>(x)], height, row);
    return out;
}

Plane product(const std::vector<float>& a, const std::vector<float>& b)
{
    Plane out(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) out[i] = static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return out;
}

}  // namespace

double structural_similarity(const std::vector<float>& a, const std::vector<float>& b, int width, int height)
{
    const Plane mean_a = blurred(Plane(a.begin(), a.end()), width, height),
                mean_b = blurred(Plane(b.begin(), b.end()), width, height);
    const Plane aa = blurred(product(a, a), width, height), bb = blurred(product(b, b), width, height),
                ab = blurred(product(a, b), width, height);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double variance_a = aa[i] - mean_a[i] * mean_a[i], variance_b = bb[i] - mean_b[i] * mean_b[i];
        const double covariance = ab[i] - mean_a[i] * mean_b[i];
        const double alike = (2.0 * mean_a[i] * mean_b[i] + kC1) * (2.0 * covariance + kC2);
        sum += alike / ((mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i] + kC1) * (variance_a + variance_b + kC2));
    }
    return sum / static_cast<double>(a.size());
}

}  // namespace image
