#include "render/texture/image.h"

#include "numbers/functions/functions.h"
#include "numbers/remainder.h"
#include "render/texture/points/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace texture {
namespace {

double wrapped(double v, double size)
{
    const double r = numbers::fmod(v, size);
    return r < 0.0 ? r + size : r;
}

/// Height on the tube of a torus of radius 1, 0 to 1 (spec 4, 8.2).
double around_tube(const glm::dvec3& p)
{
    const double x = std::sqrt(p.x * p.x + p.z * p.z) - 1.0, r = std::sqrt(x * x + p.y * p.y);
    const double turned = numbers::acos(-x / r) / kTau;
    return p.y > 0.0 ? 1.0 - turned : turned;
}

/// In texels, rightward and upward; false where the projection has none.
bool project(const Image& image, const glm::dvec3& p, const glm::dvec2& size, glm::dvec2& at)
{
    const double beside = p.x * p.x + p.z * p.z;
    switch (image.projection) {
    case Image::Projection::Planar:
        if (image.once && (p.x < 0.0 || p.x > 1.0 || p.y < 0.0 || p.y > 1.0)) return false;
        at = {numbers::fmod(p.x * size.x, size.x), numbers::fmod(p.y * size.y, size.y)};
        return true;
    case Image::Projection::Spherical: {
        const double length = glm::length(p);
        if (length == 0.0) return false;
        at = {beside == 0.0 ? 0.0 : turn(p.x, p.z) * size.x,
              (0.5 + numbers::asin(p.y / length) / std::numbers::pi) * size.y};
        return true;
    }
    case Image::Projection::Cylindrical:
        if (beside == 0.0 || (image.once && (p.y < 0.0 || p.y > 1.0))) return false;
        at = {turn(p.x, p.z) * size.x, numbers::fmod(p.y * size.y, size.y)};
        return true;
    case Image::Projection::Torus:
        if (beside == 0.0) return false;
        at = {turn(p.x, p.z) * size.x, around_tube(p) * size.y};
        return true;
    }
    return false;
}

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
Line cubic_line(long i, double p)
{
    const double q = 1.0 - p;
    return {i - 2,
            4,
            {-p * q * q / 2.0, q * (q * (3.0 * p + 1.0) + 1.0) / 2.0, p * (p * (3.0 * q + 1.0) + 1.0) / 2.0,
             -q * p * p / 2.0}};
}

std::size_t texel_at(const Image& image, long column, long row)
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

void cross(const Image& image, const Line& columns, const Line& rows, Taps& taps)
{
    // From the far corner on, as POV-Ray adds them: places in a palette are truncated, so that the last bit tells.
    for (int r = rows.count - 1; r >= 0; --r)
        for (int c = columns.count - 1; c >= 0; --c)
            taps.all[taps.count++] = {texel_at(image, columns.first + c, rows.first + r),
                                      columns.share[static_cast<std::size_t>(c)] *
                                          rows.share[static_cast<std::size_t>(r)]};
}

/// Shares that fall with the squared distance from the texels' centres.
void by_distance(double p, double q, Taps& taps)
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

Taps taps_at(const Image& image, const glm::dvec2& place)
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

scene::Color texel_color(const Image& image, std::size_t texel)
{
    if (!image.palette.empty()) return image.palette[image.places[texel]];
    const glm::vec4& t = image.texels[texel];
    return {t.x, t.y, t.z, image.filter, t.w};
}

double height_at(const Image& image, glm::dvec2 place)
{
    // Neighbours beyond an edge are those of the other side, with `once` too.
    place.x += place.x < 0.0 ? image.width : place.x >= image.width ? -static_cast<double>(image.width) : 0.0;
    place.y += place.y < 0.0 ? image.height : place.y >= image.height ? -static_cast<double>(image.height) : 0.0;
    if (image.by_place) return image_index(image, place);
    return static_cast<double>(scene::grey(image_color(image, place).rgb()));
}

}  // namespace

bool image_place(const Image& image, const glm::dvec3& p, glm::dvec2& place)
{
    const glm::dvec2 real{image.width, image.height};
    glm::dvec2 at;
    if (!project(image, p, real * image.repeat, at)) return false;
    at += kTiny - image.offset * real;
    if (!(std::isfinite(at.x) && std::isfinite(at.y))) return false;
    if (image.once && (at.x < 0.0 || at.y < 0.0 || at.x >= real.x || at.y >= real.y)) return false;
    place = {wrapped(at.x, real.x), wrapped(-at.y, real.y)};
    return true;
}

scene::Color image_color(const Image& image, const glm::dvec2& place)
{
    const Taps taps = taps_at(image, place);
    if (taps.count == 1) return texel_color(image, taps.all[0].texel);
    std::array<double, 5> sum{};
    for (std::size_t k = 0; k < taps.count; ++k) {
        const scene::Color c = texel_color(image, taps.all[k].texel);
        const double w = taps.all[k].share;
        sum[0] += w * static_cast<double>(c.red);
        sum[1] += w * static_cast<double>(c.green);
        sum[2] += w * static_cast<double>(c.blue);
        sum[3] += w * static_cast<double>(c.filter);
        sum[4] += w * static_cast<double>(c.transmit);
    }
    return {static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2]),
            static_cast<float>(sum[3]), static_cast<float>(sum[4])};
}

scene::Color image_shown(const Image& image, const glm::dvec3& p)
{
    constexpr scene::Color kNoColor{1, 1, 1, 0, 1};  // spec 4, 11
    glm::dvec2 place;
    if (!image_place(image, p, place)) return kNoColor;
    scene::Color c = image_color(image, place);
    // POV-Ray divides what it has interpolated, and `transmit all` counts (measured).
    if (const float alpha = 1.0f - c.transmit; image.premultiplied && alpha != 0.0f) {
        c.red /= alpha;
        c.green /= alpha;
        c.blue /= alpha;
    }
    return c;
}

int image_index(const Image& image, const glm::dvec2& place)
{
    if (image.palette.empty()) return static_cast<int>(255.0f * image_color(image, place).red);
    const Taps taps = taps_at(image, place);
    double sum = 0.0;
    for (std::size_t k = 0; k < taps.count; ++k) sum += taps.all[k].share * image.places[taps.all[k].texel];
    return static_cast<int>(sum);
}

double image_value(const Image& image, const glm::dvec3& p)
{
    glm::dvec2 place;
    if (!image_place(image, p, place)) return 0.0;
    const scene::Color c = image_color(image, place);
    const float v = image.value == Image::Value::Grey  ? scene::grey(c.rgb())
                    : image.value == Image::Value::Red ? c.red
                                                       : c.transmit;
    return std::clamp(static_cast<double>(v), 0.0, 1.0);
}

glm::dvec3 image_bump(const Image& image, double size, const glm::dvec3& n, const glm::dvec3& p)
{
    glm::dvec2 place;
    if (!image_place(image, p, place)) return n;
    const double here = height_at(image, place), left = height_at(image, place + glm::dvec2(-1, 1)),
                 right = height_at(image, place + glm::dvec2(1, 1));
    const glm::dvec3 bump = glm::normalize(glm::dvec3(-size * (right - left), 2.0, size * (2.0 * here - left - right)));
    glm::dvec3 up = n, x = glm::cross(n, {0, 1, 0});
    if (glm::length(x) < kTiny) {
        up = {0, n.y < 0.0 ? -1 : 1, 0};
        x = {1, 0, 0};
    } else {
        x = glm::normalize(x);
    }
    const glm::dvec3 z = glm::normalize(glm::cross(x, up));
    return bump.x * x + bump.y * up - bump.z * z;
}

}  // namespace texture
