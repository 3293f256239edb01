#include "render/solid/mesh/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace solid {
namespace {

std::uint32_t root(std::vector<std::uint32_t>& above, std::uint32_t v)
{
    while (above[v] != v) v = above[v] = above[above[v]];
    return v;
}

void check_edges(const TriangleMesh& mesh, MeshCheck& out)
{
    // Each edge once there and once back.
    struct Side {
        std::uint64_t edge;
        bool upward;
        bool operator<(const Side& other) const { return edge < other.edge; }
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            sides.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), a < b});
        }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t next = i;
        std::size_t upward = 0;
        for (; next < sides.size() && sides[next].edge == sides[i].edge; ++next) upward += sides[next].upward ? 1 : 0;
        if (next - i > 2) ++out.crowded_edges;
        else if (next - i != 2 || upward != 1) ++out.open_edges;
        i = next;
    }
}

void check_vertices(const TriangleMesh& mesh, MeshCheck& out)
{
    // About each vertex: from one neighbour to the next; the way has to come back after all of them.
    struct Corner {
        std::uint32_t vertex, from, to;
    };
    std::vector<Corner> corners;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) corners.push_back({t[k], t[(k + 1) % 3], t[(k + 2) % 3]});
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
        return a.vertex != b.vertex ? a.vertex < b.vertex : a.from < b.from;
    });
    for (std::size_t i = 0; i < corners.size();) {
        std::size_t end = i;
        while (end < corners.size() && corners[end].vertex == corners[i].vertex) ++end;
        std::size_t steps = 0;
        std::uint32_t at = corners[i].from;
        const auto first = corners.begin() + static_cast<std::ptrdiff_t>(i),
                   last = corners.begin() + static_cast<std::ptrdiff_t>(end);
        do {
            const auto next =
                std::lower_bound(first, last, at, [](const Corner& c, std::uint32_t from) { return c.from < from; });
            if (next == last || next->from != at) break;
            at = next->to;
            ++steps;
        } while (at != corners[i].from && steps <= end - i);
        if (steps != end - i || at != corners[i].from) ++out.crowded_vertices;
        i = end;
    }
}

}  // namespace

MeshCheck check(const TriangleMesh& mesh)
{
    MeshCheck out;
    std::vector<std::uint32_t> above(mesh.vertices.size());
    std::iota(above.begin(), above.end(), 0u);
    out.least_height = std::numeric_limits<double>::infinity();
    glm::dvec3 middle(0.0);
    for (const glm::vec3& v : mesh.vertices) middle += glm::dvec3(v) / static_cast<double>(mesh.vertices.size());
    for (const auto& t : mesh.triangles) {
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) ++out.collapsed;
        const glm::dvec3 a = glm::dvec3(mesh.vertices[t[0]]) - middle, b = glm::dvec3(mesh.vertices[t[1]]) - middle,
                         c = glm::dvec3(mesh.vertices[t[2]]) - middle;
        out.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        const double area = glm::length(glm::cross(b - a, c - a));
        out.surface += 0.5 * area;
        const double side = std::max(glm::length(b - a), std::max(glm::length(c - b), glm::length(a - c)));
        out.least_height = std::min(out.least_height, side > 0.0 ? area / side : 0.0);
        above[root(above, t[0])] = root(above, t[1]);
        above[root(above, t[1])] = root(above, t[2]);
    }
    for (std::uint32_t v = 0; v < above.size(); ++v) out.parts += root(above, v) == v ? 1 : 0;
    std::vector<std::array<float, 3>> places;
    for (const glm::vec3& v : mesh.vertices) places.push_back({v.x, v.y, v.z});
    std::sort(places.begin(), places.end());
    for (std::size_t i = 1; i < places.size(); ++i) out.twin_vertices += places[i] == places[i - 1] ? 1 : 0;
    check_edges(mesh, out);
    check_vertices(mesh, out);
    return out;
}

std::string MeshCheck::complaint() const
{
    std::string out;
    const auto tell = [&](std::size_t count, const char* what) {
        if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, what);
    };
    tell(open_edges, "open edges");
    tell(crowded_edges, "edges of more than two triangles");
    tell(crowded_vertices, "vertices whose triangles are no ring");
    tell(twin_vertices, "vertices in the place of another");
    tell(collapsed, "triangles of two vertices");
    if (parts == 0) out += "no triangles";
    return out;
}

}  // namespace solid
