#include "render/picture/sampling/sharing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trace {

const SampledPicture::Pixel& Sharing::pixel(std::size_t at) const
{
    const auto width = static_cast<std::size_t>(picture.width());
    return picture.at(static_cast<int>(at % width), static_cast<int>(at / width));
}

bool Sharing::share_out(double share, double room, std::span<std::uint32_t> wanted) const
{
    double spreads = 0.0;
    for (const std::size_t at : window) spreads += std::sqrt(variances[at]);
    if (!(spreads > 0.0)) return false;  // nothing that more samples would change
    double scale = std::numeric_limits<double>::infinity();
    if (share > 0.0) {
        // The error falls at least as fast as that of samples anywhere.
        double by_spread = 0.0;
        for (const std::size_t at : window) by_spread += variances[at] / std::max(pixel(at).count, 1u);
        by_spread = std::sqrt(by_spread / (3.0 * static_cast<double>(window.size())));
        const double aim = share * by_spread;
        scale = spreads / (3.0 * static_cast<double>(window.size()) * aim * aim);
    }
    double all = want_scaled(scale, wanted);
    // So little is wanting that none gets a whole sample: then those that come first to one.
    constexpr double kLittle = 1.02;
    for (int i = 0; share > 0.0 && all < 1.0 && i < 200; ++i) all = want_scaled(scale *= kLittle, wanted);
    if (all > room) {
        double low = 0.0, high = std::isfinite(scale) ? scale : most * most;
        for (int i = 0; i < 60; ++i) {
            const double middle = low > 0.0 ? std::sqrt(low * high) : high * 0x1p-40;
            (want_scaled(middle, wanted) > room ? high : low) = middle;
        }
        all = want_scaled(low, wanted);
    }
    return all >= 1.0;
}

double Sharing::want_scaled(double scale, std::span<std::uint32_t> wanted) const
{
    double all = 0.0;
    for (const std::size_t at : window) {
        const double now = pixel(at).count, spread = std::sqrt(variances[at]);
        const double as_spread = spread > 0.0 ? std::min({scale * spread, growth * now, most}) : 0.0;
        const double more = std::floor(std::max(as_spread - now, 0.0));
        wanted[at] = static_cast<std::uint32_t>(more);
        all += more;
    }
    return all;
}

}  // namespace trace
