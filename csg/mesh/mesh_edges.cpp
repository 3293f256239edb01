#include "csg/mesh/mesh_edges.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace csg {
namespace {

constexpr std::uint32_t kNone = MeshInput::kNone;

/// Cells of 5e-7 of the mesh's size: single precision and the rounding of a seam (sin of 2 pi) are smaller. Round
/// numbers lie in the middle of their cells.
double cell_size(std::span<const glm::dvec3> vertices)
{
    double largest = 0.0;
    for (const glm::dvec3& p : vertices)
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(p[axis]) < kInfinity) largest = std::max(largest, std::abs(p[axis]));
    return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest) - 21) : 1.0;
}

/// A cell's number along each axis: below 2^22, but for what is infinite or no number.
std::array<std::int32_t, 3> cell_of(const glm::dvec3& p, double per_unit)
{
    constexpr double kFarthestCell = 1 << 30;
    std::array<std::int32_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
        const double v = std::round(p[axis] * per_unit);
        if (v == v)
            cell[static_cast<std::size_t>(axis)] =
                static_cast<std::int32_t>(std::clamp(v, -kFarthestCell, kFarthestCell));
    }
    return cell;
}

std::size_t mixed(const std::array<std::int32_t, 3>& cell)
{
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15u;
    std::uint64_t h = (static_cast<std::uint32_t>(cell[0]) | std::uint64_t{static_cast<std::uint32_t>(cell[1])} << 32);
    h *= kOdd;
    h ^= h >> 29;
    h = (h + static_cast<std::uint32_t>(cell[2])) * kOdd;
    return static_cast<std::size_t>(h >> 20);
}

/// For every vertex the first that lies at the same place.
std::vector<std::uint32_t> merged_vertices(std::span<const glm::dvec3> vertices)
{
    const double per_unit = 1.0 / cell_size(vertices);  // a power of two
    std::vector<std::array<std::int32_t, 3>> cells;
    cells.reserve(vertices.size());
    for (const glm::dvec3& p : vertices) cells.push_back(cell_of(p, per_unit));
    std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 2), kNone), merged(vertices.size());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        std::size_t at = mixed(cells[i]) & (table.size() - 1);
        while (table[at] != kNone && cells[table[at]] != cells[i]) at = (at + 1) & (table.size() - 1);
        if (table[at] == kNone) table[at] = i;
        merged[i] = table[at];
    }
    return merged;
}

}  // namespace

MeshEdges edges_of(std::span<const glm::dvec3> vertices, std::span<const std::array<std::uint32_t, 3>> faces)
{
    const std::vector<std::uint32_t> merged = merged_vertices(vertices);
    // Edges by their lower vertex: of each the upper one, with the way that its face goes in the lowest bit.
    std::vector<std::size_t> end(vertices.size() + 1, 0);
    const auto each = [&](auto&& take) {
        for (const auto& face : faces)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = merged[face[k]], b = merged[face[(k + 1) % 3]];
                if (a != b) take(std::min(a, b), std::max(a, b), a < b);
            }
    };
    each([&](std::uint32_t low, std::uint32_t, bool) { ++end[low + 1]; });
    for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
    std::vector<std::uint64_t> edges(end.back());
    std::vector<std::size_t> next(end.begin(), end.end() - 1);
    each([&](std::uint32_t low, std::uint32_t high, bool up) { edges[next[low]++] = std::uint64_t{high} << 1 | up; });
    MeshEdges out;
    for (std::uint32_t low = 0; low < vertices.size(); ++low) {
        const auto first = edges.begin() + static_cast<std::ptrdiff_t>(end[low]),
                   last = edges.begin() + static_cast<std::ptrdiff_t>(end[low + 1]);
        std::sort(first, last);
        for (auto at = first; at != last;) {
            const std::uint64_t high = *at >> 1;
            std::size_t count = 0, up = 0;
            for (; at != last && *at >> 1 == high; ++at) ++count, up += *at & 1;
            if (count % 2 != 0) out.open.push_back({low, static_cast<std::uint32_t>(high)});
            if (2 * up != count) out.oriented = false;
        }
    }
    return out;
}

std::vector<std::array<std::uint32_t, 2>> open_edges(const MeshInput& input)
{
    std::vector<std::array<std::uint32_t, 3>> faces;
    faces.reserve(input.faces.size());
    for (const MeshInput::Face& face : input.faces) faces.push_back(face.vertex);
    return edges_of(input.vertices, faces).open;
}

}  // namespace csg
