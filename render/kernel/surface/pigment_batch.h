#pragma once

#include "csg/base/hit.h"
#include "render/texture/evaluate_points.h"
#include "render/kernel/tile/row_page.h"

#include <array>
#include <utility>

namespace trace {

/// Pigments that some hits of a tile ask for: those of one pigment are evaluated together.
class PigmentBatch {
public:
    void clear() { count_ = 0, points_.count = 0; }

    /// Hit k of the tile (each at most once) asks for the pigment at p of pattern space; `around` stays until run().
    void ask(std::size_t k, std::uint32_t pigment, const glm::dvec3& p, const texture::Surroundings& around)
    {
        if (points_.count == 0) pigment_ = pigment;
        if (pigment == pigment_) add(static_cast<std::uint8_t>(k), p, around);
        else asked_[count_++] = {pigment, static_cast<std::uint8_t>(k), &around, p};
    }

    /// Hits of a tile ask for the same pigment, at their places among `points`.
    void ask(HitMask hits, std::uint32_t pigment, const texture::Points& points,
             const std::array<texture::Surroundings, csg::kTileRays>& around)
    {
        if (points_.count != 0 || (hits & (hits + 1)) != 0) {
            for_each_hit(hits, [&](std::size_t k) { ask(k, pigment, points.at(k), around[k]); });
            return;
        }
        // The first so many hits of the tile: their places are copied as they are.
        pigment_ = pigment;
        points_ = points;
        points_.count = std::popcount(hits);
        in_order_ = true;
        for (std::size_t k = 0; k < points_.size(); ++k) {
            around_[k] = &around[k];
            owner_[k] = static_cast<std::uint8_t>(k);
        }
    }

    /// Calls give(hits, colours) for every group of questions, one a pigment; the colours are in the places of the
    /// hits.
    template <class Give>
    void run(const texture::TextureSet& set, Give&& give)
    {
        while (points_.count != 0) {
            points_.pad();
            texture::pigment_colors(set, pigment_, points_, around_, colors_);
            if (in_order_) {
                give(first_hits(points_.count), std::as_const(colors_));
            } else {
                HitMask hits = 0;
                for (std::size_t i = 0; i < points_.size(); ++i) {
                    hits |= HitMask{1} << owner_[i];
                    placed_.set(owner_[i], colors_.at(i));
                }
                give(hits, std::as_const(placed_));
            }
            take_next();
        }
    }

private:
    void add(std::uint8_t hit, const glm::dvec3& p, const texture::Surroundings& around)
    {
        in_order_ = (points_.count == 0 || in_order_) && hit == points_.size();
        owner_[points_.size()] = hit;
        around_[points_.size()] = &around;
        points_.add(p);
    }

    /// The questions for the next pigment, if there are any.
    void take_next()
    {
        points_.count = 0;
        pigment_ = count_ != 0 ? asked_[0].pigment : 0;
        std::size_t left = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const Question q = asked_[i];
            if (q.pigment == pigment_) add(q.hit, q.point, *q.around);
            else asked_[left++] = q;
        }
        count_ = left;
    }

    struct Question {
        std::uint32_t pigment;
        std::uint8_t hit;
        const texture::Surroundings* around;
        glm::dvec3 point;
    };
    std::array<Question, csg::kTileRays> asked_;  ///< for other pigments than the first one
    std::size_t count_ = 0;
    std::uint32_t pigment_ = 0;
    texture::Points points_;  ///< that ask for it
    texture::Around around_;
    std::array<std::uint8_t, csg::kTileRays> owner_;
    texture::ColorPoints colors_, placed_;  ///< in the order of the questions; by hit
    bool in_order_ = false;                 ///< question i is hit i's
};

}  // namespace trace
