#include "render/solid/remesh/remesher.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace solid {
namespace {

constexpr double kSliver = 0.1;         // of the square of the longest side: triangles with less area tell no direction
constexpr double kMostTurn = 0.25;      // radians of the surface along an edge
constexpr double kGrading = 0.55;       // how much longer edges are a unit of length farther away
constexpr double kClearly = 0.3;        // of a triangle's cosine: it lies on its own side
constexpr double kUsualSide = 0.9;      // of the longest side: the wanted length, where it is kept
constexpr double kSame = 0.5;           // cosine: a triangle's surface is not met by what turns more
constexpr double kWellFacing = 0.9990;  // cosine of 2.6 degrees

}  // namespace

bool Remesher::is_sliver(Index f) const
{
    const double side = longest_side(f);
    return glm::length(cross_at(f)) < kSliver * side * side;
}

/// Which way the surface looks about each triangle: by a ray through its middle.
void Remesher::find_facing()
{
    std::vector<glm::dvec3> about(mesh_.vertices(), glm::dvec3(0.0));
    for (Index f = 0; f < mesh_.triangles(); ++f)
        for (Index k = 0; k < 3 && mesh_.has_triangle(f); ++k) about[mesh_.tail(3 * f + k)] += cross_at(f);
    feet_.assign(mesh_.triangles(), {});
    std::vector<std::uint8_t> told(mesh_.triangles(), 0);
    each(mesh_.triangles(), [&](Index f) {
        if (!mesh_.has_triangle(f)) return;
        glm::dvec3 out = cross_at(f);
        const double side = longest_side(f);
        if (is_sliver(f)) out = about[mesh_.tail(3 * f)] + about[mesh_.tail(3 * f + 1)] + about[mesh_.tail(3 * f + 2)];
        const double own = glm::length(out);
        out = own > 0.0 ? out / own : glm::dvec3(0, 0, 1);
        const Foot foot = foot_of(body_, middle_of(f), out, std::max(side, 4.0 * options_.tolerance));
        told[f] = foot.found && glm::dot(foot.at.normal, out) > kSame ? 1 : 0;
        feet_[f] = foot.found ? foot.at : SurfacePoint{middle_of(f), out};
        mesh_.facing[f] = feet_[f].normal;
    });
    ask_neighbours(told);
}

/// What is nearly upright on the surface tells nothing of it: it is counted to the side beyond its longest edge.
void Remesher::ask_neighbours(std::vector<std::uint8_t>& told)
{
    std::vector<Index> waiting;
    for (Index f = 0; f < mesh_.triangles(); ++f)
        if (mesh_.has_triangle(f) && told[f] == 0) waiting.push_back(f);
    for (std::size_t before = waiting.size() + 1; waiting.size() < before;) {
        before = waiting.size();
        std::vector<Index> later, known;
        for (const Index f : waiting) {
            Index best = HalfEdges::kNone;
            for (Index h = 3 * f; h < 3 * f + 3; ++h)
                if (told[mesh_.twin(h) / 3] != 0 && (best == HalfEdges::kNone || length(h) > length(best))) best = h;
            if (best == HalfEdges::kNone) {
                later.push_back(f);
                continue;
            }
            feet_[f] = foot_on_side(f, feet_[mesh_.twin(best) / 3].normal);
            mesh_.facing[f] = feet_[f].normal;
            known.push_back(f);
        }
        for (const Index f : known) told[f] = 1;
        waiting = std::move(later);
    }
}

SurfacePoint Remesher::foot_on_side(Index f, const glm::dvec3& normal) const
{
    const Foot foot = foot_of(body_, middle_of(f), normal, longest_side(f));
    return foot.found && glm::dot(foot.at.normal, normal) > kSharpTurn ? foot.at : SurfacePoint{middle_of(f), normal};
}

void Remesher::find_sharp()
{
    const std::size_t count = 3 * mesh_.triangles();
    std::vector<std::uint8_t> sharp(count, 0);
    each(count, [&](Index h) {
        if (!mesh_.has_triangle(h / 3)) return;
        const Index t = mesh_.twin(h);
        if (t < h) return;
        const SurfacePoint &a = feet_[h / 3], &b = feet_[t / 3];
        if (glm::dot(a.normal, b.normal) > kSharpTurn) return;
        sharp[h] = is_sharp_between(body_, a, b) ? 1 : 0;
    });
    for (Index h = 0; h < count; ++h)
        if (mesh_.has_triangle(h / 3) && h < mesh_.twin(h)) mesh_.set_sharp(h, sharp[h] != 0);
}

/// Counts a triangle to the side of the body that looks along `normal`.
void Remesher::take_side(Index f, const glm::dvec3& normal)
{
    mesh_.facing[f] = foot_on_side(f, normal).normal;
    touch(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
        mesh_.set_sharp(h, glm::dot(mesh_.facing[f], mesh_.facing[mesh_.twin(h) / 3]) < kSharpTurn);
}

/// A triangle that lies across an edge of the body, or is too thin to tell, goes to the side that holds two of its
/// neighbours: it straightens the line of sharp edges.
bool Remesher::straighten(Index f)
{
    for (Index k = 0; k < 3; ++k) {
        const Index a = 3 * f + k, b = HalfEdges::next(a), c = HalfEdges::before(a);
        if (!mesh_.is_sharp(a) || !mesh_.is_sharp(b)) continue;
        const glm::dvec3 one = mesh_.facing[mesh_.twin(a) / 3], two = mesh_.facing[mesh_.twin(b) / 3];
        if (glm::dot(one, two) < kSharpTurn) continue;
        const glm::dvec3 n = cross_at(f), both = glm::normalize(one + two);
        const double side = longest_side(f), area = glm::length(n);
        if (area > kSliver * side * side &&
            glm::dot(n, both) < glm::dot(n, mesh_.facing[f]) - (mesh_.is_sharp(c) ? 0.0 : kClearly * area))
            continue;
        mesh_.facing[f] = both;
        touch(f);
        mesh_.set_sharp(a, false);
        mesh_.set_sharp(b, false);
        mesh_.set_sharp(c, glm::dot(both, mesh_.facing[mesh_.twin(c) / 3]) < kSharpTurn);
        return true;
    }
    return false;
}

/// Where two sides meet in one vertex by turns, the smallest part goes to the other side.
bool Remesher::unpinch(Index v)
{
    if (sharp_edges(v) < 4) return false;
    struct Part {
        std::vector<Index> triangles;
        double area = 0.0;
        glm::dvec3 normal{0.0};
    };
    std::vector<Part> parts;
    Index start = mesh_.first_out(v);
    while (!mesh_.is_sharp(start)) start = mesh_.around(start);
    Index h = start;
    do {
        if (mesh_.is_sharp(h)) parts.emplace_back();
        const double area = glm::length(cross_at(h / 3));
        parts.back().triangles.push_back(h / 3);
        parts.back().area += area;
        parts.back().normal += mesh_.facing[h / 3] * (area + 1e-30);
        h = mesh_.around(h);
    } while (h != start);
    std::size_t best = parts.size();
    for (Part& part : parts) part.normal = glm::normalize(part.normal);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const glm::dvec3 left = parts[(i + parts.size() - 1) % parts.size()].normal,
                         right = parts[(i + 1) % parts.size()].normal;
        if (!(glm::dot(left, right) >= kSharpTurn)) continue;
        if (best == parts.size() || parts[i].area < parts[best].area) best = i;
    }
    if (best == parts.size()) return false;
    for (const Index f : parts[best].triangles) take_side(f, parts[(best + 1) % parts.size()].normal);
    return true;
}

/// A line of sharp edges that ends goes on where the surface is bent most, or its last edge is none.
void Remesher::follow_edge(Index v)
{
    double most = kSharpTurn;
    Index best = HalfEdges::kNone, last = HalfEdges::kNone;
    mesh_.each_out(v, [&](Index h) {
        const double own = glm::dot(mesh_.facing[h / 3], mesh_.facing[mesh_.twin(h) / 3]);
        if (mesh_.is_sharp(h)) last = h;
        else if (own < most) {
            most = own;
            best = h;
        }
    });
    const Index changed = best != HalfEdges::kNone ? best : last;
    mesh_.set_sharp(changed, best != HalfEdges::kNone);
    touch(changed / 3);
    touch(mesh_.twin(changed) / 3);
}

void Remesher::tidy_sharp()
{
    constexpr int kSweeps = 6;
    std::vector<std::uint8_t> counts;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        std::size_t changed = 0;
        for (Index f = 0; f < mesh_.triangles(); ++f) changed += mesh_.has_triangle(f) && straighten(f) ? 1 : 0;
        count_sharp(counts);
        for (Index v = 0; v < mesh_.vertices(); ++v) changed += counts[v] >= 4 && unpinch(v) ? 1 : 0;
        count_sharp(counts);
        for (Index v = 0; v < mesh_.vertices(); ++v) {
            if (counts[v] == 0 || sharp_edges(v) != 1) continue;
            follow_edge(v);
            ++changed;
        }
        if (changed == 0) break;
    }
    find_kinds();
}

int Remesher::sharp_edges(Index v) const
{
    int sharp = 0;
    mesh_.each_out(v, [&](Index h) { sharp += mesh_.is_sharp(h) ? 1 : 0; });
    return sharp;
}

/// By vertex, how many sharp edges meet there.
void Remesher::count_sharp(std::vector<std::uint8_t>& counts) const
{
    counts.assign(mesh_.vertices(), 0);
    for (Index h = 0; h < 3 * mesh_.triangles(); ++h)
        if (mesh_.is_sharp(h) && mesh_.has_triangle(h / 3) && counts[mesh_.tail(h)] < 255) ++counts[mesh_.tail(h)];
}

void Remesher::find_kinds()
{
    std::vector<std::uint8_t> counts;
    count_sharp(counts);
    kinds_.resize(mesh_.vertices(), Kind::Smooth);
    for (Index v = 0; v < mesh_.vertices(); ++v) {
        const Kind before = kinds_[v];
        kinds_[v] = counts[v] == 0 ? Kind::Smooth : counts[v] == 2 ? Kind::Crease : Kind::Corner;
        if (kinds_[v] == before || !mesh_.has_vertex(v)) continue;
        on_edge_[v] = 0;
        touch_about(v);
    }
}

/// From how the surface turns between neighbouring triangles: of an edge of length l on a curvature k the middle of a
/// triangle is k l l / 6 off.
void Remesher::find_lengths()
{
    touch_all();
    lengths_.assign(mesh_.vertices(), 0.5 * size_);
    for (Index h = 0; h < 3 * mesh_.triangles(); ++h) {
        if (!mesh_.has_triangle(h / 3)) continue;
        const Index t = mesh_.twin(h);
        if (t < h || mesh_.is_sharp(h)) continue;
        if (is_sliver(h / 3) || is_sliver(t / 3)) continue;
        const double turn = glm::length(mesh_.facing[h / 3] - mesh_.facing[t / 3]);
        if (turn < 1e-6) continue;
        const double bend = turn / std::max({glm::length(middle_of(h / 3) - middle_of(t / 3)), 2.0 * options_.tolerance,
                                             body_.grain()});
        const double own = std::max(least_, std::min(std::sqrt(6.0 * off_ / bend), kMostTurn / bend));
        for (const Index v :
             {mesh_.tail(h), mesh_.head(h), mesh_.tail(HalfEdges::before(h)), mesh_.tail(HalfEdges::before(t))})
            lengths_[v] = std::min(lengths_[v], own);
    }
    grade_lengths();
}

/// Lengths of neighbours differ by a part of their distance only.
void Remesher::grade_lengths()
{
    using Entry = std::pair<double, Index>;
    std::vector<Entry> entries;
    for (Index v = 0; v < mesh_.vertices(); ++v)
        if (mesh_.has_vertex(v)) entries.emplace_back(lengths_[v], v);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next(std::greater<>(), std::move(entries));
    while (!next.empty()) {
        const double own = next.top().first;
        const Index v = next.top().second;
        next.pop();
        if (own > lengths_[v]) continue;
        mesh_.each_out(v, [&](Index h) {
            const Index w = mesh_.head(h);
            const double most = own + kGrading * length(h);
            if (most >= lengths_[w]) return;
            lengths_[w] = most;
            next.emplace(most, w);
        });
    }
}

/// After vertices moved: from their normals where all are smooth, else by a ray.
void Remesher::face_again()
{
    each(mesh_.triangles(), [&](Index f) {
        if ((fresh_[f] & kFace) == 0 || !mesh_.has_triangle(f)) return;
        const glm::dvec3 before = mesh_.facing[f];
        glm::dvec3 sum(0.0);
        bool smooth = true;
        for (Index k = 0; k < 3; ++k) {
            const glm::dvec3& n = normals_[mesh_.tail(3 * f + k)];
            smooth = smooth && n != glm::dvec3(0.0);
            sum += n;
        }
        if (smooth && glm::length(sum) > 1.5) {
            mesh_.facing[f] = glm::normalize(sum);
        } else {
            const Foot foot = foot_of(body_, middle_of(f), before, longest_side(f));
            if (foot.found && glm::dot(foot.at.normal, before) > kSame) mesh_.facing[f] = foot.at.normal;
        }
        if (mesh_.facing[f] != before) fresh_[f] |= kFlip | kCollapse;
    });
    seen_by(kFace);
}

std::size_t Remesher::look_for_misfits()
{
    std::vector<double> shares(mesh_.triangles(), 1.0);
    fitting_.resize(mesh_.triangles(), glm::dvec3(numbers::kInfinity));
    each(mesh_.triangles(), [&](Index f) {
        if (!mesh_.has_triangle(f)) return;
        if (middle_of(f) == fitting_[f]) return;  // it is what it was
        const glm::dvec3 n = cross_at(f);
        const double area = glm::length(n), side = longest_side(f);
        if (!(area > 1e-3 * side * side)) return;
        const Foot foot = foot_of(body_, middle_of(f), n / area, side);
        if (!foot.found) {
            shares[f] = 0.5;
            return;
        }
        const double cosine = glm::dot(foot.at.normal, n / area);
        if (std::abs(foot.end.t) > off_) shares[f] = std::clamp(std::sqrt(off_ / std::abs(foot.end.t)), 0.5, 0.9);
        if (cosine < kWellFacing && side > body_.grain()) shares[f] = std::min(shares[f], cosine < 0.985 ? 0.5 : 0.85);
        if (shares[f] >= 1.0) fitting_[f] = middle_of(f);
    });
    std::size_t found = 0;
    const std::vector<double> before = lengths_;
    for (Index f = 0; f < mesh_.triangles(); ++f) {
        if (shares[f] >= 1.0) continue;
        const double longest = longest_side(f);
        if (longest <= least_) continue;
        ++found;
        for (Index k = 0; k < 3; ++k) {
            double& own = lengths_[mesh_.tail(3 * f + k)];
            own = std::max(least_, std::min(own, shares[f] * kUsualSide * longest));
        }
    }
    if (found == 0) return found;
    grade_lengths();
    for (Index v = 0; v < mesh_.vertices(); ++v)
        if (mesh_.has_vertex(v) && lengths_[v] != before[v]) touch_about(v);
    return found;
}

/// The sides between sharp edges about a vertex, each by its largest triangle.
std::size_t Remesher::sides_of(Index v, std::array<Side, 16>& out) const
{
    Index start = HalfEdges::kNone;
    mesh_.each_out(v, [&](Index h) {
        if (start == HalfEdges::kNone && mesh_.is_sharp(h)) start = h;
    });
    if (start == HalfEdges::kNone) return 0;
    std::size_t count = 0;
    double largest = -1.0;
    Index h = start;
    do {
        if (mesh_.is_sharp(h)) {
            if (count == out.size()) return 0;
            out[count++].foot.found = false;
            largest = -1.0;
        }
        const Index f = h / 3;
        const double area = glm::length(cross_at(f));
        Side& side = out[count - 1];
        if (area > largest) {
            largest = area;
            side.within = middle_of(f);
            side.normal = mesh_.facing[f];
        }
        if (const Index w = mesh_.head(h); !side.foot.found && normals_[w] != glm::dvec3(0.0)) {
            side.foot.found = true;  // where no ray meets the side, it is told by a neighbour
            side.foot.at = {mesh_.places[w], normals_[w]};
        }
        h = mesh_.around(h);
    } while (h != start);
    return count;
}

}  // namespace solid
