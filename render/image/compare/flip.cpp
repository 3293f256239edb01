#include "render/image/compare/flip.h"

#include "render/image/levels/transfer_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace image {
namespace {

using Three = std::array<double, 3>;
using Plane = std::vector<double>;

constexpr double kPixelsPerDegree = 67.0;
constexpr Three kWhite{0.950428545, 1.0, 1.088900371};  // D65, the sum of each row below

Three xyz_of(const Three& c)
{
    return {0.4123907993 * c[0] + 0.3575843394 * c[1] + 0.1804807884 * c[2],
            0.2126390059 * c[0] + 0.7151686788 * c[1] + 0.0721923154 * c[2],
            0.0193308187 * c[0] + 0.1191947798 * c[1] + 0.9505321522 * c[2]};
}

Three linear_of(const Three& c)
{
    return {3.2409699419 * c[0] - 1.5373831776 * c[1] - 0.4986107603 * c[2],
            -0.9692436363 * c[0] + 1.8759675015 * c[1] + 0.0415550574 * c[2],
            0.0556300797 * c[0] - 0.2039769589 * c[1] + 1.0569715142 * c[2]};
}

/// Opponent colours YCxCz.
Three opponent_of(const Three& xyz)
{
    const double x = xyz[0] / kWhite[0], y = xyz[1] / kWhite[1], z = xyz[2] / kWhite[2];
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

Three xyz_of_opponent(const Three& c)
{
    const double y = (c[0] + 16.0) / 116.0;
    return {(c[1] / 500.0 + y) * kWhite[0], y * kWhite[1], (y - c[2] / 200.0) * kWhite[2]};
}

/// CIELAB with the chroma that Hunt's effect leaves at this lightness.
Three lab_of(const Three& linear)
{
    const Three xyz = xyz_of(linear);
    const auto f = [](double t) {
        constexpr double kDelta = 6.0 / 29.0;
        return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
    };
    const double x = f(xyz[0] / kWhite[0]), y = f(xyz[1] / kWhite[1]), z = f(xyz[2] / kWhite[2]);
    const double lightness = 116.0 * y - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)};
}

double hyab(const Three& a, const Three& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

/// A kernel along one axis, odd in length.
using Kernel = std::vector<double>;

/// The rows and columns of a picture under two kernels; pixels at the rim go on outside.
Plane filtered(const Plane& in, int width, int height, const Kernel& across, const Kernel& down)
{
    const auto at = [width](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    };
    const int wide = static_cast<int>(across.size()) / 2, high = static_cast<int>(down.size()) / 2;
    Plane rows(in.size()), out(in.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0.0;
            for (int k = -wide; k <= wide; ++k)
                sum += across[static_cast<std::size_t>(k + wide)] * in[at(std::clamp(x + k, 0, width - 1), y)];
            rows[at(x, y)] = sum;
        }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double sum = 0.0;
            for (int k = -high; k <= high; ++k)
                sum += down[static_cast<std::size_t>(k + high)] * rows[at(x, std::clamp(y + k, 0, height - 1))];
            out[at(x, y)] = sum;
        }
    return out;
}

/// A sum of two Gaussians as eyes blur a channel: weight and width of each.
struct Blur {
    double a1, b1, a2, b2;
};
constexpr std::array<Blur, 3> kBlurs{{{1.0, 0.0047, 0.0, 1e-5}, {1.0, 0.0053, 0.0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};

int blur_radius()
{
    constexpr double kWidest = 0.04;
    return static_cast<int>(
        std::ceil(3.0 * std::sqrt(kWidest / (2.0 * std::numbers::pi * std::numbers::pi)) * kPixelsPerDegree));
}

/// exp(-pi^2 x^2 / b) along one axis, not normalised; its square root of the weight is left to the caller.
Kernel gaussian(double b, int radius)
{
    Kernel out;
    for (int k = -radius; k <= radius; ++k) {
        const double x = k / kPixelsPerDegree;
        out.push_back(std::exp(-std::numbers::pi * std::numbers::pi * x * x / b));
    }
    return out;
}

double sum_of(const Kernel& kernel)
{
    double sum = 0.0;
    for (const double v : kernel) sum += v;
    return sum;
}

Plane blurred(const Plane& in, int width, int height, const Blur& blur)
{
    const int radius = blur_radius();
    const Kernel one = gaussian(blur.b1, radius), two = gaussian(blur.b2, radius);
    const double weight1 = blur.a1 * std::sqrt(std::numbers::pi / blur.b1),
                 weight2 = blur.a2 * std::sqrt(std::numbers::pi / blur.b2);
    const double all = weight1 * sum_of(one) * sum_of(one) + weight2 * sum_of(two) * sum_of(two);
    Plane out = filtered(in, width, height, one, one);
    for (double& v : out) v *= weight1 / all;
    if (weight2 == 0.0) return out;
    const Plane more = filtered(in, width, height, two, two);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += weight2 / all * more[i];
    return out;
}

/// Kernels of edges (first derivative) and points (second), positive and negative parts of sum 1.
struct FeatureKernels {
    Kernel smooth, edge, point;
};

FeatureKernels feature_kernels()
{
    constexpr double kWidth = 0.082;  // of a feature, in degrees
    const double deviation = 0.5 * kWidth * kPixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    FeatureKernels out;
    for (int k = -radius; k <= radius; ++k) {
        const double g = std::exp(-0.5 * k * k / (deviation * deviation));
        out.smooth.push_back(g);
        out.edge.push_back(-k * g);
        out.point.push_back((k * k / (deviation * deviation) - 1.0) * g);
    }
    const double all = sum_of(out.smooth);
    for (double& v : out.smooth) v /= all;
    for (Kernel* kernel : {&out.edge, &out.point}) {
        double above = 0.0, below = 0.0;
        for (const double v : *kernel) (v > 0.0 ? above : below) += std::abs(v);
        for (double& v : *kernel) v /= v > 0.0 ? above : below;
    }
    return out;
}

/// A picture as eyes see it: blurred colours, and how much of an edge and of a point is where.
struct Seen {
    std::vector<Three> lab;
    Plane edges, points;
};

Seen seen(const std::vector<float>& picture, int width, int height)
{
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::array<Plane, 3> channels{Plane(count), Plane(count), Plane(count)};
    Plane grey(count);
    const TransferCurve curve = TransferCurve::srgb();
    for (std::size_t i = 0; i < count; ++i) {
        const auto light = [&](std::size_t c) {
            return static_cast<double>(curve.decode(std::clamp(picture[3 * i + c], 0.0f, 1.0f)));
        };
        const Three c = opponent_of(xyz_of({light(0), light(1), light(2)}));
        for (std::size_t k = 0; k < 3; ++k) channels[k][i] = c[k];
        grey[i] = (c[0] + 16.0) / 116.0;
    }
    Seen out;
    const FeatureKernels kernels = feature_kernels();
    const auto lengths = [&](const Kernel& kernel) {
        Plane across = filtered(grey, width, height, kernel, kernels.smooth);
        const Plane down = filtered(grey, width, height, kernels.smooth, kernel);
        for (std::size_t i = 0; i < count; ++i) across[i] = std::hypot(across[i], down[i]);
        return across;
    };
    out.edges = lengths(kernels.edge);
    out.points = lengths(kernels.point);
    for (std::size_t k = 0; k < 3; ++k) channels[k] = blurred(channels[k], width, height, kBlurs[k]);
    out.lab.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        Three linear = linear_of(xyz_of_opponent({channels[0][i], channels[1][i], channels[2][i]}));
        for (double& v : linear) v = std::clamp(v, 0.0, 1.0);
        out.lab.push_back(lab_of(linear));
    }
    return out;
}

}  // namespace

std::vector<float> flip(const std::vector<float>& reference, const std::vector<float>& test, int width, int height)
{
    constexpr double kColorExponent = 0.7, kColorShare = 0.4, kColorTarget = 0.95, kFeatureExponent = 0.5;
    const Seen a = seen(reference, width, height), b = seen(test, width, height);
    const double most = std::pow(hyab(lab_of({0, 1, 0}), lab_of({0, 0, 1})), kColorExponent);
    std::vector<float> out(a.lab.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double apart = std::pow(hyab(a.lab[i], b.lab[i]), kColorExponent), knee = kColorShare * most;
        const double color = apart < knee ? kColorTarget / knee * apart
                                          : kColorTarget + (apart - knee) / (most - knee) * (1.0 - kColorTarget);
        const double feature = std::pow(
            std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i])) / std::numbers::sqrt2,
            kFeatureExponent);
        out[i] = static_cast<float>(std::pow(color, 1.0 - std::min(feature, 1.0)));
    }
    return out;
}

double mean_flip(const std::vector<float>& reference, const std::vector<float>& test, int width, int height)
{
    double sum = 0.0;
    const std::vector<float> all = flip(reference, test, width, height);
    for (const float v : all) sum += static_cast<double>(v);
    return all.empty() ? 0.0 : sum / static_cast<double>(all.size());
}

}  // namespace image
