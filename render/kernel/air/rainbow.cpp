#include "numbers/functions/functions.h"
#include "numbers/random.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/kernel/air/rainbow.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

/// A rainbow along one direction: false where it is not. edge: how far beyond its unfaded arc, 0 to 1; place: from the
/// inner to the outer edge, in [0, 1).
bool meets(const texture::Rainbow& bow, std::uint32_t number, const glm::dvec3& d, double& edge, double& place)
{
    const double x = glm::dot(d, bow.right), y = glm::dot(d, bow.up), along = glm::dot(d, bow.antisolar);
    const double length = std::sqrt(x * x + y * y);
    const double from_up = std::abs(numbers::acos(length > 0.0 ? y / length : y));
    if (!(from_up <= bow.arc) || along < 0.0) return false;
    place = (numbers::acos(std::min(along, 1.0)) - (bow.angle - bow.width / 2.0)) / bow.width;
    if (bow.jitter > 0.0)
        place += (2.0 * numbers::random_of(numbers::random_seed(glm::dvec3(0), d), number, 0) - 1.0) * bow.jitter;
    if (!(place >= 0.0 && place <= 1.0 - kNearlyZero)) return false;
    edge = 0.0;
    if (from_up > bow.falloff && bow.arc > bow.falloff) {
        const double w = (from_up - bow.falloff) / (bow.arc - bow.falloff);
        edge = w * w * (3.0 - 2.0 * w);
    }
    return true;
}

scene::Color color_at(const texture::TextureSet& set, const texture::Rainbow& bow, double place)
{
    return texture::mapped(set, bow.blending, texture::blend_at(set, bow.first, bow.count, place));
}

}  // namespace

Air rainbow_air(const Context& context, const csg::Ray& ray, double length)
{
    Air sum{glm::vec3(0), glm::vec3(0), 1.0f};
    int seen = 0;
    std::uint32_t number = 0;
    for (const texture::Rainbow& bow : context.scene.rainbows) {
        double edge = 0.0, place = 0.0;
        if (!meets(bow, number++, ray.direction, edge, place)) continue;
        const scene::Color color = color_at(context.scene.textures, bow, place);
        const auto transmit = static_cast<double>(color.transmit);
        const auto keeps =
            static_cast<float>(std::max(numbers::exp(-length / bow.distance), edge * (1.0 - transmit) + transmit));
        const float filter = color.filter * (1.0f - keeps);
        sum.share += keeps * ((1.0f - filter) + filter * color.rgb());
        sum.glow += (1.0f - keeps) * color.rgb();
        sum.clear *= keeps * color.transmit;
        ++seen;
    }
    if (seen == 0) return {};
    const float each = 1.0f / static_cast<float>(seen);
    return {sum.share * each, sum.glow * each, sum.clear};
}

}  // namespace trace
