#include "render/app/farm/size_model.h"

#include "numbers/functions/functions.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kTracedPixel = 16.0;  // bytes

/// The exponent that takes one value to another while pixels grow by `ratio`.
double growth_of(double small, double large, double ratio, double least, double most)
{
    if (!(small > 0.0) || !(large > 0.0)) return most;
    return std::clamp(numbers::log(large / small) / numbers::log(ratio), least, most);
}

/// What a ray of antialiasing costs against a pixel without, from two sizes. Edges are dear: neighbours hit other
/// things.
double weight_of(const SizedCost& small, const SizedCost& large)
{
    constexpr double kLeast = 0.3, kMost = 6.0;
    const double scale = large.pixels / small.pixels;
    const double rays = scale * small.supersamples - large.supersamples;
    const double seconds = scale * small.picture - large.picture;
    if (!(rays > 0.01 * large.pixels) || !(seconds > 0.0)) return 1.0;
    const double per_ray = seconds / rays, per_pixel = (large.picture - per_ray * large.supersamples) / large.pixels;
    return per_pixel > 0.0 ? std::clamp(per_ray / per_pixel, kLeast, kMost) : kMost;
}

/// Sizes that cost next to nothing say nothing: what starts a thread is in them.
bool tells(const SizedCost& cost) { return cost.picture > 0.005; }

}  // namespace

SizeModel::SizeModel(const std::vector<SizedCost>& costs)
{
    if (costs.size() < 2) return;
    const SizedCost &small = costs[costs.size() - 2], &large = costs.back();
    const double ratio = large.pixels / small.pixels;
    if (ratio <= 1.0) return;
    // The share of edges falls on as pictures grow, towards what lines have.
    constexpr double kLines = 0.5, kTowardsLines = 0.75;
    passes_growth_ = growth_of(small.passes, large.passes, ratio, 0.0, 1.0);
    edges_growth_ = growth_of(small.supersamples, large.supersamples, ratio, 0.3, 1.0);
    if (edges_growth_ > kLines) edges_growth_ = kLines + kTowardsLines * (edges_growth_ - kLines);
    if (tells(small)) sample_weight_ = weight_of(small, large);
    const double said = at(large.pixels, small).seconds(), took = at(large.pixels, large).seconds();
    error_ = took > 0.0 ? std::abs(said / took - 1.0) : 0.0;
}

FrameCost SizeModel::at(double pixels, const SizedCost& measured) const
{
    const double ratio = pixels / measured.pixels;
    FrameCost out;
    out.reading = measured.reading + measured.rest;
    out.passes = measured.passes * numbers::pow(ratio, passes_growth_);
    const double samples = measured.supersamples * numbers::pow(ratio, edges_growth_);
    out.picture = measured.picture * (pixels + sample_weight_ * samples) /
                      (measured.pixels + sample_weight_ * measured.supersamples) +
                  measured.writing * ratio;
    out.memory = measured.memory + kTracedPixel * std::max(0.0, pixels - measured.pixels);
    return out;
}

}  // namespace app
