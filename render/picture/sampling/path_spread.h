#pragma once

#include "render/picture/sampling/sampled_picture.h"

namespace trace {

/// What the spread of paths says of the error of their means. Few of a pixel's paths may bring most of its light: until
/// one of those is found its own samples agree and say that they are sure, and samples that go where the spread is
/// leave it so. Here a pixel's spread is that of its surroundings as far as its samples are too few to know their own:
/// squares of 2 x 2, 4 x 4, ... pixels up to the whole picture, each of which leans on the next larger one, the more
/// the less the variances of its samples are sure (kurtosis) and the less squares of its size differ (empirical Bayes).
/// See docs/error_and_time.md.
class PathSpread {
public:
    PathSpread(const SampledPicture& picture, const ShownLevel& shown, const plan::Options& window);

    /// As SampledPicture::variances() has them.
    const std::vector<double>& variances() const { return variances_; }

    /// What SampledPicture::expected_error() says, at the upper end of what is likely: nine of ten pictures err less.
    double expected_error() const;

private:
    /// Of one sample: variance by colour, second and fourth central moment of their sum.
    struct Rates {
        std::array<double, 3> variance{};
        double second = 0, fourth = 0;
        double kurtosis() const { return second > 0.0 ? std::max(fourth / (second * second), 1.0) : 1.0; }
    };
    /// The same summed over samples.
    struct Sums {
        Rates rates;
        double freedom = 0;  ///< samples, less one a pixel
        void add(const Sums& other);
        Rates mean() const;
        /// As far as there are too few of them they are like `around`, from which such as these differ by `variety`.
        Rates leaning_on(const Rates& around, double variety) const;
    };
    struct Level {
        int width = 0, height = 0;
        std::vector<Sums> squares;
        double variety = 0;  ///< square of the part by which variances differ from those of the next larger squares
    };

    int columns() const { return right_ - left_ + 1; }
    int rows() const { return bottom_ - top_ + 1; }
    Sums sums_of(const SampledPicture::Pixel& pixel) const;
    Sums around(const Level& pixels, int x, int y) const;
    void build();
    static double variety(const Level& fine, const Level& coarse);
    void judge();

    const SampledPicture& picture_;
    const ShownLevel& shown_;
    int left_, top_, right_, bottom_;
    std::vector<Level> levels_;  ///< pixels of the window first
    std::vector<double> variances_;
};

}  // namespace trace
