#pragma once

#include "render/texture/image.h"

#include <algorithm>
#include <array>

/// Which texels a place of a picture shows (spec 4, 12.2).
namespace texture {

/// Up to 16 texels and their shares.
struct Taps {
    struct Tap {
        std::size_t texel;
        double share;
    };
    std::array<Tap, 16> all;
    std::size_t count = 0;
};

/// Columns or rows from `first` on, each with its share, to be crossed with the others.
struct Line {
    long first;
    int count;
    std::array<double, 4> share;
};

/// Cubic convolution over four neighbours; the results may overshoot.
inline Line cubic_line(long i, double p)
{
    const double q = 1.0 - p;
    return {i - 2,
            4,
            {-p * q * q / 2.0, q * (q * (3.0 * p + 1.0) + 1.0) / 2.0, p * (p * (3.0 * q + 1.0) + 1.0) / 2.0,
             -q * p * p / 2.0}};
}

inline std::size_t texel_at(const Image& image, long column, long row)
{
    const auto inside = [once = image.once](long v, std::uint32_t size) {
        const auto n = static_cast<long>(size);
        if (once) return std::clamp(v, 0L, n - 1);
        if (v >= 0 && v < n) return v;  // nearly always: a division is what most of this would take
        const long r = v % n;
        return r < 0 ? r + n : r;
    };
    return static_cast<std::size_t>(inside(row, image.height)) * image.width +
           static_cast<std::size_t>(inside(column, image.width));
}

inline void cross(const Image& image, const Line& columns, const Line& rows, Taps& taps)
{
    // From the far corner on, as POV-Ray adds them: places in a palette are truncated, so that the last bit tells.
    for (int r = rows.count - 1; r >= 0; --r)
        for (int c = columns.count - 1; c >= 0; --c)
            taps.all[taps.count++] = {texel_at(image, columns.first + c, rows.first + r),
                                      columns.share[static_cast<std::size_t>(c)] *
                                          rows.share[static_cast<std::size_t>(r)]};
}

/// Shares that fall with the squared distance from the texels' centres.
inline void by_distance(double p, double q, Taps& taps)
{
    const double u = 1.0 - p, v = 1.0 - q;
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        const double across = k % 2 == 0 ? u : p, down = k < 2 ? v : q, distance = across * across + down * down;
        if (distance == 0.0) {  // upon a centre
            for (std::size_t other = 0; other < 4; ++other) taps.all[other].share = other == k ? 1.0 : 0.0;
            return;
        }
        taps.all[k].share = 1.0 / distance;
        sum += taps.all[k].share;
    }
    for (std::size_t k = 0; k < 4; ++k) taps.all[k].share /= sum;
}

inline Taps taps_at(const Image& image, const glm::dvec2& place)
{
    Taps taps;
    if (image.interpolation == Image::Interpolation::None) {
        taps.all[taps.count++] = {texel_at(image, static_cast<long>(place.x), static_cast<long>(place.y)), 1.0};
        return taps;
    }
    const glm::dvec2 at = place + 0.5;
    const auto i = static_cast<long>(at.x), j = static_cast<long>(at.y);
    const double p = at.x - static_cast<double>(i), q = at.y - static_cast<double>(j);
    if (image.interpolation == Image::Interpolation::Bicubic) {
        cross(image, cubic_line(i, p), cubic_line(j, q), taps);
        return taps;
    }
    cross(image, {i - 1, 2, {1.0 - p, p}}, {j - 1, 2, {1.0 - q, q}}, taps);
    if (image.interpolation == Image::Interpolation::NormalizedDistance) by_distance(p, q, taps);
    return taps;
}

}  // namespace texture
