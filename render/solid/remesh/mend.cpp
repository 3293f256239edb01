#include "render/solid/remesh/remesher.h"

#include <algorithm>
#include <cmath>

namespace solid {
namespace {

using Index = HalfEdges::Index;

constexpr int kMostRings = 5;            // of triangles about a fold that are cut out
constexpr std::size_t kMostCut = 600;    // triangles
constexpr std::size_t kMostIsland = 40;  // triangles
constexpr double kLeastEar = 1e-3;       // twice its area, of the square of its longest side

/// The triangles about a fold, and the loop of half-edges within them that runs about them.
struct Hole {
    std::vector<Index> triangles, rim;
};

/// What the hole has nearly closed about belongs to it: small islands, and the triangles of vertices where it touches
/// itself.
void close(const HalfEdges& mesh, std::vector<std::uint32_t>& cut, std::uint32_t own, Hole& hole)
{
    const auto add = [&](Index f) {
        cut[f] = own;
        hole.triangles.push_back(f);
    };
    for (bool changed = true; changed && hole.triangles.size() < kMostCut;) {
        changed = false;
        for (std::size_t i = 0; i < hole.triangles.size() && hole.triangles.size() < kMostCut; ++i)
            for (Index h = 3 * hole.triangles[i]; h < 3 * hole.triangles[i] + 3; ++h) {
                if (cut[mesh.twin(h) / 3] == own) continue;
                std::vector<Index> island{mesh.twin(h) / 3};
                for (std::size_t k = 0; k < island.size() && island.size() <= kMostIsland; ++k)
                    for (Index o = 3 * island[k]; o < 3 * island[k] + 3; ++o)
                        if (const Index f = mesh.twin(o) / 3;
                            cut[f] != own && std::find(island.begin(), island.end(), f) == island.end())
                            island.push_back(f);
                int times = 0;  // that the rim passes this vertex
                mesh.each_out(mesh.tail(h),
                              [&](Index o) { times += cut[o / 3] == own && cut[mesh.twin(o) / 3] != own; });
                if (island.size() <= kMostIsland) {
                    for (const Index f : island) add(f);
                    changed = true;
                } else if (times > 1) {
                    mesh.each_out(mesh.tail(h), [&](Index o) {
                        if (cut[o / 3] != own) add(o / 3);
                    });
                    changed = true;
                }
            }
    }
}

/// One loop that passes no vertex twice. What fills it is a disc; what was there need not be one: most folds that
/// nothing unfolds are handles a few edges wide, which tetrahedra made where they told a sharp edge badly.
bool find_rim(const HalfEdges& mesh, const std::vector<std::uint32_t>& cut, std::uint32_t own, Hole& hole)
{
    hole.rim.clear();
    std::size_t sides = 0;
    Index start = HalfEdges::kNone;
    for (const Index f : hole.triangles)
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
            if (cut[mesh.twin(h) / 3] != own) {
                start = h;
                ++sides;
            }
    if (sides < 3) return false;
    Index h = start;
    do {
        hole.rim.push_back(h);
        h = HalfEdges::next(h);
        while (cut[mesh.twin(h) / 3] == own) h = HalfEdges::next(mesh.twin(h));
    } while (h != start && hole.rim.size() <= sides);
    if (hole.rim.size() != sides) return false;
    std::vector<Index> on_rim;
    for (const Index r : hole.rim) on_rim.push_back(mesh.tail(r));
    std::sort(on_rim.begin(), on_rim.end());
    return std::adjacent_find(on_rim.begin(), on_rim.end()) == on_rim.end();
}

/// Fills a polygon that is nearly flat with triangles, the best shaped first. False: it overlaps itself, or an edge of
/// a triangle is there already.
template <class At, class Joined>
bool fill(At&& at, std::vector<Index> polygon, const glm::dvec3& normal, Joined&& joined,
          std::vector<std::array<Index, 3>>& out)
{
    const auto turn = [&](Index a, Index b, Index c) { return glm::dot(cross_of(at(a), at(b), at(c)), normal); };
    while (polygon.size() > 3) {
        const std::size_t n = polygon.size();
        std::size_t best = n;
        double least = 2.0;
        for (std::size_t i = 0; i < n; ++i) {
            const Index a = polygon[(i + n - 1) % n], b = polygon[i], c = polygon[(i + 1) % n];
            const double shape = sharpest_cosine(at(a), at(b), at(c)), wide = glm::length(at(c) - at(a));
            if (shape >= least || !(turn(a, b, c) > kLeastEar * wide * wide) || joined(a, c)) continue;
            bool free = true;
            for (std::size_t k = 0; k < n && free; ++k) {
                const Index x = polygon[k];
                if (x == a || x == b || x == c) continue;
                free = !(turn(a, b, x) >= 0.0 && turn(b, c, x) >= 0.0 && turn(c, a, x) >= 0.0);
            }
            if (!free) continue;
            least = shape;
            best = i;
        }
        if (best == n) return false;
        out.push_back({polygon[(best + n - 1) % n], polygon[best], polygon[(best + 1) % n]});
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(best));
    }
    if (!(turn(polygon[0], polygon[1], polygon[2]) > 0.0)) return false;
    out.push_back({polygon[0], polygon[1], polygon[2]});
    return true;
}

}  // namespace

/// Fills a hole by flat pieces: one, or where sharp edges lead into it one for each side about the place where they
/// meet.
bool Remesher::fill_hole(const std::vector<Index>& triangles, const std::vector<Index>& rim,
                         const std::vector<std::uint32_t>& cut)
{
    const std::uint32_t own = cut[triangles.front()];
    const std::size_t n = rim.size();
    std::vector<glm::dvec3> looks(n);
    for (std::size_t i = 0; i < n; ++i)
        looks[i] = mesh_.facing[(mesh_.is_sharp(rim[i]) ? rim[i] : mesh_.twin(rim[i])) / 3];
    std::vector<std::size_t> edges;  // places of the rim where the side changes
    for (std::size_t i = 0; i < n; ++i)
        if (glm::dot(looks[(i + n - 1) % n], looks[i]) < kSharpTurn) edges.push_back(i);
    if (edges.size() == 1) return false;
    const auto hub = static_cast<Index>(mesh_.vertices());
    glm::dvec3 middle(0.0);
    for (const std::size_t i : edges) middle += mesh_.places[mesh_.tail(rim[i])] / static_cast<double>(edges.size());
    if (edges.size() > 2)
        for (const Index f : triangles)
            for (Index k = 0; k < 3; ++k)
                if (const Index v = mesh_.tail(3 * f + k); kinds_[v] == Kind::Corner) middle = mesh_.places[v];
    const auto at = [&](Index v) { return v == hub ? middle : mesh_.places[v]; };
    std::vector<std::array<Index, 3>> made;
    std::size_t finished = 0;
    // Two vertices of the rim may be joined outside already, or by another piece.
    const auto joined = [&](Index a, Index b) {
        bool found = false;
        for (std::size_t i = 0; i < finished && !found; ++i)
            found = std::count(made[i].begin(), made[i].end(), a) + std::count(made[i].begin(), made[i].end(), b) == 2;
        if (a == hub || b == hub) return found;
        mesh_.each_out(a, [&](Index h) {
            const bool goes = cut[h / 3] == own && cut[mesh_.twin(h) / 3] == own;
            found = found || (!goes && mesh_.head(h) == b);
        });
        return found;
    };
    std::vector<glm::dvec3> facing;
    const std::size_t sides = std::max<std::size_t>(1, edges.size());
    for (std::size_t s = 0; s < sides; ++s) {
        const std::size_t first = edges.empty() ? 0 : edges[s];
        const std::size_t count = edges.empty() ? n : (edges[(s + 1) % sides] + n - first - 1) % n + 1;
        std::vector<Index> polygon;
        glm::dvec3 sum(0.0);
        for (std::size_t k = 0; k < count; ++k) {
            polygon.push_back(mesh_.tail(rim[(first + k) % n]));
            sum += looks[(first + k) % n] * length(rim[(first + k) % n]);
        }
        if (!edges.empty()) {
            polygon.push_back(mesh_.head(rim[(first + count - 1) % n]));
            polygon.push_back(hub);
        }
        if (!(glm::length(sum) > 0.0)) return false;
        const glm::dvec3 normal = glm::normalize(sum);
        if (!fill(at, polygon, normal, joined, made)) return false;
        facing.resize(made.size(), normal);
        finished = made.size();
    }
    if (!edges.empty()) {
        mesh_.add_vertex(middle);
        kinds_.push_back(edges.size() == 2 ? Kind::Crease : Kind::Corner);
        double shortest = numbers::kInfinity;
        for (const std::size_t i : edges) shortest = std::min(shortest, lengths_[mesh_.tail(rim[i])]);
        lengths_.push_back(shortest);
        normals_.emplace_back(0.0);
        on_edge_.push_back(0);
    }
    const Index fresh = mesh_.replace(triangles, made, facing);
    fresh_.resize(mesh_.triangles());
    for (Index h = 3 * fresh; h < 3 * mesh_.triangles(); ++h) touch_about(mesh_.tail(h));
    for (Index f = fresh; f < mesh_.triangles(); ++f)
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
            if (mesh_.head(h) == hub || mesh_.tail(h) == hub) {
                const glm::dvec3 &a = mesh_.facing[f], &b = mesh_.facing[mesh_.twin(h) / 3];
                if (glm::dot(a, b) < kSharpTurn) mesh_.set_sharp(h, true);
            }
    if (!edges.empty())
        if (const Move move = moved(hub, middle); move.found) mesh_.places[hub] = move.place;
    return true;
}

/// Triangles that look away from the surface, though no step unfolds them: they lie over each other, and every way out
/// would join what is joined already. They are cut out with those about them, and the hole is filled.
std::size_t Remesher::mend(const std::vector<Index>& folded)
{
    std::size_t done = 0;
    std::vector<std::uint32_t> cut(mesh_.triangles(), 0);
    std::uint32_t own = 0;
    for (const Index seed : folded) {
        if (!mesh_.has_triangle(seed)) continue;
        cut.resize(mesh_.triangles(), 0);
        Hole hole;
        hole.triangles = {seed};
        cut[seed] = ++own;
        for (int ring = 0; ring < kMostRings && hole.triangles.size() < kMostCut; ++ring) {
            const std::size_t inner = hole.triangles.size();
            for (std::size_t i = 0; i < inner; ++i)
                for (Index k = 0; k < 3; ++k)
                    mesh_.each_out(mesh_.tail(3 * hole.triangles[i] + k), [&](Index h) {
                        if (cut[h / 3] == own) return;
                        cut[h / 3] = own;
                        hole.triangles.push_back(h / 3);
                    });
            close(mesh_, cut, own, hole);
            // What is about the hole is in order.
            const bool sound = std::none_of(folded.begin(), folded.end(), [&](Index f) {
                if (!mesh_.has_triangle(f) || cut[f] == own) return false;
                for (Index h = 3 * f; h < 3 * f + 3; ++h)
                    if (cut[mesh_.twin(h) / 3] == own) return true;
                return false;
            });
            if (sound && find_rim(mesh_, cut, own, hole) && fill_hole(hole.triangles, hole.rim, cut)) {
                ++done;
                break;
            }
        }
    }
    return done;
}

}  // namespace solid
