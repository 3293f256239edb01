#include "render/solid/remesh/remesher.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace solid {
namespace {

constexpr double kLong = 4.0 / 3.0, kShort = 4.0 / 5.0;  // of the wanted length (Botsch and Kobbelt)
constexpr double kFacing = 0.906;  // cosine of 25 degrees: triangles that connections make look so near to the surface
constexpr double kNearlyLongest = 0.99;
constexpr double kNearFacing = 0.98;     // of 11: they do not get worse than that by a flip
constexpr double kBetterAngle = 0.005;   // of the cosine, by a flip
constexpr double kWellShaped = 0.94;     // cosine of 20 degrees: a collapse that leaves this is good enough
constexpr double kBarely = 0.998;        // of 3.6: worse ones are not made
constexpr double kMuchShorter = 0.3;     // than the wanted length
constexpr double kOnePlace = 0.1;        // of the least length: vertices so near are in one place
constexpr double kBearable = 0.2;        // of cosines in all: what triangles may turn away where two such become one
constexpr double kBetterCost = 1e-9;     // of cosines in all: less is rounding
constexpr double kNearlyAlong = 0.9990;  // cosine of 2.6 degrees: triangles that look so near to the surface may stay
constexpr double kNearer = 1e-5;         // of a cosine: what is worth a flip
constexpr int kMostSweeps = 8;

}  // namespace

double facing_of(const glm::dvec3& cross, const glm::dvec3& facing)
{
    const double area = glm::length(cross);
    return area > 0.0 ? glm::dot(cross, facing) / area : -1.0;
}

double sharpest_cosine(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    // The least angle lies across the shortest side.
    const glm::dvec3 ab = b - a, bc = c - b, ca = a - c;
    const double x = glm::dot(ab, ab), y = glm::dot(bc, bc), z = glm::dot(ca, ca);
    if (!(x > 0.0 && y > 0.0 && z > 0.0)) return 1.0;
    if (x <= y && x <= z) return -glm::dot(bc, ca) / std::sqrt(y * z);
    if (y <= z) return -glm::dot(ca, ab) / std::sqrt(z * x);
    return -glm::dot(ab, bc) / std::sqrt(x * y);
}

/// Whether an edge is the longest of both its triangles: others wait, or thin triangles would multiply (Rivara, 1984).
bool Remesher::is_longest(Index h) const
{
    const Index t = mesh_.twin(h);
    double longest = 0.0;
    for (const Index other : {HalfEdges::next(h), HalfEdges::before(h), HalfEdges::next(t), HalfEdges::before(t)})
        longest = std::max(longest, length(other));
    return length(h) >= kNearlyLongest * longest;
}

std::size_t Remesher::split_long()
{
    std::size_t done = 0;
    for (int sweep = 0; sweep < kMostSweeps && !overrun_; ++sweep) {
        std::size_t now = 0;
        for (const Index h : edges_for(kSplit)) {
            if (length(h) <= kLong * wanted_length(h) || !is_longest(h)) continue;
            const Index u = mesh_.tail(h), v = mesh_.head(h);
            const bool sharp = mesh_.is_sharp(h);
            const Index m = mesh_.split(h, 0.5 * (mesh_.places[u] + mesh_.places[v]));
            fresh_.resize(mesh_.triangles());
            touch_about(m);
            on_edge_.push_back(0);
            kinds_.push_back(sharp ? Kind::Crease : Kind::Smooth);
            lengths_.push_back(0.5 * (lengths_[u] + lengths_[v]));
            normals_.emplace_back(0.0);
            ++now;
        }
        done += now;
        overrun_ = mesh_.alive() > most_triangles_;
        if (now == 0 || overrun_) break;
        flip_better(edges_for(kFlip));  // what was collapsed or moved before may be better turned, too
    }
    return done;
}

/// Whether the tail may be put into the head: no edge of the body is lost, and no triangle turns over or becomes long.
bool Remesher::may_collapse(Index h, bool unfolding) const
{
    const Index u = mesh_.tail(h), v = mesh_.head(h);
    if (kinds_[u] == Kind::Corner) return false;
    if (kinds_[u] == Kind::Crease && !mesh_.is_sharp(h)) return false;
    if (!mesh_.can_collapse(h)) return false;
    const glm::dvec3 from = mesh_.places[u], to = mesh_.places[v];
    bool good = true;
    double nearest = numbers::kInfinity, worst_before = -1.0, worst_after = -1.0, cost_before = 0.0, cost_after = 0.0,
           thin_before = 0.0, thin_after = 0.0;
    mesh_.each_out(u, [&](Index o) {
        if (!good) return;
        const Index w = mesh_.head(o), x = mesh_.tail(HalfEdges::before(o));
        if (!unfolding && w != v && glm::length(mesh_.places[w] - to) > kLong * std::min(lengths_[w], lengths_[v]) &&
            glm::length(mesh_.places[w] - to) > glm::length(mesh_.places[w] - from)) {
            good = false;
            return;
        }
        const double was = sharpest_cosine(from, mesh_.places[w], mesh_.places[x]);
        worst_before = std::max(worst_before, was);
        thin_before += std::max(0.0, was - kWellShaped);
        cost_before +=
            std::max(0.0, kFacing - facing_of(cross_of(from, mesh_.places[w], mesh_.places[x]), mesh_.facing[o / 3]));
        if (w == v || x == v) return;
        const glm::dvec3 n = cross_of(to, mesh_.places[w], mesh_.places[x]);
        cost_after += std::max(0.0, kFacing - facing_of(n, mesh_.facing[o / 3]));
        const double is = sharpest_cosine(to, mesh_.places[w], mesh_.places[x]);
        worst_after = std::max(worst_after, is);
        thin_after += std::max(0.0, is - kWellShaped);
        nearest = std::min(nearest, std::abs(glm::dot(from - to, n)) / glm::length(n));
        if (kinds_[u] == Kind::Crease && mesh_.is_sharp(o)) {
            // The edge is bent no farther off than triangles may be.
            const glm::dvec3 along = glm::normalize(mesh_.places[w] - to), d = from - to;
            if (glm::length(d - along * glm::dot(d, along)) > off_) good = false;
        }
    });
    if (!good || nearest > off_) return false;
    // Vertices in nearly the same place are one, if the rest can bear it.
    if (length(h) < kOnePlace * least_ && cost_after < cost_before + kBearable) return true;
    if (cost_after > 0.0 || unfolding) return cost_after < cost_before - kBetterCost;
    return worst_after < kWellShaped || (worst_after < worst_before + 1e-9) ||
           ((worst_after < kBarely || thin_after < thin_before) && length(h) < kMuchShorter * wanted_length(h));
}

/// Triangles that look away from the surface: an edge of theirs goes, however long it is.
std::size_t Remesher::unfold()
{
    std::size_t done = 0;
    for (Index f = 0; f < mesh_.triangles(); ++f) {
        if (!mesh_.has_triangle(f) || facing_of(cross_at(f), mesh_.facing[f]) > kFacing) continue;
        for (Index h = 3 * f; h < 3 * f + 3 && mesh_.has_triangle(f); ++h)
            for (const Index way : {h, mesh_.twin(h)})
                if (mesh_.has_triangle(f) && may_collapse(way, true)) {
                    const Index v = mesh_.head(way);
                    mesh_.collapse(way);
                    touch_about(v);
                    ++done;
                }
    }
    return done;
}

std::vector<HalfEdges::Index> Remesher::folded(double cosine) const
{
    std::vector<Index> out;
    for (Index f = 0; f < mesh_.triangles(); ++f)
        if (mesh_.has_triangle(f) && facing_of(cross_at(f), mesh_.facing[f]) < cosine) out.push_back(f);
    return out;
}

std::size_t Remesher::collapse_short()
{
    std::size_t done = 0;
    // By vertex: the sweep that is to look at its edges, as something about it changed.
    std::vector<int> look(mesh_.vertices(), -1);
    for (Index f = 0; f < mesh_.triangles(); ++f)
        for (Index k = 0; k < 3 && mesh_.has_triangle(f) && (fresh_[f] & kCollapse) != 0; ++k)
            look[mesh_.tail(3 * f + k)] = 0;
    seen_by(kCollapse);
    std::vector<Index> waiting;
    for (Index h = 0; h < 3 * mesh_.triangles(); ++h)
        if (mesh_.has_triangle(h / 3) && (look[mesh_.tail(h)] == 0 || look[mesh_.head(h)] == 0)) waiting.push_back(h);
    std::vector<Index> changed;
    for (int sweep = 0; sweep < 2 * kMostSweeps && !waiting.empty(); ++sweep) {
        changed.clear();
        for (const Index h : waiting) {
            if (!mesh_.has_triangle(h / 3)) continue;
            if (length(h) >= kShort * wanted_length(h) || !may_collapse(h, false)) continue;
            const Index v = mesh_.head(h);
            mesh_.collapse(h);
            touch_about(v);
            const auto again = [&](Index w) {
                if (look[w] > sweep) return;
                look[w] = sweep + 1;
                changed.push_back(w);
            };
            again(v);
            mesh_.each_out(v, [&](Index o) { again(mesh_.head(o)); });
            ++done;
        }
        waiting.clear();
        for (const Index w : changed)
            if (mesh_.has_vertex(w))
                mesh_.each_out(w, [&](Index o) {
                    waiting.push_back(o);
                    waiting.push_back(mesh_.twin(o));
                });
        std::sort(waiting.begin(), waiting.end());
        waiting.erase(std::unique(waiting.begin(), waiting.end()), waiting.end());
    }
    return done;
}

bool Remesher::may_flip(Index h) const
{
    if (mesh_.is_sharp(h)) return false;
    const Index t = mesh_.twin(h);
    const glm::dvec3 u = mesh_.places[mesh_.tail(h)], v = mesh_.places[mesh_.head(h)],
                     w = mesh_.places[mesh_.tail(HalfEdges::before(h))],
                     x = mesh_.places[mesh_.tail(HalfEdges::before(t))];
    const glm::dvec3 both = mesh_.facing[h / 3] + mesh_.facing[t / 3];
    const double sum = glm::length(both);
    if (!(sum > 0.1)) return false;
    const double before = std::min(facing_of(cross_of(u, v, w), both / sum), facing_of(cross_of(v, u, x), both / sum)),
                 after = std::min(facing_of(cross_of(x, w, u), both / sum), facing_of(cross_of(w, x, v), both / sum));
    if (after < std::min(before, kNearFacing)) return false;
    if (after > before + 0.02 && before < kFacing) return mesh_.can_flip(h);
    const double own = std::max(sharpest_cosine(u, v, w), sharpest_cosine(v, u, x)),
                 turned = std::max(sharpest_cosine(x, w, u), sharpest_cosine(w, x, v));
    return turned < own - kBetterAngle && mesh_.can_flip(h);
}

std::vector<HalfEdges::Index> Remesher::edges_for(Step step)
{
    std::vector<Index> out;
    for (Index f = 0; f < mesh_.triangles(); ++f) {
        if ((fresh_[f] & step) == 0 || !mesh_.has_triangle(f)) continue;
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
            if (const Index t = mesh_.twin(h); h < t || (fresh_[t / 3] & step) == 0) out.push_back(h);
    }
    seen_by(step);
    return out;
}

std::size_t Remesher::flip_better(std::vector<Index> waiting)
{
    std::size_t done = 0;
    std::vector<Index> next;
    for (int sweep = 0; sweep < kMostSweeps && !waiting.empty(); ++sweep) {
        next.clear();
        for (const Index h : waiting) {
            if (!may_flip(h)) continue;
            const Index t = mesh_.twin(h);
            const glm::dvec3 both = glm::normalize(mesh_.facing[h / 3] + mesh_.facing[t / 3]);
            mesh_.flip(h);
            mesh_.facing[h / 3] = mesh_.facing[t / 3] = both;
            touch(h / 3);
            touch(t / 3);
            ++done;
            // What lies about it may be better turned, too.
            for (const Index o : {HalfEdges::next(h), HalfEdges::before(h), HalfEdges::next(t), HalfEdges::before(t)})
                next.push_back(o);
        }
        waiting.swap(next);
    }
    return done;
}

/// Where the surface is bent within few edges, triangles look nearer to it along one diagonal than along the other.
/// Last of all, as their angles get no better by it.
void Remesher::flip_to_face()
{
    const auto looks = [&](Index a, Index b, Index c) {
        const glm::dvec3 sum = normals_[a] + normals_[b] + normals_[c];
        return facing_of(cross_of(mesh_.places[a], mesh_.places[b], mesh_.places[c]), sum / glm::length(sum));
    };
    for (Index h = 0; h < 3 * mesh_.triangles(); ++h) {
        if (!mesh_.has_triangle(h / 3) || mesh_.twin(h) < h || mesh_.is_sharp(h)) continue;
        const Index t = mesh_.twin(h), u = mesh_.tail(h), v = mesh_.head(h), w = mesh_.tail(HalfEdges::before(h)),
                    x = mesh_.tail(HalfEdges::before(t));
        const std::array<Index, 4> all{u, v, w, x};
        if (std::any_of(all.begin(), all.end(), [&](Index i) { return normals_[i] == glm::dvec3(0.0); })) continue;
        const double before = std::min(looks(u, v, w), looks(v, u, x));
        if (before > kNearlyAlong || !(std::min(looks(x, w, u), looks(w, x, v)) > before + kNearer)) continue;
        const auto shape = [&](Index a, Index b, Index c) {
            return sharpest_cosine(mesh_.places[a], mesh_.places[b], mesh_.places[c]);
        };
        if (std::max(shape(x, w, u), shape(w, x, v)) > kWellShaped || !mesh_.can_flip(h)) continue;
        mesh_.flip(h);
        for (const Index f : {h / 3, t / 3}) {
            glm::dvec3 sum(0.0);
            for (Index k = 0; k < 3; ++k) sum += normals_[mesh_.tail(3 * f + k)];
            mesh_.facing[f] = glm::normalize(sum);
        }
    }
}

}  // namespace solid
