#include "render/kernel/photon/photon_air.h"

#include "numbers/functions/functions.h"
#include "render/kernel/extinction/media_extinction.h"
#include "render/plan/shines_on.h"

#include <algorithm>
#include <cmath>

namespace trace {

/// False: nothing there dims or scatters light.
bool PhotonAir::find_mix(const PhotonStretch& stretch)
{
    mix_.clear();
    if (stretch.interiors.empty() || !stretch.interiors.all_hollow(scene_.interiors)) return false;
    mix_.add(scene_, stretch.interiors);
    return mix_.extinguishes || mix_.scatters;
}

/// Cuts the stretch into sub-intervals at the same places as for rays of the camera (spec 6, 2.4 and 2.5).
void PhotonAir::cut(const PhotonStretch& stretch)
{
    ranges_.clear();
    pieces_.clear();
    for (const light::Light& light : scene_.lights.lights) {
        MediaRange range;
        if (light.in_media && shines_on(light, stretch.end) && lit_range(light, stretch.ray, stretch.length, range))
            ranges_.push_back(range);
    }
    add_pieces(mix_, stretch.length, ranges_, pieces_);
}

PhotonAir::Spread PhotonAir::spread(const PhotonFlight& flight, const PhotonStretch& stretch, double length) const
{
    const scene::PhotonSettings& settings = scene_.photons->settings;
    const double apart = flight.parallel ? flight.step : flight.step * stretch.depth;
    const double many = std::floor(length / (apart * settings.media_factor));
    if (!(many > settings.media_steps)) return {static_cast<int>(std::max(0.0, many)), settings.media_factor};
    return {settings.media_steps, length / (apart * settings.media_steps)};
}

std::uint64_t PhotonAir::draws(const PhotonFlight& flight, const PhotonStretch& stretch)
{
    if (!stretch.leaves || !find_mix(stretch)) return 0;
    cut(stretch);
    std::uint64_t sum = 0;
    for (const MediaPiece& piece : pieces_)
        sum += static_cast<std::uint64_t>(piece.count) *
               static_cast<std::uint64_t>(spread(flight, stretch, piece.step).count);
    return sum;
}

void PhotonAir::cross(const PhotonFlight& flight, const PhotonStretch& stretch, JitterStream& jitter, glm::vec3& color)
{
    if (!find_mix(stretch)) return;
    if (!stretch.leaves) {
        color *= media_share(scene_, mix_, stretch.ray, 0.0, stretch.length);
        return;
    }
    cut(stretch);
    const bool stays = mix_.scatters && std::any_of(mix_.members.begin(), mix_.members.begin() + mix_.count,
                                                    [](const plan::Media* media) { return media->collect; });
    glm::vec3 share(1);
    texture::Points points;
    for (const MediaPiece& piece : pieces_)
        for (int i = 0; i < piece.count; ++i) {
            const double from = piece.from + i * piece.step;
            const Spread of = spread(flight, stretch, piece.step);
            glm::vec3 sum(0);
            points.count = 0;
            for (int n = 0; n < of.count; ++n) {
                const double place = (n + 0.5 + (jitter.draw() - 0.5) * scene_.photons->settings.jitter) / of.count;
                const double way = from + place * piece.step;
                const glm::dvec3 point = stretch.ray.at(way);
                points.add(point);
                if (points.count == texture::kMostPoints) sum += extinction(points);
                if (!stays) continue;
                const glm::vec3 flux = photon_flux(flight, color, stretch.depth + way, 3) *
                                       static_cast<float>(of.factor);
                stay_.push_back(make_photon(point, flux, -stretch.ray.direction));
            }
            if (points.count != 0) sum += extinction(points);
            // Where a sub-interval is too short for any, POV-Ray divides by none, and the photon is black from there
            // on.
            for (int c = 0; c < 3; ++c)
                share[c] *= of.count == 0 ? 0.0f
                                          : static_cast<float>(
                                                numbers::exp(-static_cast<double>(sum[c]) * piece.step / of.count));
        }
    color *= share;
}

/// The sum of the media's extinction at the points, which are removed.
glm::vec3 PhotonAir::extinction(texture::Points& points)
{
    glm::vec3 sum(0);
    const std::size_t count = points.size();
    points.pad();
    for (std::size_t m = 0; m < mix_.count; ++m) {
        const plan::Media& media = *mix_.members[m];
        if (!media.extinguishes()) continue;
        if (media.densities == 0) {
            sum += static_cast<float>(count) * media.extinction;
            continue;
        }
        const TileColors& density = density_.at(scene_, media, points, first_hits(static_cast<int>(count)));
        for (std::size_t k = 0; k < count; ++k) sum += media.extinction * density[k];
    }
    points.count = 0;
    return sum;
}

}  // namespace trace
