#include "render/picture/passes/pass_rays.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace trace::radiosity {
namespace {

/// POV-Ray's numbers in [-1, 1) (spec 6, 1.3).
class Jitter {
public:
    explicit Jitter(std::size_t start) : at_(start % kCount) {}
    double next()
    {
        at_ = (at_ + 1) % kCount;
        return table()[at_];
    }

private:
    static constexpr std::size_t kCount = 2047;
    static const std::array<double, kCount>& table()
    {
        static const std::array<double, kCount> numbers = [] {
            std::array<double, kCount> made{};
            std::mt19937 random;  // the standard's default seed
            for (double& v : made) v = -1.0 + 2.0 * (static_cast<double>(random()) / 4294967296.0);
            return made;
        }();
        return numbers;
    }
    std::size_t at_;
};

/// All pixels of a part, in squares of 8x8 so that neighbours share a tile.
std::vector<glm::dvec2> every_pixel(int left, int right, int top, int bottom)
{
    constexpr int kSide = 8;
    std::vector<glm::dvec2> out;
    for (int y = top; y < bottom; y += kSide)
        for (int x = left; x < right; x += kSide)
            for (int j = y; j < std::min(y + kSide, bottom); ++j)
                for (int i = x; i < std::min(x + kSide, right); ++i) out.emplace_back(i, j);
    return out;
}

}  // namespace

std::vector<Pass> passes(double pretrace_start, double pretrace_end, int width, int height, scene::PovRay povray)
{
    constexpr double kNearlyZero = 1e-10;
    const double most = std::max(width, height), start = most * pretrace_start,
                 end = std::max(1.0, most * pretrace_end);
    const int count = std::max(1, static_cast<int>(std::floor(numbers::log2(start / end) + 1.0 - kNearlyZero)) + 1);
    const double shift = povray == scene::PovRay::V38 ? -0.5 : 0.0;
    std::vector<Pass> out;
    for (int j = 0; j < count; ++j) out.push_back({j, std::max(std::ldexp(start, -j), end), true, shift});
    out.push_back({count, 1.0, false});
    return out;
}

std::vector<glm::dvec2> rays_of(const Pass& pass, const Parts& parts, int part)
{
    const int left = part % parts.columns() * Parts::kSide, top = part / parts.columns() * Parts::kSide;
    const int right = std::min(left + Parts::kSide, parts.width), bottom = std::min(top + Parts::kSide, parts.height);
    if (!pass.pretrace) return every_pixel(left, right, top, bottom);
    Jitter jitter(17 * static_cast<std::size_t>(pass.number + 1) + 13 * static_cast<std::size_t>(part));
    const double z = pass.step, amplitude = std::min(1.0, z / 2.0), middle = (z - 1.0) / 2.0 + pass.shift;
    std::vector<glm::dvec2> out;
    for (double y = std::ceil((top - 0.5) / z) * z; y < bottom; y += z) {
        if (y < top) continue;
        for (double x = std::ceil((left - 0.5) / z) * z; x < right; x += z) {
            if (x < left) continue;
            const double down = jitter.next(), across = jitter.next();
            out.emplace_back(x + middle + amplitude * across, y + middle + amplitude * down);
        }
    }
    return out;
}

}  // namespace trace::radiosity
