#include "render/solid/remesh/remesher.h"

#include <algorithm>
#include <cmath>

namespace solid {
namespace {

constexpr double kAgrees = 0.5;    // cosine: the surface that is met is the vertex's own
constexpr double kTurned = 0.77;   // cosine of 40 degrees: triangles that moves make look so near to the surface
constexpr double kStill = 0.06;    // of the shortest edge: steps that are not worth a ray
constexpr double kStep = 0.7;      // of the way to the middle of the neighbours
constexpr double kSettled = 10.0;  // tolerances: vertices are no farther from where they belong
constexpr double kLean = 0.966;    // cosine of 15 degrees: moves make no sharper angle
constexpr double kStays = 1e-4;    // of the tolerance: shorter moves are none

}  // namespace

/// Where a vertex comes to lie on the surface, or on the edge or corner that it belongs to, near a place.
Remesher::Move Remesher::moved(Index v, const glm::dvec3& to, std::size_t steps) const
{
    Move out;
    double longest = kSettled * options_.tolerance;
    glm::dvec3 sum(0.0);
    mesh_.each_out(v, [&](Index h) {
        longest = std::max(longest, length(h));
        sum += mesh_.facing[h / 3] * glm::length(cross_at(h / 3));
    });
    if (kinds_[v] != Kind::Smooth) {
        std::array<Side, 16> sides;
        const std::size_t count = sides_of(v, sides);
        if (count > 1) {
            out.found = meeting_place(body_, std::span(sides.data(), count), to, longest, steps, out.place);
            return out;
        }
    }
    const double own = glm::length(sum);
    if (!(own > 0.0)) return out;
    const Foot foot = foot_of(body_, to, sum / own, longest);
    out.found = foot.found && glm::dot(foot.at.normal, sum / own) > kAgrees;
    out.place = foot.at.point;
    if (!out.found) return beside(v);
    if (kinds_[v] == Kind::Smooth) out.normal = foot.at.normal;
    return out;
}

/// A vertex that hangs over an edge of the body, where no ray meets its side: into the tangent plane of a neighbour.
Remesher::Move Remesher::beside(Index v) const
{
    Move out;
    double nearest = numbers::kInfinity;
    const glm::dvec3 here = mesh_.places[v];
    mesh_.each_out(v, [&](Index h) {
        const Index w = mesh_.head(h);
        if (normals_[w] == glm::dvec3(0.0) || length(h) >= nearest) return;
        nearest = length(h);
        out.found = true;
        out.place = here - normals_[w] * glm::dot(normals_[w], here - mesh_.places[w]);
    });
    return out;
}

/// Along the surface or the edge, toward the middle of the neighbours there.
glm::dvec3 Remesher::wanted_place(Index v) const
{
    const glm::dvec3 here = mesh_.places[v];
    glm::dvec3 sum(0.0);
    int count = 0;
    std::array<glm::dvec3, 2> ends{};
    mesh_.each_out(v, [&](Index h) {
        if (kinds_[v] == Kind::Crease && !mesh_.is_sharp(h)) return;
        const glm::dvec3& there = mesh_.places[mesh_.head(h)];
        if (count < 2) ends[static_cast<std::size_t>(count)] = there;
        sum += there;
        ++count;
    });
    if (kinds_[v] == Kind::Corner || count == 0) return here;
    const glm::dvec3 step = kStep * (sum / static_cast<double>(count) - here);
    if (kinds_[v] == Kind::Crease) {
        const glm::dvec3 along = ends[1] - ends[0];
        const double length2 = glm::dot(along, along);
        return length2 > 0.0 ? here + along * (glm::dot(step, along) / length2) : here;
    }
    const glm::dvec3& n = normals_[v];
    return here + step - n * glm::dot(n, step);
}

bool Remesher::may_move(Index v, const glm::dvec3& to) const
{
    const glm::dvec3 here = mesh_.places[v];
    double turned = 0.0, will_turn = 0.0, thin = 0.0, will_be_thin = 0.0;
    mesh_.each_out(v, [&](Index h) {
        const glm::dvec3 a = mesh_.places[mesh_.head(h)], b = mesh_.places[mesh_.tail(HalfEdges::before(h))];
        const glm::dvec3 facing = mesh_.facing[h / 3];
        turned += std::max(0.0, kTurned - facing_of(cross_of(here, a, b), facing));
        will_turn += std::max(0.0, kTurned - facing_of(cross_of(to, a, b), facing));
        thin += std::max(0.0, sharpest_cosine(here, a, b) - kLean);
        will_be_thin += std::max(0.0, sharpest_cosine(to, a, b) - kLean);
    });
    if (will_turn > 0.0 || turned > 0.0) return will_turn < turned || to == here;
    return will_be_thin <= thin || normals_[v] == glm::dvec3(0.0);
}

/// Whether a vertex is on the surface, or on the edge or corner that it belongs to, by a ray that told so.
bool Remesher::is_placed(Index v) const
{
    return kinds_[v] == Kind::Smooth ? normals_[v] != glm::dvec3(0.0) : on_edge_[v] != 0;
}

void Remesher::put(Index v, const Move& move)
{
    // What stays where it was changes nothing for the triangles about it.
    if (glm::length(move.place - mesh_.places[v]) > kStays * options_.tolerance || !is_placed(v)) touch_about(v);
    mesh_.places[v] = move.place;
    normals_[v] = move.normal;
    on_edge_[v] = 1;
}

/// All vertices go where they belong, whatever becomes of their triangles: those about sharp edges are set right later.
void Remesher::settle(bool all)
{
    std::vector<Move> moves(mesh_.vertices());
    each(mesh_.vertices(), [&](Index v) {
        if (mesh_.has_vertex(v) && (all || kinds_[v] != Kind::Smooth))
            moves[v] = moved(v, mesh_.places[v], kRoughSteps);
    });
    for (Index v = 0; v < mesh_.vertices(); ++v)
        if (moves[v].found && glm::length(moves[v].place - mesh_.places[v]) <= kSettled * options_.tolerance)
            put(v, moves[v]);
    face_again();
}

/// All vertices, by threads; then what keeps its triangles in order is done.
void Remesher::move_all(bool smooth)
{
    std::vector<Move> moves(mesh_.vertices());
    each(mesh_.vertices(), [&](Index v) {
        if (!mesh_.has_vertex(v)) return;
        if (smooth) {
            bool fresh = false;
            mesh_.each_out(v, [&](Index h) { fresh = fresh || (fresh_[h / 3] & kMove) != 0; });
            if (!fresh) return;
        }
        const glm::dvec3 to = smooth ? wanted_place(v) : mesh_.places[v];
        // A vertex that is where it belongs costs no ray.
        if ((smooth || kinds_[v] == Kind::Smooth) && is_placed(v) &&
            glm::length(to - mesh_.places[v]) < kStill * shortest_edge(v))
            return;
        moves[v] = moved(v, to);
    });
    seen_by(kMove);
    for (Index v = 0; v < mesh_.vertices(); ++v) {
        if (!mesh_.has_vertex(v) || !moves[v].found) continue;
        if (!may_move(v, moves[v].place)) {
            if (!smooth || is_placed(v)) continue;
            moves[v] = moved(v, mesh_.places[v]);
            if (!moves[v].found || !may_move(v, moves[v].place)) continue;
        }
        put(v, moves[v]);
    }
    face_again();
}

}  // namespace solid
