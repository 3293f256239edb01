#pragma once

#include "render/solid/mesh/tetrahedra.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// How the boundary passes a tetrahedron: by the sides that its corners are on, without a number.
namespace solid {

/// Corners of a face, in rising order.
using FaceKey = std::array<std::uint32_t, 3>;
struct FaceHash {
    std::size_t operator()(const FaceKey& key) const
    {
        return KeyHash()((std::uint64_t(key[0]) << 32 | key[1]) * 0xff51afd7ed558ccdu + key[2]);
    }
};

/// The corner that is alone on its side and the others, or the two that are inside first.
struct Sides {
    bool lone = false;
    Tetrahedron order;
};

/// \param inside by corner: 1 where it is
Sides sides_of(const Tetrahedron& t, const std::vector<std::uint8_t>& inside);

/// The edges that the boundary passes, three or four, as they follow each other about the polygon.
std::array<std::uint64_t, 4> edges_of(const Sides& sides);

/// The faces that it passes: face k lies between edge k and the next. How many.
std::size_t faces_of(const Sides& sides, std::array<FaceKey, 4>& keys);

/// Whether edges_of() run clockwise as seen from outside.
bool is_turned(const Sides& sides, const Tetrahedron& t, const std::vector<std::uint8_t>& inside);

}  // namespace solid
