#include "render/picture/sampling/sampled_picture.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace trace {

bool SampledPicture::Pixel::add(const scene::Color& color)
{
    std::array<double, 4> parts{static_cast<double>(color.red), static_cast<double>(color.green),
                                static_cast<double>(color.blue), static_cast<double>(color.transmit)};
    const bool numbers = std::isfinite(parts[0] + parts[1] + parts[2] + parts[3]);
    if (!numbers) parts = {};
    if (std::has_single_bit(count)) {
        std::copy_n(sum.begin(), 3, begun.begin());
        mark = count;
    }
    for (std::size_t k = 0; k < 4; ++k) sum[k] += parts[k];
    for (std::size_t k = 0; k < 3; ++k) squares[k] += parts[k] * parts[k];
    const double all = parts[0] + parts[1] + parts[2];
    powers[0] += all * all;
    powers[1] += all * all * all;
    powers[2] += all * all * all * all;
    ++count;
    return numbers;
}

SampledPicture::Pixel::Moments SampledPicture::Pixel::moments() const
{
    if (count == 0) return {};
    const double all = sum[0] + sum[1] + sum[2], mean = all / count;
    const double second = std::max(0.0, powers[0] - mean * all);
    const double fourth = powers[2] - mean * (4.0 * powers[1] - mean * (6.0 * powers[0] - 3.0 * mean * all));
    return {second, std::max(fourth, second * second / count)};  // no less (Jensen), whatever digits are lost
}

double SampledPicture::Pixel::spread(std::size_t channel) const
{
    return count == 0 ? 0.0 : std::max(0.0, squares[channel] - sum[channel] * sum[channel] / count);
}

std::uint64_t SampledPicture::samples() const
{
    std::uint64_t all = 0;
    for (const Pixel& pixel : pixels_) all += pixel.count;
    return all;
}

std::vector<double> SampledPicture::variances(const ShownLevel& shown, const plan::Options& window) const
{
    constexpr double kNeighbours = 4.0;  // samples that the pixels around are worth
    const int left = window.start_column, top = window.start_row,
              right = window.end_column < 0 ? width_ - 1 : window.end_column,
              bottom = window.end_row < 0 ? height_ - 1 : window.end_row;
    std::vector<double> out(pixels_.size(), 0.0);
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x) {
            const Pixel& own = at(x, y);
            if (own.count == 0) continue;
            double all = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                double around = 0.0, samples = 0.0;
                for (int v = std::max(top, y - 1); v <= std::min(bottom, y + 1); ++v)
                    for (int u = std::max(left, x - 1); u <= std::min(right, x + 1); ++u) {
                        around += at(u, v).spread(c);
                        samples += at(u, v).count - 1.0;
                    }
                const double near = samples > 0.0 ? around / samples : 0.0;
                const double variance = (own.spread(c) + kNeighbours * near) / (own.count - 1.0 + kNeighbours);
                // The slope of the shown level across what the mean is unsure of: at black and white it is not that of
                // a point.
                const double mean = own.mean(c), step = std::max(std::sqrt(variance / own.count), 1e-4);
                const double slope = (shown(mean + step) - shown(mean - step)) / (2.0 * step);
                all += variance * slope * slope;
            }
            out[index(x, y)] = all;
        }
    return out;
}

double SampledPicture::expected_error(const std::vector<double>& variances, const ShownLevel& shown,
                                      const plan::Options& window) const
{
    const int right = window.end_column < 0 ? width_ - 1 : window.end_column,
              bottom = window.end_row < 0 ? height_ - 1 : window.end_row;
    double by_spread = 0.0, by_halves = 0.0;
    std::size_t pixels = 0;
    for (int y = window.start_row; y <= bottom; ++y)
        for (int x = window.start_column; x <= right; ++x) {
            const Pixel& pixel = at(x, y);
            if (pixel.count == 0) continue;
            ++pixels;
            by_spread += variances[index(x, y)] / pixel.count;
            // As if the parts were independent and their squared errors in proportion to one over their sizes.
            const double first = pixel.mark, second = pixel.count - first,
                         share = first * second / (static_cast<double>(pixel.count) * pixel.count);
            for (std::size_t c = 0; c < 3 && first > 0.0; ++c) {
                const double apart = shown(pixel.begun[c] / first) - shown((pixel.sum[c] - pixel.begun[c]) / second);
                by_halves += share * apart * apart;
            }
        }
    if (pixels == 0) return 0.0;
    const double all = 3.0 * static_cast<double>(pixels), spread = std::sqrt(by_spread / all);
    return std::clamp(std::sqrt(by_halves / all), 0.25 * spread, spread);
}

void SampledPicture::show(image::Image& image) const
{
    image.width = width_;
    image.height = height_;
    image.hold(0, height_);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const Pixel& pixel = at(x, y);
            if (pixel.count == 0) continue;  // outside of the window: black and opaque
            float* const to = image.at(x, y);
            for (std::size_t k = 0; k < 4; ++k) to[k] = static_cast<float>(pixel.mean(k));
        }
}

void SampledPicture::fill(image::Image& image, const plan::Options& window) const
{
    const int right = window.end_column < 0 ? width_ - 1 : window.end_column,
              bottom = window.end_row < 0 ? height_ - 1 : window.end_row;
    for (int y = window.start_row; y <= bottom; ++y)
        for (int x = window.start_column; x <= right; ++x) {
            if (at(x, y).count > 0) continue;
            for (auto step = kCoarse.rbegin(); step != kCoarse.rend(); ++step) {
                const int u = x - (x - window.start_column) % *step, v = y - (y - window.start_row) % *step;
                if (at(u, v).count == 0) continue;
                std::copy_n(image.at(u, v), 4, image.at(x, y));
                break;
            }
        }
}

}  // namespace trace
