#include "render/solid/mesh/sides.h"

#include <algorithm>

namespace solid {
namespace {

FaceKey face_key(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    FaceKey key{a, b, c};
    std::sort(key.begin(), key.end());
    return key;
}

}  // namespace

Sides sides_of(const Tetrahedron& t, const std::vector<std::uint8_t>& inside)
{
    std::array<std::uint32_t, 4> in{}, other{};
    std::size_t ins = 0, outs = 0;
    for (const std::uint32_t v : t) (inside[v] != 0 ? in[ins++] : other[outs++]) = v;
    if (ins == 2) return {false, {in[0], in[1], other[0], other[1]}};
    if (ins == 1) return {true, {in[0], other[0], other[1], other[2]}};
    return {true, {other[0], in[0], in[1], in[2]}};
}

std::array<std::uint64_t, 4> edges_of(const Sides& sides)
{
    const auto& [a, b, c, d] = sides.order;
    if (sides.lone) return {edge_key(a, b), edge_key(a, c), edge_key(a, d), 0};
    return {edge_key(a, c), edge_key(a, d), edge_key(b, d), edge_key(b, c)};
}

std::size_t faces_of(const Sides& sides, std::array<FaceKey, 4>& keys)
{
    const auto& [a, b, c, d] = sides.order;
    if (sides.lone) keys = {face_key(a, b, c), face_key(a, c, d), face_key(a, d, b), FaceKey{}};
    else keys = {face_key(a, c, d), face_key(a, b, d), face_key(b, c, d), face_key(a, b, c)};
    return sides.lone ? 3 : 4;
}

bool is_turned(const Sides& sides, const Tetrahedron& t, const std::vector<std::uint8_t>& inside)
{
    // Positive volume in the order of `sides`? By exchanges, not by numbers: it may be very flat.
    int exchanges = 0;
    Tetrahedron order = t;
    for (std::size_t i = 0; i < 4; ++i)
        if (order[i] != sides.order[i]) {
            std::iter_swap(order.begin() + static_cast<std::ptrdiff_t>(i),
                           std::find(order.begin(), order.end(), sides.order[i]));
            ++exchanges;
        }
    const bool positive = exchanges % 2 == 0;
    return sides.lone ? positive != (inside[sides.order[0]] != 0) : !positive;
}

}  // namespace solid
