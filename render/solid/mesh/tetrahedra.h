#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace solid {

using Tetrahedron = std::array<std::uint32_t, 4>;

/// The ends of an edge of tetrahedra, the smaller number first.
constexpr std::uint64_t edge_key(std::uint32_t a, std::uint32_t b)
{
    return a < b ? (std::uint64_t(a) << 32) | b : (std::uint64_t(b) << 32) | a;
}
constexpr std::uint32_t first_of(std::uint64_t edge) { return static_cast<std::uint32_t>(edge >> 32); }
constexpr std::uint32_t second_of(std::uint64_t edge) { return static_cast<std::uint32_t>(edge); }

struct KeyHash {
    std::size_t operator()(std::uint64_t key) const
    {
        key ^= key >> 32;
        key *= 0x9e3779b97f4a7c15u;
        return key ^ (key >> 29);
    }
};

/// The pairs of a tetrahedron's corners.
inline constexpr std::array<std::array<int, 2>, 6> kEdges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Space in tetrahedra that meet face to face. An edge may be split anywhere: all tetrahedra about it are split with
/// it, so they go on meeting face to face.
struct Tetrahedra {
    std::vector<glm::dvec3> points;
    std::vector<std::uint8_t> inside;  ///< by point: of the body
    std::vector<Tetrahedron> all;      ///< corners in an order of positive volume; parts of one keep it, however flat

    /// Splits every tetrahedron at those of its edges that are keys of `middles`, whose values are the new points. Of
    /// several edges of one the longest comes first: on a face that two share both split it alike. The tetrahedra that
    /// are new are appended to `made`, as indices into `all`.
    void split(const std::unordered_map<std::uint64_t, std::uint32_t, KeyHash>& middles,
               std::vector<std::uint32_t>& made);

    double length2(std::uint64_t edge) const
    {
        const glm::dvec3 d = points[second_of(edge)] - points[first_of(edge)];
        return glm::dot(d, d);
    }
    std::uint64_t longest_edge(const Tetrahedron& t) const;

    std::vector<std::uint8_t> touched_;  ///< by point: end of an edge that is split
};

/// A lattice of cubes of one size, each in six tetrahedra about its diagonal (Kuhn's subdivision): edges run along
/// seven directions.
struct Lattice {
    glm::dvec3 origin{0.0};
    double step = 1.0;
    std::array<int, 3> cubes{1, 1, 1};

    std::uint32_t corner(int x, int y, int z) const
    {
        return static_cast<std::uint32_t>((z * (cubes[1] + 1) + y) * (cubes[0] + 1) + x);
    }
    glm::dvec3 place(int x, int y, int z) const { return origin + step * glm::dvec3(x, y, z); }
    bool holds(int x, int y, int z) const
    {
        return x >= 0 && y >= 0 && z >= 0 && x <= cubes[0] && y <= cubes[1] && z <= cubes[2];
    }
    Tetrahedra tetrahedra() const;
};

}  // namespace solid
