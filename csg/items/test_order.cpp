#include "csg/items/test_order.h"

#include "csg/base/hit.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace csg {
namespace {

constexpr double kInfiniteVolume = 2e10;
constexpr double kInfiniteKey = -1e7;  // of nodes that are asked first
constexpr float kLeastExit = 1e-4f;
constexpr std::size_t kFewestNodes = 4;  // nodes that are not divided
constexpr float kCostOfNode = 3.0f;
// Where each division splits off a single box, n boxes take n * n / 2 looks. After as many looks as 200 divisions into
// halves would take, the order is given up: the object declared first is then tested first.
constexpr std::size_t kWorkOfItem = 200, kLeastWork = 100000;

/// Its last bit decides between divisions that cost the same.
float half_area(const glm::vec3& edges, Roundings by)
{
    if (by == Roundings::V38) return edges.x * (edges.y + edges.z) + edges.y * edges.z;
    return edges.x * edges.y + edges.y * edges.z + edges.z * edges.x;
}

TestOrder::Box around(const TestOrder::Box& a, const TestOrder::Box& b)
{
    const glm::vec3 lower = glm::min(a.lower, b.lower);
    return {lower, glm::max(a.upper(), b.upper()) - lower};
}

/// A ray as POV-Ray's boxes know it: in single precision, but 3.7 adds an edge's length along the ray in double.
struct SingleRay {
    glm::vec3 origin, inverse;
    glm::bvec3 by_edges;

    SingleRay(const Ray& ray, Roundings by)
        : origin(ray.origin), inverse(1.0 / ray.direction),
          by_edges(glm::notEqual(ray.direction, glm::dvec3(0.0)) && glm::bvec3(by != Roundings::V38))
    {}

    /// Where it comes into the box; false: it misses it.
    bool enter(const TestOrder::Box& box, double& at) const
    {
        double from = -std::numeric_limits<double>::max(), to = std::numeric_limits<double>::max();
        for (int axis = 0; axis < 3; ++axis) {
            const double low = (box.lower[axis] - origin[axis]) * inverse[axis],
                         along = box.edges[axis] * inverse[axis],
                         high = by_edges[axis] ? low + along
                                               : (box.lower[axis] + box.edges[axis] - origin[axis]) * inverse[axis];
            from = std::max(from, std::min(low, high));
            to = std::min(to, std::max(low, high));
        }
        at = from;
        return from <= to && to >= kLeastExit;
    }
};

/// A binary heap as POV-Ray keeps it, which decides between equal keys.
class Waiting {
public:
    struct Entry {
        double key;
        std::uint32_t node;
    };

    void add(const Entry& entry)
    {
        std::size_t at = heap_.size();
        heap_.push_back(entry);
        for (; at > 1 && heap_[at / 2].key > entry.key; at /= 2) std::swap(heap_[at], heap_[at / 2]);
    }
    void clear() { heap_.resize(1); }
    bool empty() const { return heap_.size() < 2; }
    Entry take()
    {
        const Entry top = heap_[1];
        heap_[1] = heap_.back();
        heap_.pop_back();
        for (std::size_t at = 1; 2 * at < heap_.size();) {
            std::size_t child = 2 * at;
            if (child + 1 < heap_.size() && !(heap_[child].key < heap_[child + 1].key)) ++child;
            if (!(heap_[at].key > heap_[child].key)) break;
            std::swap(heap_[at], heap_[child]);
            at = child;
        }
        return top;
    }

private:
    std::vector<Entry> heap_{{0.0f, 0}};  // counted from 1
};

}  // namespace

TestOrder::Box TestOrder::Box::of(const Aabb& box)
{
    const glm::dvec3 edges = box.upper - box.lower;
    return {glm::vec3(box.lower), glm::vec3(edges), !(edges.x * edges.y * edges.z <= kInfiniteVolume)};
}

TestOrder::TestOrder(std::span<const Box> items, Roundings by, std::vector<std::uint32_t> whole)
    : by_(by), whole_(std::move(whole))
{
    Numbers finite, infinite;
    work_left_ = kWorkOfItem * items.size() + kLeastWork;
    for (const Box& box : items) {
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({.box = box, .item = number});
        (box.infinite ? infinite : finite).push_back(number);
    }
    while (finite.size() > 1 || (finite.size() == 1 && nodes_[finite[0]].item != kNone)) {
        finite = gather(finite);
        if (work_left_ == 0) return;
    }
    Numbers below;
    if (!infinite.empty()) {
        below.push_back(add_parent(infinite));
        nodes_[below[0]].box.infinite = true;
    }
    if (!finite.empty()) {
        const Node& top = nodes_[finite[0]];
        below.insert(below.end(), children_.begin() + top.first_child,
                     children_.begin() + top.first_child + top.child_count);
    }
    if (!below.empty()) root_ = add_parent(below);
}

/// Parents of all nodes.
TestOrder::Numbers TestOrder::gather(const Numbers& nodes)
{
    std::vector<Placed> all;
    all.reserve(nodes.size());
    for (const std::uint32_t node : nodes) all.push_back({nodes_[node].box, node, 0.0f});
    std::vector<std::span<Placed>> waiting{all};
    std::vector<float> areas(nodes.size());
    Numbers made, children;
    while (!waiting.empty()) {
        const std::span<Placed> part = waiting.back();
        waiting.pop_back();
        work_left_ -= std::min(work_left_, part.size());
        if (work_left_ == 0) break;
        const std::size_t left = divided(part, areas);
        if (left == 0) {
            children.clear();
            for (const Placed& child : part) children.push_back(child.node);
            made.push_back(add_parent(children));
            continue;
        }
        waiting.push_back(part.subspan(left));
        waiting.push_back(part.first(left));
    }
    return made;
}

/// Sorts nodes; gives how many of the first are parted from the others, 0: none. areas: room for as many.
std::size_t TestOrder::divided(std::span<Placed> nodes, std::vector<float>& areas) const
{
    const int axis = widest_axis(nodes);
    for (Placed& node : nodes) node.middle = node.box.lower[axis] + node.box.upper()[axis];
    std::stable_sort(nodes.begin(), nodes.end(), [](const Placed& a, const Placed& b) { return a.middle < b.middle; });
    const std::size_t count = nodes.size();
    if (count <= kFewestNodes) return 0;
    Box behind = nodes[count - 1].box;
    for (std::size_t k = count; k-- > 0;) {
        behind = around(behind, nodes[k].box);
        areas[k] = half_area(behind.edges, by_);
    }
    std::size_t left = 0;  // nodes of the cheapest part
    float least = areas[0] * (static_cast<float>(count) - kCostOfNode);
    Box before = nodes[0].box;
    for (std::size_t k = 0; k + 1 < count; ++k) {
        before = around(before, nodes[k].box);
        const float cost = static_cast<float>(k + 1) * half_area(before.edges, by_) +
                           static_cast<float>(count - 1 - k) * areas[k + 1];
        if (cost < least) least = cost, left = k + 1;
    }
    return left;
}

std::uint32_t TestOrder::add_parent(std::span<const std::uint32_t> nodes)
{
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.box = hull(nodes),
                      .first_child = static_cast<std::uint32_t>(children_.size()),
                      .child_count = static_cast<std::uint32_t>(nodes.size())});
    children_.insert(children_.end(), nodes.begin(), nodes.end());
    return number;
}

TestOrder::Box TestOrder::hull(std::span<const std::uint32_t> nodes) const
{
    Box box = nodes_[nodes[0]].box;
    box.infinite = false;
    for (const std::uint32_t node : nodes) box = around(box, nodes_[node].box);
    return box;
}

/// Along which the boxes lie farthest apart. The running maximum of 3.7 takes lower corners.
int TestOrder::widest_axis(std::span<const Placed> nodes) const
{
    constexpr float kFar = 1e30f;
    glm::vec3 least(kFar), most(-kFar);
    for (const Placed& node : nodes)
        for (int axis = 0; axis < 3; ++axis) {
            const float lower = node.box.lower[axis];
            least[axis] = std::min(least[axis], lower);
            const float upper = lower + node.box.edges[axis];
            if (upper > most[axis]) most[axis] = by_ == Roundings::V38 ? upper : lower;
        }
    const glm::vec3 spread = most - least;
    return spread.z > std::max(spread.x, spread.y) ? 2 : spread.y > spread.x ? 1 : 0;
}

template <class F>
void TestOrder::visit(const Ray& ray, F&& f) const
{
    const SingleRay single(ray, by_);
    thread_local Waiting waiting;
    waiting.clear();
    const auto open = [&](const Node& node) {
        for (std::uint32_t k = 0; k < node.child_count; ++k) {
            const std::uint32_t child = children_[node.first_child + k];
            double key = kInfiniteKey;
            if (nodes_[child].box.infinite || single.enter(nodes_[child].box, key)) waiting.add({key, child});
        }
    };
    if (root_ != kNone) open(nodes_[root_]);
    while (!waiting.empty()) {
        const Node& node = nodes_[waiting.take().node];
        if (node.item == kNone) open(node);
        else if (f(node.item)) return;
    }
}

std::uint32_t TestOrder::first(const Ray& ray, std::span<const std::uint32_t> items) const
{
    std::uint32_t out = *std::min_element(items.begin(), items.end());
    visit(ray, [&](std::uint32_t whole) {
        const auto found =
            std::find_if(items.begin(), items.end(), [&](std::uint32_t item) { return whole_of(item) == whole; });
        if (found == items.end()) return false;
        out = *found;
        return true;
    });
    return out;
}

void TestOrder::arrange(const Ray& ray, std::span<std::uint32_t> items) const
{
    std::sort(items.begin(), items.end());
    auto next = items.begin();
    visit(ray, [&](std::uint32_t whole) {
        next = std::stable_partition(next, items.end(), [&](std::uint32_t item) { return whole_of(item) == whole; });
        return next == items.end();
    });
}

void TestOrder::arrange(std::vector<std::uint32_t>& items) const
{
    if (root_ == kNone) return;
    std::vector<std::uint32_t> arranged, waiting{root_};
    while (arranged.size() < items.size() && !waiting.empty()) {
        const Node& node = nodes_[waiting.back()];
        waiting.pop_back();
        if (node.item == kNone)
            for (std::uint32_t k = node.child_count; k-- > 0;) waiting.push_back(children_[node.first_child + k]);
        else
            std::copy_if(items.begin(), items.end(), std::back_inserter(arranged),
                         [&](std::uint32_t item) { return whole_of(item) == node.item; });
    }
    items = std::move(arranged);
}

}  // namespace csg
