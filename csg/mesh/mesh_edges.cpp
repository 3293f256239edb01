#include "csg/mesh/mesh_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace csg {
namespace {

/// Cells of 5e-7 of the mesh's size: single precision and the rounding of a seam (sin of 2 pi) are smaller. Round
/// numbers lie in the middle of their cells.
double cell_size(const MeshInput& input)
{
    double largest = 0.0;
    for (const glm::dvec3& p : input.vertices)
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(p[axis]) < kInfinity) largest = std::max(largest, std::abs(p[axis]));
    return largest > 0.0 ? std::ldexp(1.0, std::ilogb(largest) - 21) : 1.0;
}

/// For every vertex the first that lies at the same place.
std::vector<std::uint32_t> merged_vertices(const MeshInput& input)
{
    const double cell = cell_size(input);
    std::vector<std::uint32_t> order(input.vertices.size()), merged(input.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        std::array<double, 3> p{};
        for (int axis = 0; axis < 3; ++axis) {
            const double v = std::round(input.vertices[i][axis] / cell);
            if (v == v) p[static_cast<std::size_t>(axis)] = v;  // what is not a number would upset the order
        }
        return p;
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i)
        merged[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? merged[order[i - 1]] : order[i];
    return merged;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> open_edges(const MeshInput& input)
{
    const std::vector<std::uint32_t> merged = merged_vertices(input);
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * input.faces.size());
    for (const MeshInput::Face& face : input.faces)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t a = merged[face.vertex[k]], b = merged[face.vertex[(k + 1) % 3]];
            if (a != b) edges.push_back(std::min(a, b) << 32 | std::max(a, b));
        }
    std::sort(edges.begin(), edges.end());
    std::vector<std::array<std::uint32_t, 2>> open;
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        while (end < edges.size() && edges[end] == edges[i]) ++end;
        if ((end - i) % 2 != 0)
            open.push_back({static_cast<std::uint32_t>(edges[i] >> 32), static_cast<std::uint32_t>(edges[i])});
        i = end;
    }
    return open;
}

}  // namespace csg
