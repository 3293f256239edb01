#pragma once

#include "csg/base/cancel.h"
#include "render/solid/remesh/foot.h"
#include "render/solid/remesh/half_edges.h"
#include "render/solid/mesh/refinement.h"

#include <tbb/parallel_for.h>

namespace solid {

/// The steps of remesh(). Rays are asked by threads, each for its own vertex or triangle; connections are changed one
/// after the other in the order of numbers: the same mesh for any number of threads.
class Remesher {
public:
    using Index = HalfEdges::Index;

    Remesher(const Body& body, const csg::Aabb& extent, const RefineOptions& options);

    bool take(const TriangleMesh& mesh);
    /// Finds what the surface is like about the triangles, and its sharp edges.
    void look_at_surface();
    /// False where it needs many more triangles than there were, as something about the surface is not understood, or
    /// more time than there is.
    bool run();
    /// Whether a triangle looks away from the surface: the cosine between it and the surface's normal is less.
    bool any_folded(double cosine) const { return !folded(cosine).empty(); }
    TriangleMesh result() const;

private:
    enum class Kind : std::uint8_t { Smooth, Crease, Corner };

    /// \name surface.cpp: what the surface is like
    void find_facing();
    void ask_neighbours(std::vector<std::uint8_t>& told);
    SurfacePoint foot_on_side(Index f, const glm::dvec3& normal) const;
    void find_sharp();
    void tidy_sharp();
    bool straighten(Index f);
    bool unpinch(Index v);
    void follow_edge(Index v);
    void take_side(Index f, const glm::dvec3& normal);
    int sharp_edges(Index v) const;
    void count_sharp(std::vector<std::uint8_t>& counts) const;
    void find_kinds();
    void find_lengths();
    void grade_lengths();
    void face_again();
    /// Shortens lengths where triangles are off or face away; how many.
    std::size_t look_for_misfits();
    std::size_t sides_of(Index v, std::array<Side, 16>& out) const;

    /// \name steps.cpp: connections
    bool is_longest(Index h) const;
    std::size_t split_long();
    std::size_t collapse_short();
    /// Of some edges, and of those about what was flipped.
    std::size_t flip_better(std::vector<Index> waiting);
    std::size_t unfold();
    void flip_to_face();
    bool may_collapse(Index h, bool unfolding) const;
    bool may_flip(Index h) const;

    /// \name what changed: a step that found nothing to do for a triangle need not ask again until it changes
    enum Step : std::uint8_t { kFace = 1, kSplit = 2, kFlip = 4, kCollapse = 8, kMove = 16, kAllSteps = 31 };
    void touch(Index f) { fresh_[f] = kAllSteps; }
    void touch_about(Index v)
    {
        mesh_.each_out(v, [&](Index h) { touch(h / 3); });
    }
    void touch_all() { fresh_.assign(mesh_.triangles(), kAllSteps); }
    void seen_by(Step step)
    {
        for (std::uint8_t& f : fresh_) f = static_cast<std::uint8_t>(f & ~step);
    }
    /// Of edges that a step is to look at, which has seen them then.
    std::vector<Index> edges_for(Step step);

    /// \name mend.cpp: folds that no step unfolds
    std::vector<Index> folded(double cosine) const;
    /// How many of them were cut out.
    std::size_t mend(const std::vector<Index>& folded);
    bool fill_hole(const std::vector<Index>& triangles, const std::vector<Index>& rim,
                   const std::vector<std::uint32_t>& cut);

    /// \name moves.cpp: places
    struct Move {
        bool found = false;
        glm::dvec3 place{0.0}, normal{0.0};
    };
    Move moved(Index v, const glm::dvec3& to, std::size_t steps = kExactSteps) const;
    Move beside(Index v) const;
    glm::dvec3 wanted_place(Index v) const;
    bool may_move(Index v, const glm::dvec3& to) const;
    bool is_placed(Index v) const;
    void put(Index v, const Move& move);
    void move_all(bool smooth);
    void settle(bool all);

    /// \name corner_normals.cpp: normals for the files
    glm::dvec3 side_normal(Index v, Index f) const;
    void corner_normals(std::vector<glm::vec3>& normals, std::vector<Index>& of_corner) const;

    /// \name what triangles are like
    glm::dvec3 cross_at(Index f) const;
    bool is_sliver(Index f) const;
    glm::dvec3 middle_of(Index f) const;
    double longest_side(Index f) const;
    double length(Index h) const { return glm::length(mesh_.places[mesh_.head(h)] - mesh_.places[mesh_.tail(h)]); }
    double shortest_edge(Index v) const;
    double wanted_length(Index h) const { return std::min(lengths_[mesh_.tail(h)], lengths_[mesh_.head(h)]); }

    /// f(i) for i below `count`, by threads.
    template <class F>
    void each(std::size_t count, F&& f) const
    {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kPartsOfTask), [&](const auto& range) {
            if (options_.cancel != nullptr && *options_.cancel) throw csg::Cancelled();
            for (std::size_t i = range.begin(); i < range.end(); ++i) f(static_cast<Index>(i));
        });
    }

    const Body& body_;
    const RefineOptions& options_;
    double size_ = 1.0;   ///< longest side of the extent
    double off_ = 0.0;    ///< triangles may be so far from the surface
    double least_ = 0.0;  ///< edges are not made shorter
    HalfEdges mesh_;
    std::size_t most_triangles_ = 0;
    bool overrun_ = false;               ///< there would be more, or it is late
    std::vector<SurfacePoint> feet_;     ///< by triangle, of its middle
    std::vector<glm::dvec3> fitting_;    ///< by triangle: its middle, when it was found to fit
    std::vector<Kind> kinds_;            ///< by vertex
    std::vector<std::uint8_t> fresh_;    ///< by triangle: steps that have not looked at it since it changed
    std::vector<std::uint8_t> on_edge_;  ///< by vertex: whether it was put on its sharp edge or corner
    std::vector<double> lengths_;        ///< by vertex: of edges about it
    std::vector<glm::dvec3> normals_;    ///< by vertex, of smooth ones that lie on the surface; else 0
};

/// Twice a triangle's area along its normal.
inline glm::dvec3 cross_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    return glm::cross(b - a, c - a);
}

/// The cosine between a triangle's normal, told by its cross product, and a unit vector; -1 of one without area.
double facing_of(const glm::dvec3& cross, const glm::dvec3& facing);

/// The cosine of a triangle's least angle; -1 of one without area.
double sharpest_cosine(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace solid
