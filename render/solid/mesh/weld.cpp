#include "render/solid/mesh/weld.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace solid {
namespace {

constexpr std::uint32_t kGone = 0xffffffffu;

/// Triangles about the vertices that matter here, kept up to date.
class Joiner {
public:
    Joiner(TriangleMesh& mesh, const std::vector<std::uint32_t>& vertices) : mesh_(mesh)
    {
        std::vector<std::uint8_t> matters(mesh.vertices.size());
        for (const std::uint32_t v : vertices) matters[v] = 1;
        // And their neighbours, whose rings the joins change.
        std::vector<std::uint8_t> near = matters;
        for (const auto& t : mesh.triangles)
            if ((matters[t[0]] | matters[t[1]] | matters[t[2]]) != 0) near[t[0]] = near[t[1]] = near[t[2]] = 1;
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
            for (const std::uint32_t v : mesh.triangles[i])
                if (near[v] != 0) about_[v].insert(i);
    }

    /// Puts u in the place of v, if they are neighbours with two neighbours in common.
    bool join(std::uint32_t u, std::uint32_t v)
    {
        const std::set<std::uint32_t> of_u = ring(u), of_v = ring(v);
        if (of_u.count(v) == 0) return false;
        std::vector<std::uint32_t> common;
        std::set_intersection(of_u.begin(), of_u.end(), of_v.begin(), of_v.end(), std::back_inserter(common));
        if (common.size() != 2 || of_u.size() + of_v.size() < 7) return false;
        const std::set<std::uint32_t> about_v = about_[v];
        for (const std::uint32_t i : about_v) {
            auto& t = mesh_.triangles[i];
            const bool both = std::find(t.begin(), t.end(), u) != t.end();
            if (both) {
                for (const std::uint32_t w : t) about_[w].erase(i);
                t = {kGone, kGone, kGone};
            } else {
                std::replace(t.begin(), t.end(), v, u);
                about_[u].insert(i);
            }
        }
        about_[v].clear();
        return true;
    }

private:
    std::set<std::uint32_t> ring(std::uint32_t v)
    {
        std::set<std::uint32_t> out;
        for (const std::uint32_t i : about_[v])
            for (const std::uint32_t w : mesh_.triangles[i])
                if (w != v) out.insert(w);
        return out;
    }
    TriangleMesh& mesh_;
    std::map<std::uint32_t, std::set<std::uint32_t>> about_;
};

void compact(TriangleMesh& mesh)
{
    std::erase_if(mesh.triangles, [](const auto& t) { return t[0] == kGone; });
    std::vector<std::uint32_t> now(mesh.vertices.size(), kGone);
    std::vector<glm::vec3> kept;
    for (auto& t : mesh.triangles)
        for (std::uint32_t& v : t) {
            if (now[v] == kGone) {
                now[v] = static_cast<std::uint32_t>(kept.size());
                kept.push_back(mesh.vertices[v]);
            }
            v = now[v];
        }
    mesh.vertices = std::move(kept);
}

}  // namespace

std::size_t weld(TriangleMesh& mesh)
{
    std::vector<std::uint32_t> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto place = [&](std::uint32_t v) {
        const glm::vec3& p = mesh.vertices[v];
        return std::array<float, 3>{p.x, p.y, p.z};
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto p = place(a), q = place(b);
        return p != q ? p < q : a < b;
    });
    std::vector<std::uint32_t> twins;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (place(order[i]) == place(order[i - 1])) {
            twins.push_back(order[i - 1]);
            twins.push_back(order[i]);
        }
    if (twins.empty()) return 0;
    Joiner joiner(mesh, twins);
    std::size_t joined = 0;
    for (std::size_t i = 0; i < twins.size(); i += 2) joined += joiner.join(twins[i], twins[i + 1]) ? 1 : 0;
    compact(mesh);
    return joined;
}

std::size_t drop_specks(TriangleMesh& mesh, double size)
{
    std::vector<std::uint32_t> above(mesh.vertices.size());
    std::iota(above.begin(), above.end(), 0u);
    const auto root = [&](std::uint32_t v) {
        while (above[v] != v) v = above[v] = above[above[v]];
        return v;
    };
    for (const auto& t : mesh.triangles) {
        above[root(t[0])] = root(t[1]);
        above[root(t[1])] = root(t[2]);
    }
    struct Box {
        glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};
    };
    std::map<std::uint32_t, Box> boxes;
    for (std::uint32_t v = 0; v < above.size(); ++v) {
        Box& box = boxes[root(v)];
        box.low = glm::min(box.low, mesh.vertices[v]);
        box.high = glm::max(box.high, mesh.vertices[v]);
    }
    std::set<std::uint32_t> specks;
    for (const auto& [v, box] : boxes) {
        const glm::vec3 wide = box.high - box.low;
        if (static_cast<double>(std::max(wide.x, std::max(wide.y, wide.z))) <= size) specks.insert(v);
    }
    if (specks.empty() || specks.size() == boxes.size()) return 0;
    for (auto& t : mesh.triangles)
        if (specks.count(root(t[0])) != 0) t = {kGone, kGone, kGone};
    compact(mesh);
    return specks.size();
}

}  // namespace solid
