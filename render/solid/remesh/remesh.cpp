#include "render/solid/remesh/remesh.h"

#include "render/solid/mesh/check.h"
#include "render/solid/remesh/crossings.h"
#include "render/solid/remesh/remesher.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace solid {
namespace {

/// How much farther off tetrahedra may be than the mesh, and what is made of them then. Where that comes out folded, or
/// what is thin was overlooked, those are taken that would serve as they are.
struct Aim {
    double tetrahedra, made;  // of the tolerance
};
constexpr std::array<Aim, 2> kAims{{{3.0, 1.0}, {1.0, 0.5}}};
constexpr double kOffShare = 0.5;                          // of the tolerance: the aim, as not all places are looked at
constexpr double kFolded = 0.5;                            // cosine of 60 degrees: a mesh with such a triangle is none
constexpr double kTurnedAway = 0.906;                      // of 25: edges are looked for again
constexpr double kAway = 0.966;                            // of 15: such triangles are cut out
constexpr double kLeastLength = 1e-3;                      // of the body's size
constexpr std::size_t kMostTimes = 3, kMostMore = 20'000;  // triangles made, as against those that there were
constexpr int kRounds = 6, kMoreRounds = 2, kCorrections = 3, kMends = 4;

}  // namespace

glm::dvec3 Remesher::cross_at(Index f) const
{
    return cross_of(mesh_.places[mesh_.tail(3 * f)], mesh_.places[mesh_.tail(3 * f + 1)],
                    mesh_.places[mesh_.tail(3 * f + 2)]);
}

glm::dvec3 Remesher::middle_of(Index f) const
{
    return (mesh_.places[mesh_.tail(3 * f)] + mesh_.places[mesh_.tail(3 * f + 1)] +
            mesh_.places[mesh_.tail(3 * f + 2)]) /
           3.0;
}

double Remesher::longest_side(Index f) const
{
    return std::max(length(3 * f), std::max(length(3 * f + 1), length(3 * f + 2)));
}

double Remesher::shortest_edge(Index v) const
{
    double out = numbers::kInfinity;
    mesh_.each_out(v, [&](Index h) { out = std::min(out, length(h)); });
    return out;
}

Remesher::Remesher(const Body& body, const csg::Aabb& extent, const RefineOptions& options)
    : body_(body), options_(options)
{
    const glm::dvec3 size = extent.upper - extent.lower;
    size_ = glm::max(size.x, glm::max(size.y, size.z));
    off_ = kOffShare * options.tolerance;
    least_ = std::max(kLeastLength * size_, options.tolerance);
}

bool Remesher::take(const TriangleMesh& mesh)
{
    if (!mesh_.take(mesh)) return false;
    normals_.assign(mesh_.vertices(), glm::dvec3(0.0));
    on_edge_.assign(mesh_.vertices(), 0);
    touch_all();
    most_triangles_ = kMostTimes * mesh.triangles.size() + kMostMore;
    return true;
}

void Remesher::look_at_surface()
{
    touch_all();
    find_facing();
    find_sharp();
    tidy_sharp();
}

bool Remesher::run()
{
    look_at_surface();
    find_lengths();
    settle(true);
    settle(true);  // neighbours tell what they know now
    const auto round = [&] {
        if (std::chrono::steady_clock::now() >= options_.deadline) overrun_ = true;
        if (overrun_) return;
        tidy_sharp();
        collapse_short();
        split_long();
        flip_better(edges_for(kFlip));
        move_all(true);
        flip_better(edges_for(kFlip));
        unfold();
    };
    for (int i = 0; i < kRounds && !overrun_; ++i) {
        if (i == 2 ||
            (i == 4 && any_folded(kTurnedAway))) {  // triangles are better now, and tell edges and curvature better
            look_at_surface();
            find_lengths();
            settle(false);
        }
        round();
    }
    for (int i = 0; i < kCorrections && !overrun_ && look_for_misfits() > 0; ++i) {
        if (any_folded(kTurnedAway)) {
            look_at_surface();
            settle(false);
        }
        for (int k = 0; k < kMoreRounds; ++k) round();
    }
    for (int i = 0; i < kMends && !overrun_ && mend(folded(kAway)) > 0; ++i)
        for (int k = 0; k < kMoreRounds; ++k) round();
    flip_to_face();
    move_all(false);
    return !overrun_;
}

bool remesh(const Body& body, const csg::Aabb& extent, const RefineOptions& options, TriangleMesh& mesh)
{
    Remesher remesher(body, extent, options);
    if (!check(mesh).good() || !remesher.take(mesh)) return false;
    if (!remesher.run() || remesher.any_folded(kFolded)) return false;
    TriangleMesh made = remesher.result();
    if (!check(made).good() || crossings(made) > 0) return false;
    mesh = std::move(made);
    return true;
}

void add_normals(const Body& body, const csg::Aabb& extent, const RefineOptions& options, TriangleMesh& mesh)
{
    Remesher remesher(body, extent, options);
    if (!check(mesh).good() || !remesher.take(mesh)) return;
    remesher.look_at_surface();
    mesh = remesher.result();
}

TriangleMesh good_mesh_of(const Body& body, const csg::Aabb& extent, const RefineOptions& options, MeshFacts& facts,
                          const std::function<bool(const TriangleMesh&)>& serves)
{
    TriangleMesh mesh;
    for (const Aim& aim : kAims) {
        // Half of the time: the other is for what is made instead if that was not enough.
        const auto now = std::chrono::steady_clock::now();
        RefineOptions within = options;
        within.deadline = now + (options.deadline - now) / 2;
        facts = {};
        RefineOptions coarse = &aim == &kAims.back() ? options : within;
        coarse.tolerance *= aim.tetrahedra;
        within.tolerance *= aim.made;
        mesh = mesh_of(body, extent, coarse, facts);
        if (facts.late || facts.full || std::chrono::steady_clock::now() >= within.deadline) continue;
        TriangleMesh made = mesh;
        facts.remeshed = remesh(body, extent, within, made);
        if (facts.remeshed && serves(made)) return made;
        facts.remeshed = false;
    }
    add_normals(body, extent, options, mesh);
    serves(mesh);
    return mesh;
}

}  // namespace solid
