#include "render/texture/image.h"

#include "numbers/functions/functions.h"
#include "numbers/remainder.h"
#include "numbers/functions/remainder_lanes.h"
#include "render/texture/image_taps.h"
#include "render/texture/points/angle.h"
#include "render/texture/points/point_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <type_traits>

namespace texture {
namespace {

// Of one point or of a point a lane (T) where it says so.

template <class T>
T wrapped(const T& v, double size)
{
    const T r = numbers::fmod(v, T(size));
    return numbers::lanes::choose(r < T(0.0), r + T(size), r);
}

/// Height on the tube of a torus of radius 1, 0 to 1 (spec 4, 8.2).
template <class T>
T around_tube(const T& px, const T& py, const T& pz)
{
    using numbers::lanes::root_of;
    const T one(1.0), x = root_of(px * px + pz * pz) - one, r = root_of(x * x + py * py),
                      turned = numbers::acos(numbers::lanes::negated(x) / r) / T(kTau);
    return numbers::lanes::choose(py > T(0.0), one - turned, turned);
}

/// A mirror ball's picture, as of light probes: <0, 0, 1> in the middle, <0, 0, -1> all around (spec 7b, 7).
/// Places in a picture of 1 by 1; what to multiply x and y by to get there from the middle.
template <class T>
T from_middle(const T& x, const T& y, const T& z)
{
    using numbers::lanes::root_of;
    const T beside = root_of(x * x + y * y), length = root_of(x * x + y * y + z * z);
    const T reach = numbers::acos(z / length) / T(kTau) / beside;
    return numbers::lanes::choose(beside == T(0.0), T(0.0), reach);
}

/// The point in texels, rightward and upward; false where the projection has none.
template <class T>
numbers::lanes::Truth<T> project(const Image& image, T& x, T& y, const T& z, const glm::dvec2& size)
{
    const T zero(0.0), one(1.0), sx(size.x), sy(size.y), beside = x * x + z * z;
    const numbers::lanes::Truth<T> left = (x < zero), right = (x > one), low = (y < zero), high = (y > one),
                                   off_axis = !(beside == zero);
    switch (image.projection) {
    case Image::Projection::Planar:
        x = numbers::fmod(x * sx, sx);
        y = numbers::fmod(y * sy, sy);
        return image.once ? !(left | right | low | high) : zero == zero;
    case Image::Projection::Spherical: {
        const T length = numbers::lanes::root_of(x * x + y * y + z * z);
        x = numbers::lanes::choose(off_axis, turn(x, z) * sx, zero);
        y = (T(0.5) + numbers::asin(y / length) / T(std::numbers::pi)) * sy;
        return !(length == zero);
    }
    case Image::Projection::Cylindrical:
        x = turn(x, z) * sx;
        y = numbers::fmod(y * sy, sy);
        return image.once ? off_axis & !(low | high) : off_axis;
    case Image::Projection::Torus: {
        const T around = around_tube(x, y, z);
        x = turn(x, z) * sx;
        y = around * sy;
        return off_axis;
    }
    case Image::Projection::Angular: {
        const numbers::lanes::Truth<T> somewhere = !(x * x + y * y + z * z == zero);
        const T reach = from_middle(x, y, z);
        x = (T(0.5) + x * reach) * sx;
        y = (T(0.5) + y * reach) * sy;
        return somewhere;
    }
    }
    return zero != zero;
}

/// The point as its place in the picture, in texels; false where it is not.
template <class T>
numbers::lanes::Truth<T> find_place(const Image& image, T& x, T& y, const T& z)
{
    const glm::dvec2 real{image.width, image.height}, move = kTiny - image.offset * real;
    const T zero(0.0), width(real.x), height(real.y);
    numbers::lanes::Truth<T> there = project(image, x, y, z, real * image.repeat);
    x = x + T(move.x);
    y = y + T(move.y);
    const numbers::lanes::Truth<T> number_x = x - x == zero, number_y = y - y == zero, left = x < zero, low = y < zero,
                                   right = x >= width, high = y >= height;
    there = there & number_x & number_y;
    if (image.once) there = there & !(left | low | right | high);
    x = wrapped(x, real.x);
    y = wrapped(numbers::lanes::negated(y), real.y);
    return there;
}

/// f(texel_of), where texel_of(i) is a texel's colour: a form for each way that pictures are kept.
template <class F>
auto with_texels(const Image& image, F&& f)
{
    if (!image.palette.empty()) return f([&](std::size_t texel) { return image.palette[image.place(texel)]; });
    const image::Samples& samples = image.samples();
    const auto channels = static_cast<std::size_t>(image.picture->channels);
    const bool alpha = channels == 2 || channels == 4;
    return std::visit(
        [&](const auto& kept) {
            const auto by = [&](auto&& shown) {
                return f([&](std::size_t texel) -> scene::Color {
                    const std::size_t first = texel * channels;
                    float transmit = alpha ? 1.0f - samples.value(kept[first + channels - 1]) : 0.0f;
                    for (const float more : image.transmit) transmit += more;
                    const float red = shown(kept[first]);
                    if (channels < 3) return {red, red, red, image.filter, transmit};
                    return {red, shown(kept[first + 1]), shown(kept[first + 2]), image.filter, transmit};
                });
            };
            if constexpr (!std::is_same_v<decltype(kept), const image::Samples::Floats&>)
                if (!image.levels.empty()) return by([&](auto level) { return image.levels[level]; });
            return by([&](auto level) { return samples.value(level); });
        },
        samples.kept);
}

/// At a place within the picture, interpolated (spec 4, 12.2).
template <class Texels>
scene::Color color_at(const Image& image, const glm::dvec2& place, Texels&& texel_of)
{
    const Taps taps = taps_at(image, place);
    if (taps.count == 1) return texel_of(taps.all[0].texel);
    std::array<double, 5> sum{};
    for (std::size_t k = 0; k < taps.count; ++k) {
        const scene::Color c = texel_of(taps.all[k].texel);
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

float alpha_of(const scene::Color& c) { return 1.0f - c.transmit; }

/// A premultiplied colour as it is by itself.
scene::Color straight(scene::Color c, float alpha)
{
    if (alpha == 0.0f) return c;
    c.red /= alpha;
    c.green /= alpha;
    c.blue /= alpha;
    return c;
}

/// The same by what the image_map shows: POV-Ray divides what it has interpolated, where `transmit all` counts already
/// (measured), but each texel for what 3.8 lets fade (spec 7b, 6).
template <class Texels>
scene::Color shown_at(const Image& image, const glm::dvec2& place, Texels&& texel_of)
{
    const bool fades = image.faded_filter != 0.0f || image.faded_transmit != 0.0f;
    if (!fades) {
        const scene::Color c = color_at(image, place, texel_of);
        return image.premultiplied ? straight(c, alpha_of(c)) : c;
    }
    constexpr float kLeast = 1e-6f;  // alpha that POV-Ray divides a texel by
    scene::Color c = color_at(image, place, [&](std::size_t texel) {
        const scene::Color own = texel_of(texel);
        return image.premultiplied ? straight(own, std::max(alpha_of(own), kLeast)) : own;
    });
    const float alpha = alpha_of(c);
    c.filter = image.faded_filter * alpha;
    c.transmit += image.faded_transmit * alpha;
    return c;
}

constexpr scene::Color kNoColor{1, 1, 1, 0, 1};  // where the picture is not (spec 4, 11)

/// For places in the palette; without one 255 times red. Truncated.
template <class Texels>
int index_at(const Image& image, const glm::dvec2& place, Texels&& texel_of)
{
    if (image.palette.empty()) return static_cast<int>(255.0f * color_at(image, place, texel_of).red);
    const Taps taps = taps_at(image, place);
    double sum = 0.0;
    for (std::size_t k = 0; k < taps.count; ++k)
        sum += taps.all[k].share * static_cast<double>(image.place(taps.all[k].texel));
    return static_cast<int>(sum);
}

template <class Texels>
double value_at(const Image& image, const glm::dvec2& place, Texels&& texel_of)
{
    const scene::Color c = color_at(image, place, texel_of);
    const float v = image.value == Image::Value::Grey  ? scene::grey(c.rgb())
                    : image.value == Image::Value::Red ? c.red
                                                       : c.transmit;
    return std::clamp(static_cast<double>(v), 0.0, 1.0);
}

template <class Texels>
double height_at(const Image& image, glm::dvec2 place, Texels&& texel_of)
{
    // Neighbours beyond an edge are those of the other side, with `once` too.
    place.x += place.x < 0.0 ? image.width : place.x >= image.width ? -static_cast<double>(image.width) : 0.0;
    place.y += place.y < 0.0 ? image.height : place.y >= image.height ? -static_cast<double>(image.height) : 0.0;
    if (image.by_place) return index_at(image, place, texel_of);
    return static_cast<double>(scene::grey(color_at(image, place, texel_of).rgb()));
}

/// Places in the picture, in texels: image_place() of each.
struct Places {
    Values x, y;
    std::uint64_t there = 0;  ///< bit i: the picture is at point i

    glm::dvec2 at(std::size_t i) const { return {x[i], y[i]}; }
    /// f(i) where the picture is, otherwise(i) where it is not.
    template <class F, class Otherwise>
    void each(std::size_t count, F&& f, Otherwise&& otherwise) const
    {
        for (std::size_t i = 0; i < count; ++i)
            if (there >> i & 1) f(i);
            else otherwise(i);
    }
};

Places places_of(const Image& image, const Points& p)
{
    Places out;
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        Double x = get(p.x, i), y = get(p.y, i);
        out.there |= std::uint64_t{numbers::lanes::mask(find_place(image, x, y, get(p.z, i)))} << i;
        x.store_aligned(out.x.data() + i);
        y.store_aligned(out.y.data() + i);
    }
    return out;
}

/// A normal that the heights at a place and at its two neighbours bend, a double or lanes of them.
template <class T>
void bend_by_heights(const T& size, const T& here, const T& left, const T& right, T& nx, T& ny, T& nz)
{
    using numbers::lanes::choose;
    using numbers::lanes::root_of;
    const T zero(0.0), one(1.0), two(2.0);
    const auto scale = [&](const T& x, const T& y, const T& z) { return one / root_of(x * x + y * y + z * z); };
    const T across = numbers::lanes::negated(size) * (right - left), down = size * (two * here - left - right),
            bump = scale(across, two, down);
    // Beside the normal and the vertical; a vertical normal has one of the picture's own.
    const T cx = ny * zero - one * nz, cy = nz * zero - zero * nx, cz = nx * one - zero * ny;
    const auto upright = root_of(cx * cx + cy * cy + cz * cz) < T(kTiny);
    const T unit = scale(cx, cy, cz);
    const T ux = choose(upright, zero, nx), uy = choose(upright, choose(ny < zero, zero - one, one), ny),
            uz = choose(upright, zero, nz);
    const T xx = choose(upright, one, cx * unit), xy = choose(upright, zero, cy * unit),
            xz = choose(upright, zero, cz * unit);
    const T zx = xy * uz - uy * xz, zy = xz * ux - uz * xx, zz = xx * uy - ux * xy, length = scale(zx, zy, zz);
    const T bx = across * bump, by = two * bump, bz = down * bump;
    nx = bx * xx + by * ux - bz * (zx * length);
    ny = bx * xy + by * uy - bz * (zy * length);
    nz = bx * xz + by * uz - bz * (zz * length);
}

}  // namespace

bool image_place(const Image& image, const glm::dvec3& p, glm::dvec2& place)
{
    glm::dvec2 at(p);
    if (!find_place(image, at.x, at.y, p.z)) return false;
    place = at;
    return true;
}

bool image_is_clear(const Image& image)
{
    const auto clear = [](const scene::Color& c) { return c.filter != 0.0f || c.transmit != 0.0f; };
    if (!image.palette.empty()) return std::any_of(image.palette.begin(), image.palette.end(), clear);
    const bool alike = image.picture->channels % 2 != 0;  // no alpha
    const std::size_t count = alike ? 1 : image.picture->count();
    return image.filter != 0.0f || image.faded_filter != 0.0f || image.faded_transmit != 0.0f ||
           with_texels(image, [&](auto&& texel_of) {
               for (std::size_t i = 0; i < count; ++i)
                   if (texel_of(i).transmit != 0.0f) return true;
               return false;
           });
}

scene::Color image_shown(const Image& image, const glm::dvec3& p)
{
    glm::dvec2 place;
    if (!image_place(image, p, place)) return kNoColor;
    return with_texels(image, [&](auto&& texel_of) { return shown_at(image, place, texel_of); });
}

void images_shown(const Image& image, const Points& p, ColorPoints& out)
{
    const Places places = places_of(image, p);
    with_texels(image, [&](auto&& texel_of) {
        places.each(
            p.size(), [&](std::size_t i) { out.set(i, shown_at(image, places.at(i), texel_of)); },
            [&](std::size_t i) { out.set(i, kNoColor); });
    });
}

int image_index(const Image& image, const glm::dvec2& place)
{
    return with_texels(image, [&](auto&& texel_of) { return index_at(image, place, texel_of); });
}

double image_value(const Image& image, const glm::dvec3& p)
{
    glm::dvec2 place;
    if (!image_place(image, p, place)) return 0.0;
    return with_texels(image, [&](auto&& texel_of) { return value_at(image, place, texel_of); });
}

void image_values(const Image& image, const Points& p, Values& out)
{
    const Places places = places_of(image, p);
    with_texels(image, [&](auto&& texel_of) {
        places.each(
            p.size(), [&](std::size_t i) { out[i] = value_at(image, places.at(i), texel_of); },
            [&](std::size_t i) { out[i] = 0.0; });
    });
}

glm::dvec3 image_bump(const Image& image, double size, const glm::dvec3& n, const glm::dvec3& p)
{
    glm::dvec2 place;
    if (!image_place(image, p, place)) return n;
    glm::dvec3 out = n;
    with_texels(image, [&](auto&& texel_of) {
        const auto height = [&](double right, double down) {
            return height_at(image, place + glm::dvec2(right, down), texel_of);
        };
        bend_by_heights(size, height(0, 0), height(-1, 1), height(1, 1), out.x, out.y, out.z);
    });
    return out;
}

void image_bumps(const Image& image, double size, const Points& p, Points& n)
{
    const Places places = places_of(image, p);
    Values here{}, left{}, right{};
    with_texels(image, [&](auto&& texel_of) {
        const auto height = [&](const glm::dvec2& place) { return height_at(image, place, texel_of); };
        places.each(
            p.size(),
            [&](std::size_t i) {
                const glm::dvec2 place = places.at(i);
                here[i] = height(place);
                left[i] = height(place + glm::dvec2(-1, 1));
                right[i] = height(place + glm::dvec2(1, 1));
            },
            [](std::size_t) {});
    });
    const Points plain = n;
    for (std::size_t i = 0; i < n.size(); i += kLanes) {
        Double x = get(n.x, i), y = get(n.y, i), z = get(n.z, i);
        bend_by_heights(Double(size), get(here, i), get(left, i), get(right, i), x, y, z);
        x.store_aligned(n.x.data() + i);
        y.store_aligned(n.y.data() + i);
        z.store_aligned(n.z.data() + i);
    }
    places.each(
        n.size(), [](std::size_t) {}, [&](std::size_t i) { n.set(i, plain.at(i)); });
    n.pad();
}

}  // namespace texture
