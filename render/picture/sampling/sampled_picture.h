#pragma once

#include "render/image/pixels/image.h"
#include "render/plan/compiled_scene.h"
#include "render/picture/blocks.h"
#include "render/scene/base/color.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace trace {

/// From light of one channel, in the working space, to its shown level, 0 to 255 and not rounded.
using ShownLevel = std::function<double(double)>;

/// A picture as the samples of its pixels: their sums, and what their spread says of the error of the mean.
class SampledPicture {
public:
    struct Pixel {
        std::array<double, 4> sum{};      ///< red, green, blue, transmit
        std::array<double, 3> squares{};  ///< of red, green, blue
        std::array<double, 3> begun{};    ///< sum of the first `mark` samples
        std::array<double, 3> powers{};   ///< second, third and fourth of red + green + blue
        std::uint32_t count = 0;
        std::uint32_t mark = 0;  ///< the largest power of two below count; 0: none

        /// False: it holds what is no number, and counts as black.
        bool add(const scene::Color& color);
        double mean(std::size_t channel) const { return count == 0 ? 0.0 : sum[channel] / count; }
        /// Sum of the squares of the differences from the mean; never negative.
        double spread(std::size_t channel) const;
        /// Of red + green + blue: sums of the second and of the fourth powers of the differences from the mean.
        struct Moments {
            double second = 0, fourth = 0;
        };
        Moments moments() const;
    };

    SampledPicture(int width, int height)
        : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    {}

    static constexpr double kBytesPerPixel = sizeof(Pixel) + sizeof(double) + 16;  ///< with what a render adds to it

    int width() const { return width_; }
    int height() const { return height_; }
    Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
    std::uint64_t samples() const;

    /// What one sample of each pixel is off by, in shown levels: the square, summed over the three colours, row by row.
    /// From the samples of the pixel and, with the weight of four of them, of its neighbours. 0 outside of the window.
    std::vector<double> variances(const ShownLevel& shown, const plan::Options& window) const;

    /// Root mean square over pixels of the window and colours that the means are expected to be off by, in shown
    /// levels. The places of samples are spread evenly, and so are those of the first half of them and of the rest: how
    /// far the means of both are apart tells more than the spread, which knows nothing of places. Of few pixels that
    /// differ it tells little: it counts for no less than a quarter of what the spread says.
    /// \param variances  of the same
    double expected_error(const std::vector<double>& variances, const ShownLevel& shown,
                          const plan::Options& window) const;

    /// Means into an image of the same size, as trace::render() leaves them.
    void show(image::Image& image) const;

    /// Where time is short one pixel in so many squared comes first, coarse to fine, from the window's corner on.
    static constexpr std::array kCoarse{32, 8, 2};
    /// Pixels of the window without a sample become like the one that stands for them: the finest of the coarse that
    /// has one.
    /// \param image  as shown
    void fill(image::Image& image, const plan::Options& window) const;

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_, height_;
    std::vector<Pixel> pixels_;
};

}  // namespace trace
