#include "render/solid/mesh/mesher.h"

#include "render/solid/mesh/patch.h"
#include "render/solid/mesh/refiner.h"
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

struct TetrahedronState {
    CentreCut centre;
    bool known = false, coarse = false;
};

class Mesher : Refiner<Tetrahedra, TetrahedronState> {
public:
    Mesher(const Body& body, const csg::Aabb& extent, const RefineOptions& options, MeshFacts& facts)
        : Refiner(body, options, facts), mesh_facts_(facts)
    {
        const glm::dvec3 size = extent.upper - extent.lower;
        const double longest = glm::max(size.x, glm::max(size.y, size.z));
        finish_.off = kAimedShare * options.tolerance;
        // What a smaller tetrahedron holds is no farther off than it is wide.
        finish_.least = std::max(kLeastEdge * longest, 2.0 * finish_.off);
        const glm::dvec3 far = glm::max(glm::abs(extent.lower), glm::abs(extent.upper));
        finish_.grain = kGrains * glm::max(far.x, glm::max(far.y, far.z));
        finish_.narrow = finish_.off;
        passing_ = finish_;
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
        refine_all();
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
                body_.chords(from, {0, 0, 1}, -numbers::kInfinity, numbers::kInfinity, chords);
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
                        follow_from(x, y, z, d, found.local());
                    }
            });
            for (const auto& part : found) cuts.insert(cuts.end(), part.begin(), part.end());
        }
        cuts_.add(std::move(cuts));
    }

    void follow_from(int x, int y, int z, const std::array<int, 3>& d, std::vector<EdgeCut>& found)
    {
        follow(
            lattice_.place(x, y, z), lattice_.step * glm::dvec3(d[0], d[1], d[2]),
            [&](int k) {
                const int px = x + k * d[0], py = y + k * d[1], pz = z + k * d[2];
                return lattice_.holds(px, py, pz) ? lattice_.corner(px, py, pz) : kNoCorner;
            },
            found);
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
    void find_patches() override
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
        each_unknown([&](TetrahedronState& state, const Tetrahedron& t) {
            bool coarse = false;
            const Polygon polygon = polygon_of(t, &coarse);
            state.centre = cut_centre(
                body_, finish_, {space_.points[t[0]], space_.points[t[1]], space_.points[t[2]], space_.points[t[3]]},
                polygon);
            state.coarse = coarse || state.centre.coarse;
        });
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
        mesh_facts_.joined = weld(out);
        mesh_facts_.specks = drop_specks(out, options_.tolerance);
        return out;
    }

    MeshFacts& mesh_facts_;
    Lattice lattice_;
    std::vector<FaceCut> faces_;
    std::unordered_map<FaceKey, std::uint32_t, FaceHash> face_of_;
};

}  // namespace

TriangleMesh mesh_of(const Body& body, const csg::Aabb& extent, const RefineOptions& options, MeshFacts& facts)
{
    return Mesher(body, extent, options, facts).run();
}

}  // namespace solid
