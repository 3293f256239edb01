#include "render/solid/mesh/tetrahedra.h"

#include <algorithm>

namespace solid {

std::uint64_t Tetrahedra::longest_edge(const Tetrahedron& t) const
{
    std::uint64_t best = 0;
    double longest = -1.0;
    for (const auto& [i, j] : kEdges) {
        const std::uint64_t key = edge_key(t[static_cast<std::size_t>(i)], t[static_cast<std::size_t>(j)]);
        const double own = length2(key);
        if (own > longest || (own == longest && key < best)) {
            longest = own;
            best = key;
        }
    }
    return best;
}

void Tetrahedra::split(const std::unordered_map<std::uint64_t, std::uint32_t, KeyHash>& middles,
                       std::vector<std::uint32_t>& made)
{
    touched_.assign(points.size(), 0);
    for (const auto& [edge, middle] : middles) touched_[first_of(edge)] = touched_[second_of(edge)] = 1;
    // The edge of a tetrahedron that is split first; false: none is.
    const auto first_edge = [&](const Tetrahedron& t, std::array<int, 2>& out, std::uint32_t& middle) {
        double longest = -1.0;
        std::uint64_t best = 0;
        for (const auto& edge : kEdges) {
            const std::uint32_t a = t[static_cast<std::size_t>(edge[0])], b = t[static_cast<std::size_t>(edge[1])];
            if (touched_[a] == 0 || touched_[b] == 0) continue;
            const std::uint64_t key = edge_key(a, b);
            const auto found = middles.find(key);
            if (found == middles.end()) continue;
            const double own = length2(key);
            if (own > longest || (own == longest && key < best)) {
                longest = own;
                best = key;
                out = edge;
                middle = found->second;
            }
        }
        return longest >= 0.0;
    };
    std::vector<Tetrahedron> waiting;
    const std::size_t before = all.size();
    for (std::size_t i = 0; i < before; ++i) {
        std::array<int, 2> edge{};
        std::uint32_t middle = 0;
        if (!first_edge(all[i], edge, middle)) continue;
        waiting.assign(1, all[i]);
        bool in_place = true;
        while (!waiting.empty()) {
            const Tetrahedron t = waiting.back();
            waiting.pop_back();
            if (!first_edge(t, edge, middle)) {
                if (in_place) all[i] = t;
                else all.push_back(t);
                made.push_back(static_cast<std::uint32_t>(in_place ? i : all.size() - 1));
                in_place = false;
                continue;
            }
            for (const int end : edge) {
                Tetrahedron half = t;
                half[static_cast<std::size_t>(end)] = middle;
                waiting.push_back(half);
            }
        }
    }
}

Tetrahedra Lattice::tetrahedra() const
{
    Tetrahedra out;
    const auto [nx, ny, nz] = cubes;
    for (int z = 0; z <= nz; ++z)
        for (int y = 0; y <= ny; ++y)
            for (int x = 0; x <= nx; ++x) out.points.push_back(place(x, y, z));
    out.inside.assign(out.points.size(), 0);
    constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    out.all.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) * static_cast<std::size_t>(nz) * 6);
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                for (const auto& order : kOrders) {
                    std::array<int, 3> at{x, y, z};
                    Tetrahedron t{corner(x, y, z)};
                    for (std::size_t k = 0; k < 3; ++k) {
                        ++at[static_cast<std::size_t>(order[k])];
                        t[k + 1] = corner(at[0], at[1], at[2]);
                    }
                    // All turn the same way, and so do their parts.
                    const auto& [i, j, k] = order;
                    if ((((i > j) + (i > k) + (j > k)) & 1) != 0) std::swap(t[2], t[3]);
                    out.all.push_back(t);
                }
    return out;
}

}  // namespace solid
