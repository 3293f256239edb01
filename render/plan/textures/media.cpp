#include "render/plan/textures/chi_square.h"
#include "render/plan/textures/media_compiler.h"

#include <algorithm>

namespace plan {
namespace {

bool black_media(const scene::Media& media)
{
    return media.emission == glm::vec3(0) && media.absorption == glm::vec3(0) && media.scattering.color == glm::vec3(0);
}

/// Bounds of the variance of a mean of n samples, by n (spec 6, 2.7).
std::vector<double> variance_bounds(const scene::Media& media)
{
    constexpr int kMost = 1000;  // behind it they grow evenly
    constexpr double kNearlyZero = 1e-10;
    if (media.samples_most <= media.samples_least) return {};
    const double last = chi_square(media.samples_most - 1, media.confidence);
    const double scale = last > 0.0 ? media.variance / last : media.variance * kNearlyZero;
    std::vector<double> out{0.0};
    for (int n = 1; n <= std::min(kMost, media.samples_most + 1); ++n)
        out.push_back(scale * chi_square(n, media.confidence));
    return out;
}

}  // namespace

bool depends_on_place(const scene::Media& media)
{
    return std::any_of(media.densities.begin(), media.densities.end(), [](const scene::Pigment& density) {
        return !std::holds_alternative<scene::Color>(density.kind);
    });
}

MediaList MediaCompiler::list(const std::vector<std::shared_ptr<const scene::Media>>& media)
{
    MediaList out;
    const bool nothing = std::all_of(media.begin(), media.end(), [](const auto& one) { return black_media(*one); });
    if (!drawn_ || media.empty()) return out;
    if (nothing && drop_black_) {
        ++dropped_;
        return out;
    }
    std::vector<std::uint32_t> members;
    for (const auto& one : media) members.push_back(medium(one));
    out.first = static_cast<std::uint32_t>(out_.order.size());
    out.count = static_cast<std::uint32_t>(members.size());
    out_.order.insert(out_.order.end(), members.begin(), members.end());
    out.extinguishes =
        std::any_of(members.begin(), members.end(), [this](std::uint32_t m) { return out_.media[m].extinguishes(); });
    return out;
}

std::uint32_t MediaCompiler::medium(const std::shared_ptr<const scene::Media>& media)
{
    if (const auto known = known_.find(media); known != known_.end()) return known->second;
    const scene::Media& from = *media;
    Media to;
    const glm::vec3& scattering = from.scattering.color;
    glm::vec3 plain(1);
    std::vector<std::uint32_t> densities;
    for (const scene::Pigment& density : from.densities) {
        if (const auto* color = std::get_if<scene::Color>(&density.kind)) plain *= color->rgb();
        else densities.push_back(textures_.pigment(density));
    }
    to.emission = from.emission * plain;
    to.scattering = scattering * plain;
    to.extinction = (from.absorption + static_cast<float>(from.scattering.extinction) * scattering) * plain;
    to.has_density = !from.densities.empty();
    to.plain = from.densities.size() <= 1 && densities.empty();
    to.first_density = static_cast<std::uint32_t>(out_.densities.size());
    to.densities = static_cast<std::uint32_t>(densities.size());
    out_.densities.insert(out_.densities.end(), densities.begin(), densities.end());
    to.phase = from.scattering.phase;
    to.eccentricity = from.scattering.eccentricity;
    to.method = from.method;
    to.intervals = from.intervals;
    to.samples_least = from.samples_least;
    to.samples_most = from.samples_most;
    to.ratio = from.ratio;
    to.jitter = from.jitter;
    to.whole = povray_ == scene::PovRay::V38;
    to.aa_level = from.aa_level;
    to.aa_threshold = from.aa_threshold;
    to.collect = from.collect;
    if (to.method != Media::Method::Adaptive) to.enough = variance_bounds(from);
    const auto index = static_cast<std::uint32_t>(out_.media.size());
    out_.media.push_back(std::move(to));
    known_.emplace(media, index);
    return index;
}

}  // namespace plan
