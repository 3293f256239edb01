#pragma once

#include "render/solid/mesh/triangle_mesh.h"

namespace solid {

/// A closed, oriented mesh of triangles whose connections may be changed. Half-edge h is a side of triangle h / 3; it
/// runs from tail(h) to head(h), counter-clockwise as seen from outside (Botsch, Kobbelt, Pauly, Alliez and Lévy,
/// Polygon Mesh Processing, 2010, chapter 2).
class HalfEdges {
public:
    using Index = std::uint32_t;
    static constexpr Index kNone = 0xffffffffu;

    /// False where the triangles do not close or an edge has more than two.
    bool take(const TriangleMesh& mesh);
    /// What is left, in its order.
    TriangleMesh mesh() const;

    std::size_t vertices() const { return places.size(); }
    std::size_t triangles() const { return tails_.size() / 3; }
    std::size_t alive() const { return alive_; }  ///< triangles that were not collapsed
    bool has_vertex(Index v) const { return outs_[v] != kNone; }
    bool has_triangle(Index f) const { return tails_[3 * f] != kNone; }
    static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static Index before(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
    Index tail(Index h) const { return tails_[h]; }
    Index head(Index h) const { return tails_[next(h)]; }
    Index twin(Index h) const { return twins_[h]; }
    Index first_out(Index v) const { return outs_[v]; }
    /// The next half-edge out of the same vertex.
    Index around(Index h) const { return twins_[before(h)]; }
    bool is_sharp(Index h) const { return sharp_[h] != 0; }
    void set_sharp(Index h, bool sharp) { sharp_[h] = sharp_[twins_[h]] = sharp ? 1 : 0; }

    /// f(h) for the half-edges out of a vertex.
    template <class F>
    void each_out(Index v, F&& f) const
    {
        Index h = outs_[v];
        do {
            f(h);
            h = around(h);
        } while (h != outs_[v]);
    }
    int neighbours(Index v) const;

    /// Whether an edge may turn within its two triangles without another in its place.
    bool can_flip(Index h) const;
    void flip(Index h);
    /// A new vertex on an edge, numbered last; its four triangles.
    Index split(Index h, const glm::dvec3& place);
    /// Whether the mesh stays a closed surface if the tail of an edge is put into its head (Dey, Edelsbrunner, Guha and
    /// Nekhayev, Topology preserving edge contraction, 1999).
    bool can_collapse(Index h) const;
    void collapse(Index h);
    /// A vertex without triangles, numbered last.
    void add_vertex(const glm::dvec3& place);
    /// Puts triangles in the place of others that have the same rim; the first of them. Edges between them are not
    /// sharp.
    Index replace(const std::vector<Index>& old, const std::vector<std::array<Index, 3>>& made,
                  const std::vector<glm::dvec3>& looks);

    std::vector<glm::dvec3> places;  ///< by vertex
    std::vector<glm::dvec3> facing;  ///< by triangle: the surface's normal about there

private:
    void join(Index a, Index b)
    {
        twins_[a] = b;
        twins_[b] = a;
    }

    std::size_t alive_ = 0;
    std::vector<Index> tails_, twins_;  ///< by half-edge
    std::vector<std::uint8_t> sharp_;   ///< by half-edge
    std::vector<Index> outs_;           ///< by vertex: a half-edge out of it
};

}  // namespace solid
