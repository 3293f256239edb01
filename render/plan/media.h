#pragma once

#include "render/scene/media.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace plan {

/// A medium ready for tracing (spec 6, 2.1). Coefficients are per scene unit.
struct Media {
    using Method = scene::Media::Method;
    using Phase = scene::Media::Phase;

    glm::vec3 emission{0}, scattering{0};
    glm::vec3 extinction{0};                         ///< absorption, and the share of scattering that the ray loses
    std::uint32_t first_density = 0, densities = 0;  ///< pigments in CompiledScene::densities; all are multiplied
    bool has_density = false;                        ///< as written: plain ones are part of the coefficients here
    bool plain = true;                               ///< no density, or one of one colour
    Phase phase = Phase::Isotropic;
    double eccentricity = 0;
    Method method = Method::Adaptive;
    int intervals = 1, samples_least = 10, samples_most = 10;
    double ratio = 0.9, jitter = 0;
    /// Adaptive samples reach the end of an interval, and gaps dim their own light, as since POV-Ray 3.8 (spec 7d, 2).
    bool whole = false;
    int aa_level = 3;
    double aa_threshold = 0.1;
    bool collect = true;
    /// Variance below which n samples are enough; entry 0 is unused. Empty where no more than the least are taken.
    std::vector<double> enough;

    /// Gaps between the samples of an adaptive interval (spec 6, 2.7; spec 7d, 2).
    int gaps() const { return whole ? (samples_least + 1) / 2 : std::max(2, samples_least / 2 + 1); }
    /// How many of them the interval is long: before POV-Ray 3.8 one is never looked at.
    int gaps_to_end() const { return whole ? gaps() : gaps() + 1; }
    bool scatters() const { return scattering != glm::vec3(0); }
    bool extinguishes() const { return extinction != glm::vec3(0); }
    /// Whether places of samples, as far as it says them, depend on random numbers.
    bool draws() const { return method == Method::Random || jitter != 0 || !enough.empty(); }
    /// For more samples than `enough` knows, as much more as for its last ones.
    double enough_after(std::size_t n) const
    {
        const std::size_t last = enough.size() - 1;
        if (n <= last) return enough[n];
        return enough[last] + (enough[last] - enough[last - 1]) * static_cast<double>(n - last);
    }
};

/// Media that fill a stretch of space together: indices into CompiledScene::media, in CompiledScene::media_order.
struct MediaList {
    std::uint32_t first = 0, count = 0;
    bool extinguishes = false;  ///< light that passes is dimmed

    bool empty() const { return count == 0; }
};

/// Media of a scene as flat arrays.
struct MediaSet {
    std::vector<Media> media;
    std::vector<std::uint32_t> order;      ///< of MediaLists, indices into `media`
    std::vector<std::uint32_t> densities;  ///< indices into TextureSet::pigments
};

}  // namespace plan
