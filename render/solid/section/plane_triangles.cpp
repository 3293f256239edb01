#include "render/solid/section/plane_triangles.h"

namespace solid {
namespace {

std::uint64_t triangle_side(const PlaneTriangles::Triangle& t, std::size_t k) { return edge_key(t[k], t[(k + 1) % 3]); }

}  // namespace

std::uint64_t PlaneTriangles::longest_edge(const Triangle& t) const
{
    std::uint64_t best = triangle_side(t, 0);
    for (std::size_t k = 1; k < 3; ++k) {
        const std::uint64_t edge = triangle_side(t, k);
        const double mine = length2(edge), most = length2(best);
        if (mine > most || (mine == most && edge > best)) best = edge;  // of equal ones all triangles choose the same
    }
    return best;
}

void PlaneTriangles::spread(Shares& marked) const
{
    std::vector<std::uint8_t> touched(points.size());
    for (const auto& [edge, share] : marked) touched[first_of(edge)] = touched[second_of(edge)] = 1;
    for (bool more = true; more;) {
        more = false;
        for (const Triangle& t : all) {
            if (touched[t[0]] + touched[t[1]] + touched[t[2]] < 2) continue;
            if (!marked.contains(triangle_side(t, 0)) && !marked.contains(triangle_side(t, 1)) &&
                !marked.contains(triangle_side(t, 2)))
                continue;
            const std::uint64_t longest = longest_edge(t);
            if (!marked.try_emplace(longest, 0.5).second) continue;
            touched[first_of(longest)] = touched[second_of(longest)] = 1;
            more = true;
        }
    }
}

void PlaneTriangles::split_one(std::uint32_t i, const Middles& middles, std::vector<std::uint32_t>& made)
{
    const Triangle t = all[i];
    std::size_t best = 3;
    for (std::size_t k = 0; k < 3; ++k)
        if (middles.contains(triangle_side(t, k)) &&
            (best == 3 || length2(triangle_side(t, k)) > length2(triangle_side(t, best))))
            best = k;
    if (best == 3) return;
    const std::uint32_t a = t[best], b = t[(best + 1) % 3], c = t[(best + 2) % 3], m = middles.at(edge_key(a, b));
    const auto other = static_cast<std::uint32_t>(all.size());
    all[i] = {a, m, c};
    all.push_back({m, b, c});
    made.push_back(i);
    made.push_back(other);
    split_one(i, middles, made);
    split_one(other, middles, made);
}

void PlaneTriangles::split(const Middles& middles, std::vector<std::uint32_t>& made)
{
    std::vector<std::uint8_t> touched(points.size());
    for (const auto& [edge, middle] : middles) touched[first_of(edge)] = touched[second_of(edge)] = 1;
    const std::size_t before = all.size();
    for (std::size_t i = 0; i < before; ++i)
        if (touched[all[i][0]] + touched[all[i][1]] + touched[all[i][2]] >= 2)
            split_one(static_cast<std::uint32_t>(i), middles, made);
}

}  // namespace solid
