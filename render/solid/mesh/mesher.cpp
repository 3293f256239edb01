#include "render/solid/mesh/mesher.h"

#include "csg/base/cancel.h"
#include "render/solid/mesh/patch.h"
#include "render/solid/mesh/sides.h"
#include "render/solid/mesh/weld.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace solid {
namespace {

constexpr double kLeastEdge = 3e-4;  // of the body's size: single precision tells no smaller triangles apart
constexpr double kGrains = 1e-6;     // of the largest coordinate: some units in the last place of single precision

using Clock = std::chrono::steady_clock;

class Mesher {
public:
    Mesher(const Body& body, const csg::Aabb& extent, const RefineOptions& options, MeshFacts& facts)
        : body_(body), options_(options), facts_(facts)
    {
        const glm::dvec3 size = extent.upper - extent.lower;
        const double longest = glm::max(size.x, glm::max(size.y, size.z));
        finish_.off = kAimedShare * options.tolerance;
        // What a smaller tetrahedron holds is no farther off than it is wide.
        finish_.least = std::max(kLeastEdge * longest, 2.0 * finish_.off);
        const glm::dvec3 far = glm::max(glm::abs(extent.lower), glm::abs(extent.upper));
        finish_.grain = kGrains * glm::max(far.x, glm::max(far.y, far.z));
        finish_.narrow = finish_.off;
        lattice_.step = longest / options.cells;
        for (int k = 0; k < 3; ++k) {
            const auto at = static_cast<std::size_t>(k);
            lattice_.cubes[at] = std::max(1, static_cast<int>(std::ceil(size[k] / lattice_.step + 1.2)));
            // Not symmetric about the body: its faces and seams would lie on the lattice.
            const double spare = lattice_.cubes[at] * lattice_.step - size[k];
            lattice_.origin[k] = extent.lower[k] - spare * (0.5037 + 0.011 * k);
        }
    }

    TriangleMesh run()
    {
        space_ = lattice_.tetrahedra();
        find_sides();
        find_lattice_cuts();
        for (facts_.rounds = 0; facts_.rounds < kMostRefinements; ++facts_.rounds) {
            if (options_.cancel != nullptr && *options_.cancel) throw csg::Cancelled();
            collect_active();
            std::vector<std::pair<std::uint64_t, double>> marks = repeated_cuts();
            if (marks.empty()) {
                find_patches();
                marks = coarse_patches();
            }
            if (marks.empty()) break;
            facts_.late = Clock::now() >= options_.deadline;
            facts_.full = space_.all.size() + 8 * marks.size() > options_.most_parts;
            if (facts_.late || facts_.full) break;
            refine(marks);
        }
        collect_active();
        find_patches();
        facts_.parts = space_.all.size();
        return triangles();
    }

private:
    /// Sides of the corners: by lines along z.
    void find_sides()
    {
        const int nx = lattice_.cubes[0], ny = lattice_.cubes[1], nz = lattice_.cubes[2];
        tbb::parallel_for(0, ny + 1, [&](int y) {
            std::vector<Chord> chords;
            for (int x = 0; x <= nx; ++x) {
                const glm::dvec3 from = lattice_.place(x, y, 0);
                body_.chords(from, {0, 0, 1}, -csg::kInfinity, csg::kInfinity, chords);
                for (const Chord& chord : chords) {
                    const int first = std::max(0, static_cast<int>(std::ceil(chord.in.t / lattice_.step)));
                    for (int z = first; z < nz && z * lattice_.step < chord.out.t; ++z)
                        if (x > 0 && y > 0 && z > 0 && x < nx && y < ny) space_.inside[lattice_.corner(x, y, z)] = 1;
                }
            }
        });
    }

    /// Cuts of the lattice's edges, whole lines at a time.
    void find_lattice_cuts()
    {
        constexpr std::array<std::array<int, 3>, 7> kDirections{
            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
        std::vector<EdgeCut> cuts;
        const int nx = lattice_.cubes[0], ny = lattice_.cubes[1], nz = lattice_.cubes[2];
        for (const auto& d : kDirections) {
            tbb::enumerable_thread_specific<std::vector<EdgeCut>> found;
            tbb::parallel_for(0, nz + 1, [&](int z) {
                for (int y = 0; y <= ny; ++y)
                    for (int x = 0; x <= nx; ++x) {
                        if (lattice_.holds(x - d[0], y - d[1], z - d[2])) continue;  // not where a line begins
                        follow(x, y, z, d, found.local());
                    }
            });
            for (const auto& part : found) cuts.insert(cuts.end(), part.begin(), part.end());
        }
        cuts_.add(std::move(cuts));
    }

    void follow(int x, int y, int z, const std::array<int, 3>& d, std::vector<EdgeCut>& found)
    {
        thread_local std::vector<Chord> chords;
        const glm::dvec3 from = lattice_.place(x, y, z), step = lattice_.step * glm::dvec3(d[0], d[1], d[2]);
        const double length = glm::length(step);
        body_.chords(from, step / length, -csg::kInfinity, csg::kInfinity, chords);
        std::uint64_t lost = 0;
        for (int k = 0;; ++k) {
            const int px = x + k * d[0], py = y + k * d[1], pz = z + k * d[2];
            if (!lattice_.holds(px + d[0], py + d[1], pz + d[2])) break;
            const std::uint32_t a = lattice_.corner(px, py, pz), b = lattice_.corner(px + d[0], py + d[1], pz + d[2]);
            EdgeCut cut;
            cut.edge = edge_key(a, b);  // a < b: the directions lead upward
            if (cut_edge(body_, finish_, from, step / length, k * length, length, space_.inside[a] != 0,
                         space_.inside[b] != 0, chords, cut, lost))
                found.push_back(cut);
        }
        lost_ += lost;
    }

    /// Tetrahedra with corners on both sides.
    void collect_active()
    {
        active_.clear();
        for (std::size_t i = 0; i < space_.all.size(); ++i) {
            const Tetrahedron& t = space_.all[i];
            const int sum = space_.inside[t[0]] + space_.inside[t[1]] + space_.inside[t[2]] + space_.inside[t[3]];
            if (sum != 0 && sum != 4) active_.push_back(static_cast<std::uint32_t>(i));
        }
        state_.resize(space_.all.size());
    }

    /// Edges that the boundary passes again are split where it does.
    std::vector<std::pair<std::uint64_t, double>> repeated_cuts()
    {
        const CutTable::Shares wanted = cuts_.repeated();
        if (wanted.empty()) return {};
        CutTable::Shares chosen;
        std::vector<std::uint8_t> touched(space_.points.size());
        for (const auto& [edge, share] : wanted) touched[first_of(edge)] = touched[second_of(edge)] = 1;
        for (const Tetrahedron& t : space_.all) {
            if (touched[t[0]] + touched[t[1]] + touched[t[2]] + touched[t[3]] < 2) continue;
            for (const auto& [i, j] : kEdges) {
                const std::uint32_t a = t[static_cast<std::size_t>(i)], b = t[static_cast<std::size_t>(j)];
                if (touched[a] == 0 || touched[b] == 0) continue;
                if (const auto found = wanted.find(edge_key(a, b)); found != wanted.end())
                    choose_split(space_, found->first, found->second, space_.longest_edge(t), chosen);
            }
        }
        return in_order(chosen);
    }

    const EdgeCut& cut(std::uint32_t a, std::uint32_t b) const { return cuts_[cuts_.index(edge_key(a, b))]; }

    FaceCut cut_of_face(const FaceKey& key) const
    {
        const int ins = space_.inside[key[0]] + space_.inside[key[1]] + space_.inside[key[2]];
        const std::uint8_t alone = ins == 1 ? 1 : 0;
        std::size_t lone = 0;
        while (space_.inside[key[lone]] != alone) ++lone;
        const std::uint32_t l = key[lone], m = key[(lone + 1) % 3], n = key[(lone + 2) % 3];
        return cut_face(body_, finish_, space_.points[l], space_.points[m], space_.points[n], alone != 0,
                        cut(l, m).place, cut(l, n).place);
    }

    /// Faces first, as two tetrahedra share one, then what is between them.
    void find_patches()
    {
        std::vector<FaceKey> fresh;
        for (const std::uint32_t i : active_) {
            if (state_[i].known) continue;
            std::array<FaceKey, 4> keys;
            const std::size_t count = faces_of(sides_of(space_.all[i], space_.inside), keys);
            for (std::size_t k = 0; k < count; ++k)
                if (face_of_.try_emplace(keys[k], static_cast<std::uint32_t>(faces_.size() + fresh.size())).second)
                    fresh.push_back(keys[k]);
        }
        const std::size_t first = faces_.size();
        faces_.resize(first + fresh.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, fresh.size(), kPartsOfTask), [&](const auto& range) {
            look_for_cancel();
            for (std::size_t i = range.begin(); i < range.end(); ++i) faces_[first + i] = cut_of_face(fresh[i]);
        });
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, active_.size(), kPartsOfTask), [&](const auto& range) {
            look_for_cancel();
            for (std::size_t k = range.begin(); k < range.end(); ++k) {
                State& state = state_[active_[k]];
                if (state.known) continue;
                state.known = true;
                const Tetrahedron& t = space_.all[active_[k]];
                bool coarse = false;
                const Polygon polygon = polygon_of(t, &coarse);
                state.centre = cut_centre(
                    body_, finish_,
                    {space_.points[t[0]], space_.points[t[1]], space_.points[t[2]], space_.points[t[3]]}, polygon);
                state.coarse = coarse || state.centre.coarse;
            }
        });
    }

    void look_for_cancel() const
    {
        if (options_.cancel != nullptr && *options_.cancel) throw csg::Cancelled();
    }

    Polygon polygon_of(const Tetrahedron& t, bool* coarse = nullptr) const
    {
        const Sides s = sides_of(t, space_.inside);
        std::array<FaceKey, 4> faces;
        const std::size_t count = faces_of(s, faces);
        const std::array<std::uint64_t, 4> edges = edges_of(s);
        const bool turned = is_turned(s, t, space_.inside);
        Polygon out;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t k = turned ? count - 1 - i : i;
            const std::uint32_t edge = cuts_.index(edges[k]);
            out.corners[out.count++] = {cuts_[edge].place, false, false, edge};
            const std::size_t f = turned ? (k + count - 1) % count : k;
            const std::uint32_t face = face_of_.at(faces[f]);
            if (coarse != nullptr) *coarse = *coarse || faces_[face].coarse;
            if (!faces_[face].bent) continue;
            out.corners[out.count++] = {faces_[face].place, true, faces_[face].sharp, face};
            out.any_on_face = true;
        }
        return out;
    }

    std::vector<std::pair<std::uint64_t, double>> coarse_patches()
    {
        CutTable::Shares marked;
        facts_.unresolved = 0;
        for (const std::uint32_t i : active_) {
            if (!state_[i].coarse) continue;
            const std::uint64_t edge = space_.longest_edge(space_.all[i]);
            if (space_.length2(edge) < finish_.least * finish_.least) ++facts_.unresolved;
            else marked[edge] = 0.5;
        }
        return in_order(marked);
    }

    void refine(const std::vector<std::pair<std::uint64_t, double>>& marks)
    {
        const std::uint32_t first = static_cast<std::uint32_t>(space_.points.size());
        CutTable::Index middles;
        for (const auto& [edge, share] : marks) {
            middles[edge] = static_cast<std::uint32_t>(space_.points.size());
            const glm::dvec3 a = space_.points[first_of(edge)], b = space_.points[second_of(edge)];
            space_.points.push_back(a + share * (b - a));
        }
        space_.inside.resize(space_.points.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, marks.size(), kPartsOfTask), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const std::uint64_t edge = marks[i].first;
                const glm::dvec3 a = space_.points[first_of(edge)], b = space_.points[second_of(edge)];
                space_.inside[first + i] = body_.inside(space_.points[first + i], glm::normalize(b - a)) ? 1 : 0;
            }
        });
        std::vector<std::uint32_t> made;
        space_.split(middles, made);
        for (const auto& [edge, middle] : middles) cuts_.forget(edge);
        state_.resize(space_.all.size());
        std::vector<std::uint64_t> edges;
        for (const std::uint32_t i : made) {
            state_[i] = State{};
            const Tetrahedron& t = space_.all[i];
            for (const auto& [k, l] : kEdges) {
                const std::uint32_t a = t[static_cast<std::size_t>(k)], b = t[static_cast<std::size_t>(l)];
                if (a >= first || b >= first) edges.push_back(edge_key(a, b));
            }
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        std::vector<EdgeCut> found(edges.size());
        std::vector<std::uint8_t> cuts(edges.size());
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, edges.size(), kPartsOfTask), [&](const auto& range) {
            look_for_cancel();
            std::uint64_t lost = 0;
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                cuts[i] = cut_edge(body_, finish_, space_, edges[i], found[i], lost) ? 1 : 0;
            lost_ += lost;
        });
        std::vector<EdgeCut> fresh;
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (cuts[i] != 0) fresh.push_back(found[i]);
        cuts_.add(std::move(fresh));
    }

    TriangleMesh triangles()
    {
        TriangleMesh out;
        constexpr std::uint32_t kNone = 0xffffffffu;
        std::vector<std::uint32_t> of_edge(cuts_.size(), kNone), of_face(faces_.size(), kNone);
        const auto vertex = [&](std::vector<std::uint32_t>& known, std::uint32_t id, const glm::dvec3& p) {
            if (known[id] == kNone) {
                known[id] = static_cast<std::uint32_t>(out.vertices.size());
                out.vertices.push_back(glm::vec3(p));
            }
            return known[id];
        };
        for (const std::uint32_t i : active_) {
            const Polygon polygon = polygon_of(space_.all[i]);
            std::array<std::uint32_t, 8> v{};
            for (std::size_t k = 0; k < polygon.count; ++k) {
                const Polygon::Corner& c = polygon.corners[k];
                v[k] = vertex(c.on_face ? of_face : of_edge, c.id, c.place.point);
            }
            const CentreCut& centre = state_[i].centre;
            if (centre.needed) {
                const auto middle = static_cast<std::uint32_t>(out.vertices.size());
                out.vertices.push_back(glm::vec3(centre.place));
                for (std::size_t k = 0; k < polygon.count; ++k)
                    out.triangles.push_back({v[k], v[(k + 1) % polygon.count], middle});
            } else {
                const auto d = static_cast<std::size_t>(centre.diagonal);
                out.triangles.push_back({v[d], v[d + 1], v[d + 2]});
                if (polygon.count == 4) out.triangles.push_back({v[d], v[d + 2], v[(d + 3) % 4]});
            }
        }
        facts_.lost = lost_;
        facts_.joined = weld(out);
        facts_.specks = drop_specks(out, options_.tolerance);
        return out;
    }

    struct State {
        CentreCut centre;
        bool known = false, coarse = false;
    };

    const Body& body_;
    const RefineOptions& options_;
    MeshFacts& facts_;
    Finish finish_;
    Lattice lattice_;
    Tetrahedra space_;
    CutTable cuts_;
    std::vector<FaceCut> faces_;
    std::unordered_map<FaceKey, std::uint32_t, FaceHash> face_of_;
    std::vector<std::uint32_t> active_;
    std::vector<State> state_;  ///< by tetrahedron
    std::atomic<std::uint64_t> lost_{0};
};

}  // namespace

TriangleMesh mesh_of(const Body& body, const csg::Aabb& extent, const RefineOptions& options, MeshFacts& facts)
{
    return Mesher(body, extent, options, facts).run();
}

}  // namespace solid
