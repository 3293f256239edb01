#pragma once

#include "render/kernel/extinction/media_density.h"
#include "render/kernel/extinction/media_mix.h"
#include "render/kernel/tile/row_page.h"

#include <array>
#include <cstdint>
#include <vector>

namespace trace {

/// Three numbers for each of many.
struct MediaColors {
    std::vector<float> red, green, blue;

    glm::vec3 operator[](std::size_t i) const { return {red[i], green[i], blue[i]}; }
    void set(std::size_t i, const glm::vec3& c)
    {
        red[i] = c.x;
        green[i] = c.y;
        blue[i] = c.z;
    }
    /// Room for so many; it stays.
    void at_least(std::size_t count)
    {
        if (red.size() >= count) return;
        red.resize(count);
        green.resize(count);
        blue.resize(count);
    }
};

/// Samples side by side: whose they are, where on their sub-interval (0 to 1), and what was found there. Arrays are as
/// long as they ever were: clearing new places would take longer than what is written there.
struct MediaSamples {
    std::size_t count = 0;
    std::vector<std::uint8_t> job;
    std::vector<double> place;
    MediaColors light, depth;  ///< e and o of spec 6, 2.6
    bool told_depth = true;    ///< false: nobody looks at `depth`

    std::size_t size() const { return count; }
    void clear() { count = 0; }
    std::uint32_t add(std::uint32_t of, double at)
    {
        const std::size_t i = grow(1);
        job[i] = static_cast<std::uint8_t>(of);
        place[i] = at;
        return static_cast<std::uint32_t>(i);
    }
    /// Room for so many more, which are to be filled in; the first of them.
    std::size_t grow(std::size_t more)
    {
        const std::size_t first = count;
        count += more;
        if (job.size() < count) {
            job.resize(count);
            place.resize(count);
        }
        return first;
    }
};

/// A sub-interval that is to be sampled.
struct MediaJob {
    const MediaMix* mix;
    std::uint8_t segment;    ///< its place among those of the tile
    std::uint8_t lane;       ///< of the segment in the tile
    bool lit;                ///< some light may reach it
    std::uint32_t interval;  ///< its number in the segment
    std::uint64_t seed;      ///< of the segment's random numbers
};

/// Sub-intervals of some segments that are sampled alike, worked off together. A lane each.
struct MediaChunk {
    static constexpr int kMost = csg::kTileRays;

    int count = 0;
    const plan::Media* control = nullptr;  ///< what all of them are sampled as
    bool one_mix = true;                   ///< all are of the same media
    std::array<MediaJob, kMost> jobs;
    alignas(64) std::array<double, kMost> from, step;              ///< distances along their rays
    alignas(64) std::array<double, kMost> ox, oy, oz, dx, dy, dz;  ///< of the rays
    /// What comes of them: sums over `taken` samples or gaps.
    std::array<glm::vec3, kMost> light, depth;
    std::array<int, kMost> taken;

    void clear() { count = 0, control = nullptr, one_mix = true; }
    /// Whether one that goes by this control fits in.
    bool takes(const plan::Media& other) const;
    std::size_t add(const MediaJob& job, const csg::Ray& ray, double at, double length);
    csg::Ray ray(std::size_t i) const { return {{ox[i], oy[i], oz[i]}, {dx[i], dy[i], dz[i]}}; }
    /// A number that depends on the ray, the sub-interval and the sample.
    double random(std::size_t i, std::uint32_t sample) const;
};

}  // namespace trace
