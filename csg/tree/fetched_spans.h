#pragma once

#include "csg/freeform/shared/ray_batch.h"

#include <algorithm>
#include <vector>

namespace csg {

/// Spans of a CSG object's costly leaves, found for the rays of a tile together before the object is asked ray by ray.
class FetchedSpans {
public:
    void clear()
    {
        leaves_.clear();
        solids_.clear();
        ends_.clear();
        ray_ = kNoRay;
    }

    /// What a leaf told of the rays of a batch, whose records began with the range of each.
    void add(const void* solid, const RayBatch& batch)
    {
        Leaf& leaf = leaves_.emplace_back();
        solids_.push_back(solid);
        for (std::size_t k = 0; k < batch.count; ++k) {
            const IntersectionList& record = batch.records[k];
            Part& part = leaf.parts[batch.place[k]];
            part = {record.from, record.to, static_cast<std::uint32_t>(ends_.size()), 0};
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
    bool each_span(const void* solid, double from, double to, F&& f) const
    {
        if (ray_ == kNoRay) return false;
        const auto leaf = std::find(solids_.begin(), solids_.end(), solid);
        if (leaf == solids_.end()) return false;
        const Part& part =
            leaves_[static_cast<std::size_t>(leaf - solids_.begin())].parts[static_cast<std::size_t>(ray_)];
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

    std::vector<const void*> solids_;  ///< of the leaves: apart, for they are looked through
    std::vector<Leaf> leaves_;         // kept for their memory
    std::vector<Ends> ends_;
    int ray_ = kNoRay;
};

}  // namespace csg
