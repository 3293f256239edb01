#pragma once

#include "render/solid/mesh/tetrahedra.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace solid {

/// A plane in triangles that meet edge to edge: what Tetrahedra are in space.
struct PlaneTriangles {
    using Triangle = std::array<std::uint32_t, 3>;
    using Middles = std::unordered_map<std::uint64_t, std::uint32_t, KeyHash>;
    using Shares = std::unordered_map<std::uint64_t, double, KeyHash>;

    std::vector<glm::dvec3> points;
    std::vector<std::uint8_t> inside;  ///< by point: of the body
    std::vector<Triangle> all;         ///< counter-clockwise in the drawing; parts of one keep that

    /// Adds to `marked` (an edge, and where it is split as a share of it) the longest edge of every triangle of which
    /// any edge is marked (Rivara's bisection): so no angle gets narrower from round to round.
    void spread(Shares& marked) const;

    /// Splits all triangles at those of their edges that are keys of `middles`, whose values are the new points. New
    /// triangles are appended to `made`, as indices into `all`.
    void split(const Middles& middles, std::vector<std::uint32_t>& made);

    double length2(std::uint64_t edge) const
    {
        const glm::dvec3 d = points[second_of(edge)] - points[first_of(edge)];
        return glm::dot(d, d);
    }
    std::uint64_t longest_edge(const Triangle& t) const;

private:
    void split_one(std::uint32_t i, const Middles& middles, std::vector<std::uint32_t>& made);
};

}  // namespace solid
