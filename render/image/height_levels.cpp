#include "render/image/height_levels.h"

#include "render/image/files.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace image {
namespace {

constexpr float kMost = 65535.0f;

/// The single-precision number that POV-Ray makes of an integer sample; floats stay, and shares of another most.
float stored(float sample, int bits)
{
    constexpr double kOfLevel = 1.0e-2;  // what single precision may lose of 65535 levels
    if (bits > 16) return sample;
    const double most = (1 << bits) - 1, level = static_cast<double>(sample) * most, whole = std::round(level);
    return std::abs(level - whole) < kOfLevel ? static_cast<float>(whole / most) : sample;
}

std::uint16_t level_of(double level) { return static_cast<std::uint16_t>(std::clamp(level, 0.0, 65535.0)); }

std::uint16_t grey_level(float share) { return level_of(static_cast<double>(share * kMost)); }

std::uint16_t brightness(float red, float green, float blue)
{
    return level_of(65535.0 * (0.297 * static_cast<double>(red) + 0.589 * static_cast<double>(green) +
                               0.114 * static_cast<double>(blue)));
}

HeightLevels heights_of_places(const Picture& picture, bool halves)
{
    const auto width = static_cast<std::uint32_t>(picture.width);
    HeightLevels out{halves ? width / 2 : width, static_cast<std::uint32_t>(picture.height), {}};
    out.levels.reserve(std::size_t{out.width} * out.height);
    for (std::uint32_t y = 0; y < out.height; ++y)
        for (std::uint32_t x = 0; x < out.width; ++x) {
            const std::uint8_t* row = &picture.indices[std::size_t{y} * width];
            out.levels.push_back(static_cast<std::uint16_t>(row[x] * 256 + (halves ? row[x + out.width] : 0)));
        }
    return out;
}

/// A level of an 8-bit grey PNG: POV-Ray takes it through a conversion to grey in single precision, which loses one
/// level for a third of all values (spec 5b, 10.1).
std::uint16_t png_grey(float v)
{
    const float grey = (0.297f * v + 0.589f * v) + 0.114f * v;
    return level_of(std::trunc(static_cast<double>(grey * 255.0f)) * 257.0);
}

}  // namespace

std::uint16_t color_level(std::uint16_t red, std::uint16_t green, std::uint16_t blue)
{
    const auto share = [](std::uint16_t v) { return static_cast<float>(v / 65535.0); };
    return brightness(share(red), share(green), share(blue));
}

HeightLevels read_heights(const std::string& path, const TransferCurve& decode)
{
    const bool pot = path.ends_with(".pot") || path.ends_with(".POT");
    const Picture picture = Files().read(path);
    if (!picture.indices.empty()) return heights_of_places(picture, pot);
    const bool png = path.ends_with(".png") || path.ends_with(".PNG"), grey = picture.channels < 3;
    HeightLevels out{static_cast<std::uint32_t>(picture.width), static_cast<std::uint32_t>(picture.height), {}};
    out.levels.reserve(std::size_t{out.width} * out.height);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const std::array<float, 4> p = picture.at(x, y);
            const auto channel = [&](std::size_t i) { return decode.decode(stored(p[i], picture.bits)); };
            if (grey) {
                out.levels.push_back(png && picture.channels == 1 && picture.bits <= 8 ? png_grey(channel(0))
                                                                                       : grey_level(channel(0)));
            } else if (picture.bits != 16) {  // floats too
                const double red = static_cast<double>(channel(0)), green = static_cast<double>(channel(1));
                out.levels.push_back(level_of((red * 256.0 + green) * 255.0));
            } else {
                out.levels.push_back(brightness(channel(0), channel(1), channel(2)));
            }
        }
    return out;
}

}  // namespace image
