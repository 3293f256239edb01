#include "render/picture/sampling/path_spread.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr double kBell = 3.0;  // kurtosis of a bell curve
// Of variances, squared: no square is believed more than if its like differed by 0.7 of themselves, nor less than if
// by 0.03.
constexpr double kMostVariety = 0.5, kLeastVariety = 1e-3;

/// The square of the slope of the shown level across what the mean may be off by: the mean of those to both sides,
/// which are not alike where the one is cut at black or white, or bent by the gamma.
double slope_squared(const ShownLevel& shown, double mean, double step)
{
    step = std::max(step, 1e-4);
    const double at = shown(mean), up = shown(mean + step) - at;
    // No mean is below black: what is nearer to it than the step is rather too dark.
    const double down = std::max(at - shown(mean - step), mean < step ? up : 0.0);
    return (up * up + down * down) / (2.0 * step * step);
}

}  // namespace

void PathSpread::Sums::add(const Sums& other)
{
    for (std::size_t c = 0; c < 3; ++c) rates.variance[c] += other.rates.variance[c];
    rates.second += other.rates.second;
    rates.fourth += other.rates.fourth;
    freedom += other.freedom;
}

PathSpread::Rates PathSpread::Sums::leaning_on(const Rates& around, double variety) const
{
    // Of n samples the variance is off by a part whose square is the kurtosis less one, over n.
    const double weight = std::max(kBell - 1.0, around.kurtosis() - 1.0) / variety;
    const double all = freedom + weight;
    Rates out;
    for (std::size_t c = 0; c < 3; ++c) out.variance[c] = (rates.variance[c] + weight * around.variance[c]) / all;
    out.second = (rates.second + weight * around.second) / all;
    out.fourth = (rates.fourth + weight * around.fourth) / all;
    return out;
}

PathSpread::Rates PathSpread::Sums::mean() const
{
    Rates out = rates;
    for (double& variance : out.variance) variance /= freedom;
    out.second /= freedom;
    out.fourth /= freedom;
    return out;
}

PathSpread::PathSpread(const SampledPicture& picture, const ShownLevel& shown, const plan::Options& window)
    : picture_(picture), shown_(shown), left_(window.start_column), top_(window.start_row),
      right_(window.end_column < 0 ? picture.width() - 1 : window.end_column),
      bottom_(window.end_row < 0 ? picture.height() - 1 : window.end_row),
      variances_(static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()), 0.0)
{
    build();
    judge();
}

/// What a pixel tells others of: no more than what would bring its own mean from black to white, however bright one of
/// its paths was.
PathSpread::Sums PathSpread::sums_of(const SampledPicture::Pixel& pixel) const
{
    Sums out;
    if (pixel.count < 2) return out;
    const double n = pixel.count;
    double most = 0.0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, out.rates.variance[c] = pixel.spread(c));
    const double share = most > n * (n - 1.0) ? n * (n - 1.0) / most : 1.0;
    for (double& variance : out.rates.variance) variance *= share;
    const SampledPicture::Pixel::Moments moments = pixel.moments();
    out.rates.second = share * moments.second;
    out.rates.fourth = share * share * moments.fourth;
    out.freedom = n - 1.0;
    return out;
}

void PathSpread::build()
{
    Level pixels{columns(), rows(), {}, kMostVariety};
    for (int y = top_; y <= bottom_; ++y)
        for (int x = left_; x <= right_; ++x) pixels.squares.push_back(sums_of(picture_.at(x, y)));
    levels_.push_back(std::move(pixels));
    while (levels_.back().squares.size() > 1) {
        const Level& fine = levels_.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}, kMostVariety};
        coarse.squares.resize(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height));
        for (int y = 0; y < fine.height; ++y)
            for (int x = 0; x < fine.width; ++x)
                coarse.squares[static_cast<std::size_t>(y / 2 * coarse.width + x / 2)].add(
                    fine.squares[static_cast<std::size_t>(y * fine.width + x)]);
        const double differs = variety(fine, coarse);
        levels_.back().variety = differs;
        levels_.push_back(std::move(coarse));
    }
}

/// What squares differ by beyond what their samples leave to chance.
double PathSpread::variety(const Level& fine, const Level& coarse)
{
    double apart = 0.0, samples = 0.0;
    std::vector<double> squares(coarse.squares.size(), 0.0), children(coarse.squares.size(), 0.0);
    for (int y = 0; y < fine.height; ++y)
        for (int x = 0; x < fine.width; ++x) {
            const Sums& own = fine.squares[static_cast<std::size_t>(y * fine.width + x)];
            const auto above = static_cast<std::size_t>(y / 2 * coarse.width + x / 2);
            const Sums& whole = coarse.squares[above];
            if (!(own.freedom > 0.0) || !(whole.rates.second > 0.0)) continue;
            const double part = own.rates.second / own.freedom / (whole.rates.second / whole.freedom) - 1.0;
            squares[above] += own.freedom * part * part;
            children[above] += 1.0;
        }
    for (std::size_t i = 0; i < coarse.squares.size(); ++i) {
        if (children[i] < 2.0) continue;
        const Rates whole = coarse.squares[i].mean();
        apart += squares[i] - (children[i] - 1.0) * (whole.kurtosis() - 1.0);
        samples += coarse.squares[i].freedom * (children[i] - 1.0) / children[i];
    }
    return samples > 0.0 ? std::clamp(apart / samples, kLeastVariety, kMostVariety) : kMostVariety;
}

/// A pixel and its eight neighbours: squares that are halved cut through what belongs together.
PathSpread::Sums PathSpread::around(const Level& pixels, int x, int y) const
{
    Sums all;
    for (int v = std::max(0, y - 1); v <= std::min(pixels.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(pixels.width - 1, x + 1); ++u)
            all.add(pixels.squares[static_cast<std::size_t>(v * pixels.width + u)]);
    return all;
}

void PathSpread::judge()
{
    // From the whole picture down: what each square is taken for.
    const Sums& whole = levels_.back().squares[0];
    std::vector<Rates> above{whole.freedom > 0.0 ? whole.mean() : Rates()};
    for (std::size_t k = levels_.size() - 1; k-- > 1;) {
        const Level& level = levels_[k];
        std::vector<Rates> here;
        here.reserve(level.squares.size());
        for (int y = 0; y < level.height; ++y)
            for (int x = 0; x < level.width; ++x)
                here.push_back(level.squares[static_cast<std::size_t>(y * level.width + x)].leaning_on(
                    above[static_cast<std::size_t>(y / 2 * levels_[k + 1].width + x / 2)], level.variety));
        above = std::move(here);
    }
    const Level& pixels = levels_[0];
    const int across = levels_.size() > 1 ? levels_[1].width : 1;
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            const SampledPicture::Pixel& own = picture_.at(left_ + x, top_ + y);
            if (own.count == 0) continue;
            const Rates near = around(pixels, x, y)
                                   .leaning_on(above[static_cast<std::size_t>(y / 2 * across + x / 2)], pixels.variety);
            const Rates rates =
                pixels.squares[static_cast<std::size_t>(y * pixels.width + x)].leaning_on(near, pixels.variety);
            const double n = own.count, step = std::max(std::sqrt(1.0 / n), std::sqrt(rates.kurtosis()) / n);
            double all = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                // Of what is rarely found one path more changes the mean by more than its deviation.
                all += rates.variance[c] * slope_squared(shown_, own.mean(c), std::sqrt(rates.variance[c]) * step);
            }
            variances_[static_cast<std::size_t>(top_ + y) * static_cast<std::size_t>(picture_.width()) +
                       static_cast<std::size_t>(left_ + x)] = all;
        }
}

double PathSpread::expected_error() const
{
    constexpr double kLikely = 1.28;  // deviations of a bell curve, on one side of which are nine of ten
    double taken = 0.0, by_spread = 0.0, by_halves = 0.0, squares = 0.0;
    std::size_t pixels = 0;
    for (int y = top_; y <= bottom_; ++y)
        for (int x = left_; x <= right_; ++x) {
            const SampledPicture::Pixel& pixel = picture_.at(x, y);
            if (pixel.count == 0) continue;
            ++pixels;
            const double n = pixel.count;
            taken += variances_[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width()) +
                                static_cast<std::size_t>(x)] /
                     n;
            if (pixel.count < 2) continue;
            // What even places spare, told by halves (SampledPicture::expected_error()) beside the spread of the same
            // samples: those that are missing are missing in both.
            const double first = pixel.mark, second = n - first, share = first * second / (n * n);
            double own = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
                const double variance = pixel.spread(c) / (n - 1.0);
                const double square = slope_squared(shown_, pixel.mean(c), std::sqrt(variance / n));
                const double apart = pixel.begun[c] / first - (pixel.sum[c] - pixel.begun[c]) / second;
                own += square * variance / n;
                by_halves += square * share * apart * apart;
            }
            by_spread += own;
            squares += own * own;
        }
    if (pixels == 0 || !(taken > 0.0)) return 0.0;
    const double spared = by_spread > 0.0 ? std::clamp(by_halves / by_spread, 1.0 / 16.0, 1.0) : 1.0;
    // Few pixels that tell most of it are a matter of luck.
    const double unsure = by_spread > 0.0 ? std::sqrt(squares) / by_spread : 0.0;
    return std::sqrt(taken * spared * (1.0 + kLikely * unsure) / (3.0 * static_cast<double>(pixels)));
}

}  // namespace trace
