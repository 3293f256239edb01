#include "numbers/functions/functions.h"
#include "render/kernel/radiosity/samples/direction_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace trace::radiosity {
namespace {

constexpr std::uint32_t kAcross = 256;  ///< of the square that the curve fills

/// A direction's place in the unit square: those of one height above the horizon lie on a square about the middle
/// (Shirley and Chiu, A low distortion map between disk and square, 1997), and equal areas get as many directions.
glm::dvec2 in_square(const glm::dvec3& d)
{
    const double r = std::sqrt(d.x * d.x + d.z * d.z);
    if (r == 0.0) return glm::dvec2(0.5);
    double turn = numbers::atan2(d.z, d.x) / (0.25 * std::numbers::pi);  // -4 to 4
    glm::dvec2 at;
    if (std::abs(turn) <= 1.0) {
        at = {r, r * turn};
    } else if (std::abs(turn) >= 3.0) {
        at = {-r, r * (turn > 0.0 ? 4.0 - turn : -4.0 - turn)};
    } else {
        at = {r * (2.0 - std::abs(turn)), turn > 0.0 ? r : -r};
    }
    return 0.5 + 0.5 * at;
}

/// How far along Hilbert's curve a place lies.
std::uint32_t along_curve(const glm::dvec2& at)
{
    const auto step = [](double v) {
        return static_cast<std::uint32_t>(glm::clamp(v * kAcross, 0.0, static_cast<double>(kAcross - 1)));
    };
    std::uint32_t x = step(at.x), y = step(at.y), out = 0;
    for (std::uint32_t side = kAcross / 2; side > 0; side /= 2) {
        const std::uint32_t right = (x & side) != 0 ? 1 : 0, up = (y & side) != 0 ? 1 : 0;
        out += side * side * ((3 * right) ^ up);
        if (up != 0) continue;
        if (right != 0) {
            x = kAcross - 1 - x;
            y = kAcross - 1 - y;
        }
        std::swap(x, y);
    }
    return out;
}

}  // namespace

DirectionOrder::DirectionOrder(const std::vector<glm::dvec3>& pool) : place(pool.size())
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> keyed;
    for (const glm::dvec3& d : pool)
        keyed.emplace_back(along_curve(in_square(d)), static_cast<std::uint32_t>(keyed.size()));
    std::sort(keyed.begin(), keyed.end());
    for (const auto& [key, number] : keyed) {
        place[number] = static_cast<std::uint32_t>(entries.size());
        entries.push_back({pool[number], number});
    }
}

}  // namespace trace::radiosity
