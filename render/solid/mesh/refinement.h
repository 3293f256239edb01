#pragma once

#include "render/solid/mesh/cuts.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

/// What the mesher and the drawing of cuts have in common: how far to refine, what became of it, and the edges that the
/// boundary passes.
namespace solid {

struct RefineOptions {
    double tolerance = 0.01;             ///< scene units that the result may be off the body
    int cells = 16;                      ///< of the first lattice, along the longest side
    std::size_t most_parts = 6'000'000;  ///< tetrahedra or triangles that space is divided into
    /// Nothing is refined after it: what is made closes all the same, but may be farther off.
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
    const std::atomic<bool>* cancel = nullptr;
};

struct RefineFacts {
    int rounds = 0;
    std::size_t parts = 0;       ///< that space was divided into
    std::uint64_t lost = 0;      ///< edges whose ends are on two sides though no chord ends between them
    bool full = false;           ///< `most_parts` kept it from refining where it was wanted
    bool late = false;           ///< the deadline did
    std::size_t unresolved = 0;  ///< places that would have been refined, but are small enough
};

inline constexpr double kAimedShare =
    0.5;  // of the tolerance: the aim at places that are looked at; others may be worse
inline constexpr int kMostRefinements = 200;     // rounds
inline constexpr std::size_t kPartsOfTask = 64;  // edges or parts that a thread takes at a time

/// The edges that the boundary passes, by their keys.
class CutTable {
public:
    using Index = std::unordered_map<std::uint64_t, std::uint32_t, KeyHash>;
    using Shares = std::unordered_map<std::uint64_t, double, KeyHash>;

    const EdgeCut& operator[](std::uint32_t index) const { return cuts_[index]; }
    std::uint32_t index(std::uint64_t edge) const { return index_.at(edge); }
    std::size_t size() const { return cuts_.size(); }

    /// Takes what was found by whatever thread: the table is in the order of edges.
    void add(std::vector<EdgeCut> found)
    {
        std::sort(found.begin(), found.end(), [](const EdgeCut& a, const EdgeCut& b) { return a.edge < b.edge; });
        for (const EdgeCut& cut : found) {
            index_[cut.edge] = static_cast<std::uint32_t>(cuts_.size());
            if (cut.split == cut.split) repeated_.push_back(cut.edge);
            cuts_.push_back(cut);
        }
    }

    /// An edge that was split is none any more.
    void forget(std::uint64_t edge) { index_.erase(edge); }

    /// Edges that the boundary passes more than once, and where to split them.
    Shares repeated()
    {
        std::erase_if(repeated_, [&](std::uint64_t edge) { return !index_.contains(edge); });
        Shares out;
        for (const std::uint64_t edge : repeated_) out[edge] = cuts_[index_.at(edge)].split;
        return out;
    }

private:
    std::vector<EdgeCut> cuts_;
    Index index_;
    std::vector<std::uint64_t> repeated_;
};

/// Chooses an edge to be split at `share`, or the longest edge of its triangle or tetrahedron in the middle if that is
/// much longer: none becomes flat.
template <class Space>
void choose_split(const Space& space, std::uint64_t edge, double share, std::uint64_t longest, CutTable::Shares& chosen)
{
    constexpr double kLongEnough = 0.3;  // of the square of the longest
    if (space.length2(edge) >= kLongEnough * space.length2(longest)) chosen[edge] = share;
    else chosen.try_emplace(longest, 0.5);
}

/// Where edges are split, in the order of their keys: points get the same numbers whatever thread marked them.
inline std::vector<std::pair<std::uint64_t, double>> in_order(const CutTable::Shares& marked)
{
    std::vector<std::pair<std::uint64_t, double>> out(marked.begin(), marked.end());
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace solid
