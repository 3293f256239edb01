#include "render/solid/section/contour.h"

#include "render/solid/mesh/patch.h"
#include "render/solid/mesh/refiner.h"
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

struct TriangleState {
    FaceCut cut;
    bool known = false, coarse = false;
};

class Contour : Refiner<PlaneTriangles, TriangleState> {
public:
    Contour(const Body& body, const csg::Aabb& extent, const CuttingPlane& plane, const RefineOptions& options,
            RefineFacts& facts)
        : Refiner(body, options, facts), plane_(plane)
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
        refine_all();
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
            body_.chords(place(x, 0), plane_.direction({0, 1}), -numbers::kInfinity, numbers::kInfinity, chords);
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
                    if (!holds(x - d[0], y - d[1])) follow_from(x, y, d, found.local());  // a line begins here
            });
            for (const auto& part : found) cuts.insert(cuts.end(), part.begin(), part.end());
        }
        cuts_.add(std::move(cuts));
    }

    void follow_from(int x, int y, const std::array<int, 2>& d, std::vector<EdgeCut>& found)
    {
        follow(
            place(x, y), plane_.direction(step_ * glm::dvec2(d[0], d[1])),
            [&](int k) {
                const int px = x + k * d[0], py = y + k * d[1];
                return holds(px, py) ? corner(px, py) : kNoCorner;
            },
            found);
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

    void find_patches() override
    {
        each_unknown([&](TriangleState& state, const PlaneTriangles::Triangle& t) {
            const Ways ways = ways_of(t);
            const glm::dvec3 &l = space_.points[t[ways.lone]], &m = space_.points[t[(ways.lone + 1) % 3]],
                             &n = space_.points[t[(ways.lone + 2) % 3]];
            state.cut = cut_face(body_, finish_, l, m, n, space_.inside[t[ways.lone]] != 0, cuts_[ways.to_next].place,
                                 cuts_[ways.to_last].place);
            state.coarse = state.cut.coarse;
        });
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

    const CuttingPlane plane_;
    double step_ = 1.0;
    glm::dvec2 origin_{0.0};
    int squares_[2] = {1, 1};
};

}  // namespace

std::vector<Loop> contour_of(const Body& body, const csg::Aabb& extent, const CuttingPlane& plane,
                             const RefineOptions& options, RefineFacts& facts)
{
    return Contour(body, extent, plane, options, facts).run();
}

}  // namespace solid
