#pragma once

#include "render/plan/compiled_scene.h"
#include "render/kernel/tile/ray_state.h"

#include <array>

namespace trace {

/// The media that fill a stretch together, and what they agree on (spec 6, 2.3).
struct MediaMix {
    static constexpr std::size_t kMost = 256;  ///< POV-Ray gives up beyond; here the others are left out
    std::array<const plan::Media*, kMost> members;
    std::size_t count = 0;
    const plan::Media* control = nullptr;  ///< the one with the most intervals: its ways of sampling are used for all
    float threshold = 0;                   ///< of method 3: the least of all
    bool scatters = false, extinguishes = false;
    bool patterned = false;  ///< some density differs from place to place
    bool plain = true;       ///< each has one density at most, of one colour
    bool one_kind = true;    ///< all scatter by the same law

    void clear()
    {
        count = 0;
        control = nullptr;
        scatters = extinguishes = patterned = false;
        plain = one_kind = true;
    }
    void add(const plan::MediaSet& set, const plan::MediaList& list);
    /// Of everything a ray is inside of, in order.
    void add(const plan::CompiledScene& scene, const InteriorList& interiors)
    {
        for (std::size_t i = 0; i < interiors.size(); ++i) add(scene.media, scene.interiors[interiors[i]].media);
    }
    bool same_members(const MediaMix& other) const;

    /// Share of the light that turns into the ray, by the cosine of the angle between the ray and the way to the light
    /// (spec 6, 2.9): the mean of all members, whatever each of them scatters.
    double phase(double cosine) const;
};

}  // namespace trace
