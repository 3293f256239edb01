#include "render/solid/section/contour.h"

#include "csg/base/cancel.h"
#include "render/solid/mesh/patch.h"
#include "render/solid/section/plane_triangles.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace solid {
namespace {

constexpr double kPassing = 0.02;           // of what is aimed at: so exactly crossings of edges are told
constexpr double kShortest = 0.1;           // of the same: shorter edges are not split
constexpr double kInnerShare = 1e-4;        // of the room in a triangle: corners keep to where they are
constexpr double kCoordinateGrain = 1e-12;  // of the largest coordinate: rounding of coordinates, with room

class Contour {
public:
    Contour(const Body& body, const csg::Aabb& extent, const CuttingPlane& plane, const RefineOptions& options,
            RefineFacts& facts)
        : body_(body), plane_(plane), options_(options), facts_(facts)
    {
        const glm::dvec2 lower = plane.flat(extent.lower), size = plane.flat(extent.upper) - lower;
        step_ = std::max(size.x, size.y) / options.cells;
        finish_.off = kAimedShare * options.tolerance;
        finish_.least = finish_.narrow =
            finish_.off;  // what a smaller triangle holds is no farther off than it is wide
        finish_.inner = kInnerShare;
        const glm::dvec3 far = glm::max(glm::abs(extent.lower), glm::abs(extent.upper));
        finish_.grain = kCoordinateGrain * glm::max(far.x, glm::max(far.y, far.z));
        // No single precision is to come, so crossings may keep to where they are; and corners are told that poke
        // through an edge only just.
        passing_ = finish_;
        passing_.off = passing_.narrow = kPassing * finish_.off;
        passing_.least = kShortest * finish_.off;
        for (int k = 0; k < 2; ++k) {
            squares_[k] = std::max(1, static_cast<int>(std::ceil(size[k] / step_ + 1.2)));
            // Not symmetric about the body: its edges would lie on the lattice.
            origin_[k] = lower[k] - (squares_[k] * step_ - size[k]) * (0.5037 + 0.011 * k);
        }
    }

    std::vector<Loop> run()
    {
        make_lattice();
        find_sides();
        find_lattice_cuts();
        for (facts_.rounds = 0; facts_.rounds < kMostRefinements; ++facts_.rounds) {
            collect_active();
            PlaneTriangles::Shares marks = repeated_cuts();
            if (marks.empty()) {
                find_patches();
                marks = coarse_patches();
            }
            if (marks.empty()) break;
            facts_.late = std::chrono::steady_clock::now() >= options_.deadline;
            facts_.full = space_.all.size() + 4 * marks.size() > options_.most_parts;
            if (facts_.late || facts_.full) break;
            space_.spread(marks);
            refine(marks);
        }
        collect_active();
        find_patches();
        facts_.parts = space_.all.size();
        facts_.lost = lost_;
        return loops();
    }

private:
    std::uint32_t corner(int x, int y) const { return static_cast<std::uint32_t>(y * (squares_[0] + 1) + x); }
    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x <= squares_[0] && y <= squares_[1]; }
    glm::dvec3 place(int x, int y) const { return plane_.point(origin_ + step_ * glm::dvec2(x, y)); }

    void make_lattice()
    {
        for (int y = 0; y <= squares_[1]; ++y)
            for (int x = 0; x <= squares_[0]; ++x) space_.points.push_back(place(x, y));
        space_.inside.resize(space_.points.size());
        for (int y = 0; y < squares_[1]; ++y)
            for (int x = 0; x < squares_[0]; ++x) {
                space_.all.push_back({corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)});
                space_.all.push_back({corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)});
            }
    }

    /// Sides of the corners, by lines upward. Those at the rim are outside.
    void find_sides()
    {
        tbb::parallel_for(1, squares_[0], [&](int x) {
            look_for_cancel();
            std::vector<Chord> chords;
            body_.chords(place(x, 0), plane_.direction({0, 1}), -csg::kInfinity, csg::kInfinity, chords);
            for (const Chord& chord : chords) {
                const int first = std::max(1, static_cast<int>(std::ceil(chord.in.t / step_)));
                for (int y = first; y < squares_[1] && y * step_ < chord.out.t; ++y) space_.inside[corner(x, y)] = 1;
            }
        });
    }

    /// Cuts of the lattice's edges, whole lines at a time.
    void find_lattice_cuts()
    {
        constexpr std::array<std::array<int, 2>, 3> kDirections{{{1, 0}, {0, 1}, {1, 1}}};
        std::vector<EdgeCut> cuts;
        for (const auto& d : kDirections) {
            tbb::enumerable_thread_specific<std::vector<EdgeCut>> found;
            tbb::parallel_for(0, squares_[1] + 1, [&](int y) {
                look_for_cancel();
                for (int x = 0; x <= squares_[0]; ++x)
                    if (!holds(x - d[0], y - d[1])) follow(x, y, d, found.local());  // a line begins here
            });
            for (const auto& part : found) cuts.insert(cuts.end(), part.begin(), part.end());
        }
        cuts_.add(std::move(cuts));
    }

    void follow(int x, int y, const std::array<int, 2>& d, std::vector<EdgeCut>& found)
    {
        thread_local std::vector<Chord> chords;
        const glm::dvec3 from = place(x, y), step = plane_.direction(step_ * glm::dvec2(d[0], d[1]));
        const double length = glm::length(step);
        body_.chords(from, step / length, -csg::kInfinity, csg::kInfinity, chords);
        std::uint64_t lost = 0;
        for (int k = 0; holds(x + (k + 1) * d[0], y + (k + 1) * d[1]); ++k) {
            const std::uint32_t a = corner(x + k * d[0], y + k * d[1]),
                                b = corner(x + (k + 1) * d[0], y + (k + 1) * d[1]);
            EdgeCut cut;
            cut.edge = edge_key(a, b);  // a < b: the directions lead upward
            if (cut_edge(body_, passing_, from, step / length, k * length, length, space_.inside[a] != 0,
                         space_.inside[b] != 0, chords, cut, lost))
                found.push_back(cut);
        }
        lost_ += lost;
    }

    /// Triangles with corners on both sides.
    void collect_active()
    {
        look_for_cancel();
        active_.clear();
        for (std::size_t i = 0; i < space_.all.size(); ++i) {
            const PlaneTriangles::Triangle& t = space_.all[i];
            const int sum = space_.inside[t[0]] + space_.inside[t[1]] + space_.inside[t[2]];
            if (sum != 0 && sum != 3) active_.push_back(static_cast<std::uint32_t>(i));
        }
        state_.resize(space_.all.size());
    }

    /// Edges that the boundary passes again are split where it does.
    PlaneTriangles::Shares repeated_cuts()
    {
        const CutTable::Shares wanted = cuts_.repeated();
        CutTable::Shares chosen;
        if (wanted.empty()) return chosen;
        for (const PlaneTriangles::Triangle& t : space_.all)
            for (std::size_t k = 0; k < 3; ++k)
                if (const auto found = wanted.find(edge_key(t[k], t[(k + 1) % 3])); found != wanted.end())
                    choose_split(space_, found->first, found->second, space_.longest_edge(t), chosen);
        return chosen;
    }

    /// The corner that is alone on its side, and the cuts towards the two that follow it.
    struct Ways {
        std::size_t lone = 0;
        std::uint32_t to_next = 0, to_last = 0;  // indices of cuts
    };
    Ways ways_of(const PlaneTriangles::Triangle& t) const
    {
        const std::uint8_t alone = space_.inside[t[0]] + space_.inside[t[1]] + space_.inside[t[2]] == 1 ? 1 : 0;
        Ways out;
        while (space_.inside[t[out.lone]] != alone) ++out.lone;
        const std::uint32_t l = t[out.lone];
        out.to_next = cuts_.index(edge_key(l, t[(out.lone + 1) % 3]));
        out.to_last = cuts_.index(edge_key(l, t[(out.lone + 2) % 3]));
        return out;
    }

    void find_patches()
    {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, active_.size(), kPartsOfTask), [&](const auto& range) {
            look_for_cancel();
            for (std::size_t k = range.begin(); k < range.end(); ++k) {
                State& state = state_[active_[k]];
                if (state.known) continue;
                state.known = true;
                const PlaneTriangles::Triangle& t = space_.all[active_[k]];
                const Ways ways = ways_of(t);
                const glm::dvec3 &l = space_.points[t[ways.lone]], &m = space_.points[t[(ways.lone + 1) % 3]],
                                 &n = space_.points[t[(ways.lone + 2) % 3]];
                state.cut = cut_face(body_, finish_, l, m, n, space_.inside[t[ways.lone]] != 0,
                                     cuts_[ways.to_next].place, cuts_[ways.to_last].place);
            }
        });
    }

    PlaneTriangles::Shares coarse_patches()
    {
        PlaneTriangles::Shares out;
        facts_.unresolved = 0;
        for (const std::uint32_t i : active_) {
            if (!state_[i].cut.coarse) continue;
            const std::uint64_t edge = space_.longest_edge(space_.all[i]);
            if (space_.length2(edge) < finish_.least * finish_.least) ++facts_.unresolved;
            else out[edge] = 0.5;
        }
        return out;
    }

    void refine(const PlaneTriangles::Shares& marked)
    {
        const std::vector<std::pair<std::uint64_t, double>> marks = in_order(marked);
        const auto first = static_cast<std::uint32_t>(space_.points.size());
        PlaneTriangles::Middles middles;
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
            const PlaneTriangles::Triangle& t = space_.all[i];
            for (std::size_t k = 0; k < 3; ++k)
                if (const std::uint32_t a = t[k], b = t[(k + 1) % 3]; a >= first || b >= first)
                    edges.push_back(edge_key(a, b));
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
            std::vector<Chord> chords;
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const std::uint32_t a = first_of(edges[i]), b = second_of(edges[i]);
                const double length = glm::length(space_.points[b] - space_.points[a]);
                const glm::dvec3 along = (space_.points[b] - space_.points[a]) / length;
                body_.chords(space_.points[a], along, -1e-6 * length, (1.0 + 1e-6) * length, chords);
                found[i].edge = edges[i];
                cuts[i] = cut_edge(body_, passing_, space_.points[a], along, 0.0, length, space_.inside[a] != 0,
                                   space_.inside[b] != 0, chords, found[i], lost)
                              ? 1
                              : 0;
            }
            lost_ += lost;
        });
        std::vector<EdgeCut> fresh;
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (cuts[i] != 0) fresh.push_back(found[i]);
        cuts_.add(std::move(fresh));
    }

    /// An edge that the boundary passes belongs to two triangles, one of which it leaves and one that it enters there.
    std::vector<Loop> loops() const
    {
        constexpr std::uint32_t kNoCut = 0xffffffffu;
        std::vector<std::uint32_t> next(cuts_.size(), kNoCut), within(cuts_.size(), kNoCut);
        for (const std::uint32_t i : active_) {
            const Ways ways = ways_of(space_.all[i]);
            const bool lone_inside = space_.inside[space_.all[i][ways.lone]] != 0;
            const std::uint32_t from = lone_inside ? ways.to_next : ways.to_last;
            next[from] = lone_inside ? ways.to_last : ways.to_next;
            within[from] = i;
        }
        std::vector<Loop> out;
        for (std::uint32_t start = 0; start < next.size(); ++start) {
            if (next[start] == kNoCut) continue;
            Loop loop;
            for (std::uint32_t at = start; next[at] != kNoCut;) {
                loop.push_back(plane_.flat(cuts_[at].place.point));
                const FaceCut& bend = state_[within[at]].cut;
                if (bend.bent) loop.push_back(plane_.flat(bend.place.point));
                const std::uint32_t following = next[at];
                next[at] = kNoCut;
                at = following;
            }
            out.push_back(std::move(loop));
        }
        return out;
    }

    void look_for_cancel() const
    {
        if (options_.cancel != nullptr && *options_.cancel) throw csg::Cancelled();
    }

    struct State {
        FaceCut cut;
        bool known = false;
    };

    const Body& body_;
    const CuttingPlane plane_;
    const RefineOptions& options_;
    RefineFacts& facts_;
    Finish finish_, passing_;  ///< of lines within triangles; of crossings of their edges
    double step_ = 1.0;
    glm::dvec2 origin_{0.0};
    int squares_[2] = {1, 1};
    PlaneTriangles space_;
    CutTable cuts_;
    std::vector<std::uint32_t> active_;
    std::vector<State> state_;  ///< by triangle
    std::atomic<std::uint64_t> lost_{0};
};

}  // namespace

std::vector<Loop> contour_of(const Body& body, const csg::Aabb& extent, const CuttingPlane& plane,
                             const RefineOptions& options, RefineFacts& facts)
{
    return Contour(body, extent, plane, options, facts).run();
}

}  // namespace solid
