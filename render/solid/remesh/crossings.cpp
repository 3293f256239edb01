#include "render/solid/remesh/crossings.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace solid {
namespace {

constexpr double kInsideOf = 1e-6;  // of a triangle's area: vertices are in single precision
constexpr std::size_t kOfLeaf = 4;  // triangles
constexpr std::size_t kOfThread = 64;

using Corners = std::array<glm::dvec3, 3>;

bool pierces(const Corners& a, const Corners& b)
{
    const glm::dvec3 n = glm::cross(b[1] - b[0], b[2] - b[0]);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 p = a[k], q = a[(k + 1) % 3];
        const double dp = glm::dot(p - b[0], n), dq = glm::dot(q - b[0], n);
        if (dp * dq >= 0.0) continue;
        const glm::dvec3 x = p + (q - p) * (dp / (dp - dq));
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t m = 0; m < 3; ++m)
            least = std::min(least, glm::dot(n, glm::cross(b[(m + 1) % 3] - b[m], x - b[m])));
        if (least > kInsideOf * glm::dot(n, n)) return true;
    }
    return false;
}

struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};
    void add(const glm::vec3& p)
    {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    bool meets(const Bounds& other) const
    {
        return glm::all(glm::lessThanEqual(low, other.high)) && glm::all(glm::lessThanEqual(other.low, high));
    }
};

/// Boxes about boxes, halved at the median of the longest side.
class BoxTree {
public:
    explicit BoxTree(const TriangleMesh& mesh)
    {
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            order_.push_back(i);
            Bounds own;
            for (const std::uint32_t v : mesh.triangles[i]) own.add(mesh.vertices[v]);
            boxes.push_back(own);
        }
        build(0, order_.size());
    }

    /// f(i) for the triangles whose box meets a box.
    template <class F>
    void each_near(const Bounds& box, F&& f) const
    {
        std::vector<std::uint32_t> waiting{0};
        while (!waiting.empty()) {
            const Node& node = nodes_[waiting.back()];
            const std::uint32_t left = waiting.back() + 1;
            waiting.pop_back();
            if (!node.box.meets(box)) continue;
            if (node.right == 0) {
                for (std::size_t i = node.first; i < node.end; ++i)
                    if (boxes[order_[i]].meets(box)) f(order_[i]);
            } else {
                waiting.push_back(node.right);
                waiting.push_back(left);
            }
        }
    }

    std::vector<Bounds> boxes;  ///< by triangle

private:
    struct Node {
        Bounds box;
        std::uint32_t right = 0;  ///< 0: a leaf
        std::size_t first = 0, end = 0;
    };

    void build(std::size_t first, std::size_t end)
    {
        const std::size_t at = nodes_.size();
        nodes_.emplace_back();
        Bounds all;
        for (std::size_t i = first; i < end; ++i) {
            all.add(boxes[order_[i]].low);
            all.add(boxes[order_[i]].high);
        }
        nodes_[at].box = all;
        nodes_[at].first = first;
        nodes_[at].end = end;
        if (end - first <= kOfLeaf) return;
        const glm::vec3 wide = all.high - all.low;
        const int axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
        const std::size_t middle = (first + end) / 2;
        const auto place = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(place(first), place(middle), place(end), [&](std::uint32_t a, std::uint32_t b) {
            const float p = boxes[a].low[axis] + boxes[a].high[axis], q = boxes[b].low[axis] + boxes[b].high[axis];
            return p != q ? p < q : a < b;
        });
        build(first, middle);
        nodes_[at].right = static_cast<std::uint32_t>(nodes_.size());
        build(middle, end);
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

std::size_t crossings(const TriangleMesh& mesh)
{
    if (mesh.triangles.empty()) return 0;
    const BoxTree tree(mesh);
    const auto corners = [&](std::uint32_t i) {
        const auto& t = mesh.triangles[i];
        return Corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    };
    std::atomic<std::size_t> found{0};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh.triangles.size(), kOfThread), [&](const auto& range) {
        for (std::size_t at = range.begin(); at < range.end(); ++at) {
            const auto i = static_cast<std::uint32_t>(at);
            const auto& own = mesh.triangles[i];
            tree.each_near(tree.boxes[i], [&](std::uint32_t k) {
                const auto& other = mesh.triangles[k];
                if (k <= i || std::find_first_of(own.begin(), own.end(), other.begin(), other.end()) != own.end())
                    return;
                if (pierces(corners(i), corners(k)) || pierces(corners(k), corners(i))) ++found;
            });
        }
    });
    return found;
}

}  // namespace solid
