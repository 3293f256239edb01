#pragma once

#include "csg/freeform/shared/ray_batch.h"

#include <algorithm>
#include <vector>

namespace csg {

struct Node;

/// Spans of a CSG object's costly leaves, found for the rays of a tile together before the object is asked ray by ray.
class FetchedSpans {
public:
    void clear()
    {
        leaves_.clear();
        keys_.clear();
        ends_.clear();
        ray_ = kNoRay;
    }

    /// What a leaf told of the rays of a batch. range(k): that of ray k of the tile in which the leaf is known now,
    /// whatever part of it the batch was asked for.
    template <class RangeOf>
    void add(const Node* leaf_of, const RayBatch& batch, RangeOf&& range)
    {
        Leaf& leaf = leaves_.emplace_back();
        keys_.push_back(leaf_of);
        for (std::size_t k = 0; k < batch.count; ++k) {
            const IntersectionList& record = batch.records[k];
            Part& part = leaf.parts[batch.place[k]];
            const auto [from, to] = range(batch.place[k]);
            part = {from, to, static_cast<std::uint32_t>(ends_.size()), 0};
            record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                ends_.push_back({in, out, in_face, out_face});
                ++part.count;
            });
        }
    }

    /// The ray that the object is asked about next, by its place in the tile.
    void select(int ray) { ray_ = ray; }

    /// Calls f(t in, face, t out, face) for the leaf's spans along that ray. False: they are not known for [from, to].
    template <class F>
    bool each_span(const Node* leaf_of, double from, double to, F&& f) const
    {
        if (ray_ == kNoRay) return false;
        const auto leaf = std::find(keys_.begin(), keys_.end(), leaf_of);
        if (leaf == keys_.end()) return false;
        const Part& part =
            leaves_[static_cast<std::size_t>(leaf - keys_.begin())].parts[static_cast<std::size_t>(ray_)];
        if (!(part.from <= from && to <= part.to)) return false;
        for (std::uint32_t i = part.first; i < part.first + part.count; ++i)
            f(ends_[i].in, ends_[i].in_face, ends_[i].out, ends_[i].out_face);
        return true;
    }

private:
    static constexpr int kNoRay = -1;

    struct Ends {
        double in, out;
        std::uint32_t in_face, out_face;
    };
    /// Ends of one ray. As it begins no range lies within it.
    struct Part {
        double from = kInfinity, to = -kInfinity;
        std::uint32_t first = 0, count = 0;
    };
    struct Leaf {
        std::array<Part, kTileRays> parts;
    };

    std::vector<const Node*> keys_;  ///< of the leaves: apart, for they are looked through
    std::vector<Leaf> leaves_;       // kept for their memory
    std::vector<Ends> ends_;
    int ray_ = kNoRay;
};

}  // namespace csg
