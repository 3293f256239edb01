#pragma once

#include "csg/base/cancel.h"
#include "render/solid/mesh/refinement.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace solid {

/// Space (or a plane) in parts that meet side to side, refined where the boundary of a body is not told by the parts
/// that it passes. \tparam Space Tetrahedra or PlaneTriangles \tparam State what is known of a part, `known` and
/// `coarse`
template <class Space, class State>
class Refiner {
protected:
    using Part = typename decltype(Space::all)::value_type;

    Refiner(const Body& body, const RefineOptions& options, RefineFacts& facts)
        : body_(body), options_(options), facts_(facts)
    {}
    virtual ~Refiner() = default;

    /// What the boundary looks like in the active parts whose state is not known.
    virtual void find_patches() = 0;

    /// From the lattice on, whose sides and cuts are known.
    void refine_all()
    {
        constexpr std::size_t kNewParts = std::size_t{1} << (std::tuple_size_v<Part> - 1);  // of an edge that is split
        for (facts_.rounds = 0; facts_.rounds < kMostRefinements; ++facts_.rounds) {
            collect_active();
            CutTable::Shares marks = repeated_cuts();
            if (marks.empty()) {
                find_patches();
                marks = coarse_patches();
            }
            if (marks.empty()) break;
            facts_.late = std::chrono::steady_clock::now() >= options_.deadline;
            facts_.full = space_.all.size() + kNewParts * marks.size() > options_.most_parts;
            if (facts_.late || facts_.full) break;
            if constexpr (requires { space_.spread(marks); }) space_.spread(marks);
            refine(in_order(marks));
        }
        collect_active();
        find_patches();
        facts_.parts = space_.all.size();
        facts_.lost = lost_;
    }

    static constexpr std::uint32_t kNoCorner = 0xffffffffu;
    /// Cuts of the edges of one line of the lattice. corner(k): its points, kNoCorner behind the last.
    template <class Corner>
    void follow(const glm::dvec3& from, const glm::dvec3& step, Corner&& corner, std::vector<EdgeCut>& found)
    {
        thread_local std::vector<Chord> chords;
        const double length = glm::length(step);
        body_.chords(from, step / length, -numbers::kInfinity, numbers::kInfinity, chords);
        std::uint64_t lost = 0;
        for (int k = 0;; ++k) {
            const std::uint32_t a = corner(k), b = corner(k + 1);
            if (b == kNoCorner) break;
            EdgeCut cut;
            cut.edge = edge_key(a, b);  // a < b: the directions lead upward
            if (cut_edge(body_, passing_, from, step / length, k * length, length, space_.inside[a] != 0,
                         space_.inside[b] != 0, chords, cut, lost))
                found.push_back(cut);
        }
        lost_ += lost;
    }

    void look_for_cancel() const
    {
        if (options_.cancel != nullptr && *options_.cancel) throw csg::Cancelled();
    }

    /// f(state, part) for the active parts whose state is not known, by threads.
    template <class F>
    void each_unknown(F&& f)
    {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, active_.size(), kPartsOfTask), [&](const auto& range) {
            look_for_cancel();
            for (std::size_t k = range.begin(); k < range.end(); ++k) {
                State& state = state_[active_[k]];
                if (!state.known) f(state, space_.all[active_[k]]);
                state.known = true;
            }
        });
    }

    const Body& body_;
    const RefineOptions& options_;
    RefineFacts& facts_;
    Finish finish_, passing_;  ///< of what lies within parts; of crossings of their edges
    Space space_;
    CutTable cuts_;
    std::vector<std::uint32_t> active_;
    std::vector<State> state_;  ///< by part

private:
    /// f(a, b) for the edges of a part.
    template <class F>
    static void each_edge(const Part& part, F&& f)
    {
        for (std::size_t k = 0; k < part.size(); ++k)
            for (std::size_t l = k + 1; l < part.size(); ++l) f(part[k], part[l]);
    }

    /// Parts with corners on both sides.
    void collect_active()
    {
        look_for_cancel();
        active_.clear();
        for (std::size_t i = 0; i < space_.all.size(); ++i) {
            std::size_t inside = 0;
            for (const std::uint32_t corner : space_.all[i]) inside += space_.inside[corner];
            if (inside != 0 && inside != space_.all[i].size()) active_.push_back(static_cast<std::uint32_t>(i));
        }
        state_.resize(space_.all.size());
    }

    /// Edges that the boundary passes again are split where it does.
    CutTable::Shares repeated_cuts()
    {
        const CutTable::Shares wanted = cuts_.repeated();
        CutTable::Shares chosen;
        if (wanted.empty()) return chosen;
        std::vector<std::uint8_t> touched(space_.points.size());
        for (const auto& [edge, share] : wanted) touched[first_of(edge)] = touched[second_of(edge)] = 1;
        for (const Part& part : space_.all)
            each_edge(part, [&](std::uint32_t a, std::uint32_t b) {
                if (touched[a] == 0 || touched[b] == 0) return;
                if (const auto found = wanted.find(edge_key(a, b)); found != wanted.end())
                    choose_split(space_, found->first, found->second, space_.longest_edge(part), chosen);
            });
        return chosen;
    }

    CutTable::Shares coarse_patches()
    {
        CutTable::Shares marked;
        facts_.unresolved = 0;
        for (const std::uint32_t i : active_) {
            if (!state_[i].coarse) continue;
            const std::uint64_t edge = space_.longest_edge(space_.all[i]);
            if (space_.length2(edge) < finish_.least * finish_.least) ++facts_.unresolved;
            else marked[edge] = 0.5;
        }
        return marked;
    }

    void refine(const std::vector<std::pair<std::uint64_t, double>>& marks)
    {
        const auto first = static_cast<std::uint32_t>(space_.points.size());
        CutTable::Index middles;
        for (const auto& [edge, share] : marks) {
            middles[edge] = static_cast<std::uint32_t>(space_.points.size());
            const glm::dvec3 a = space_.points[first_of(edge)], b = space_.points[second_of(edge)];
            space_.points.push_back(a + share * (b - a));
        }
        space_.inside.resize(space_.points.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, marks.size(), kPartsOfTask), [&](const auto& range) {
            look_for_cancel();
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const std::uint64_t edge = marks[i].first;
                const glm::dvec3 along = space_.points[second_of(edge)] - space_.points[first_of(edge)];
                space_.inside[first + i] = body_.inside(space_.points[first + i], glm::normalize(along)) ? 1 : 0;
            }
        });
        std::vector<std::uint32_t> made;
        space_.split(middles, made);
        for (const auto& [edge, middle] : middles) cuts_.forget(edge);
        state_.resize(space_.all.size());
        std::vector<std::uint64_t> edges;
        for (const std::uint32_t i : made) {
            state_[i] = State{};
            each_edge(space_.all[i], [&](std::uint32_t a, std::uint32_t b) {
                if (a >= first || b >= first) edges.push_back(edge_key(a, b));
            });
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        cut_edges(edges);
    }

    void cut_edges(const std::vector<std::uint64_t>& edges)
    {
        std::vector<EdgeCut> found(edges.size());
        std::vector<std::uint8_t> cuts(edges.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), kPartsOfTask), [&](const auto& range) {
            look_for_cancel();
            std::uint64_t lost = 0;
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                cuts[i] = cut_edge(body_, passing_, space_.points, space_.inside, edges[i], found[i], lost) ? 1 : 0;
            lost_ += lost;
        });
        std::vector<EdgeCut> fresh;
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (cuts[i] != 0) fresh.push_back(found[i]);
        cuts_.add(std::move(fresh));
    }

    std::atomic<std::uint64_t> lost_{0};
};

}  // namespace solid
