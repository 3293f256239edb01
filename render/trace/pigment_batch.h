#pragma once

#include "csg/hit.h"
#include "render/texture/evaluate_points.h"

#include <array>

namespace trace {

/// Pigments that some hits of a tile ask for: those of one pigment are evaluated together.
class PigmentBatch {
public:
    void clear() { count_ = 0; }

    /// Hit k of the tile (each at most once) asks for the pigment at p of pattern space; `around` stays until run().
    void ask(std::size_t k, std::uint32_t pigment, const glm::dvec3& p, const texture::Surroundings& around)
    {
        asked_[count_++] = {pigment, static_cast<std::uint8_t>(k), &around, p};
    }

    /// Calls give(k, colour) for every question, in groups by pigment.
    template <class Give>
    void run(const texture::TextureSet& set, Give&& give)
    {
        while (count_ != 0) {
            const std::uint32_t pigment = asked_[0].pigment;
            std::size_t left = 0;
            points_.count = 0;
            for (std::size_t i = 0; i < count_; ++i) {
                const Question q = asked_[i];
                if (q.pigment != pigment) {
                    asked_[left++] = q;
                    continue;
                }
                owner_[points_.size()] = q.hit;
                around_[points_.size()] = q.around;
                points_.add(q.point);
            }
            count_ = left;
            points_.pad();
            texture::pigment_colors(set, pigment, points_, around_, colors_.data());
            for (std::size_t i = 0; i < points_.size(); ++i) give(owner_[i], colors_[i]);
        }
    }

private:
    struct Question {
        std::uint32_t pigment;
        std::uint8_t hit;
        const texture::Surroundings* around;
        glm::dvec3 point;
    };
    std::array<Question, csg::kTileRays> asked_;
    std::size_t count_ = 0;
    texture::Points points_;
    texture::Around around_;
    std::array<std::uint8_t, csg::kTileRays> owner_;
    std::array<scene::Color, csg::kTileRays> colors_;
};

/// Most layers of a texture whose pigments are looked up for a whole tile ahead of shading.
inline constexpr std::uint32_t kLayersAhead = 8;

/// Pigments of the layers of a hit, by layer; those that layers above hide are not filled in.
struct LayersAhead {
    std::uint32_t texture;           ///< kNone: nothing was looked up
    bool flat;                       ///< AheadLayers::flat
    float residual;                  ///< share of light that the layers so far let through, or more
    glm::vec3 filter;
    std::array<scene::Color, kLayersAhead> colors;
};

}  // namespace trace
