#pragma once

#include "render/kernel/gather/photon.h"
#include "render/kernel/photon/dispersed_filters.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace trace {

/// A stretch of a photon's way, to a surface, and what it leaves there.
struct PhotonStep {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::uint32_t first = kNone, last = kNone, next = kNone;  ///< steps of photons that go on from here
    bool stays = false;
    Photon photon;
    glm::vec3 flux;                          ///< the photon's, before it is packed
    std::uint64_t draws = 0;                 ///< of random numbers on its way through media
    std::size_t media = 0, media_count = 0;  ///< photons that it has left there
    DispersedFilters::Part filter;
};

/// What photons leave, as a forest: a photon's own stays before what it sends on, one way after the other. The first
/// steps are those of the photons that a light has sent.
class PhotonForest {
public:
    void begin(std::size_t photons)
    {
        steps_.clear();
        steps_.resize(photons);
    }
    /// A photon that goes on from a step.
    std::uint32_t add(std::uint32_t from)
    {
        const auto added = static_cast<std::uint32_t>(steps_.size());
        steps_.emplace_back();
        PhotonStep& before = steps_[from];
        (before.first == PhotonStep::kNone ? before.first : steps_[before.last].next) = added;
        before.last = added;
        return added;
    }
    PhotonStep& operator[](std::uint32_t step) { return steps_[step]; }
    PhotonStep& last() { return steps_.back(); }
    std::size_t size() const { return steps_.size(); }

    /// f(step) for all that a photon leaves, one way after the other.
    template <class F>
    void in_order(std::uint32_t root, F&& f)
    {
        if (steps_[root].first == PhotonStep::kNone) return f(root);
        order_.assign(1, root);
        while (!order_.empty()) {
            const std::uint32_t at = order_.back();
            order_.pop_back();
            f(at);
            const std::size_t begin = order_.size();
            for (std::uint32_t next = steps_[at].first; next != PhotonStep::kNone; next = steps_[next].next)
                order_.push_back(next);
            std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(begin), order_.end());
        }
    }

    /// Of a photon that was dispersed: what its samples leave, by the filters that POV-Ray takes. `media`: photons that
    /// stay there.
    void filter_samples(std::uint32_t root, std::vector<Photon>& media)
    {
        DispersedFilters filters;
        in_order(root, [&](std::uint32_t s) {
            PhotonStep& step = steps_[s];
            filters.visit(step.filter);
            const glm::vec3 factor = step.filter.factor;
            for (std::uint32_t next = step.first; next != PhotonStep::kNone; next = steps_[next].next)
                steps_[next].filter.factor = factor;
            if (factor == glm::vec3(1.0f)) return;
            if (step.stays) set_flux(step.photon, factor * step.flux);
            for (std::size_t i = step.media; i < step.media + step.media_count; ++i)
                set_flux(media[i], factor * flux_of(media[i]));
        });
    }

private:
    std::vector<PhotonStep> steps_;
    std::vector<std::uint32_t> order_;
};

}  // namespace trace
