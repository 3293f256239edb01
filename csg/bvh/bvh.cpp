#include "csg/bvh/bvh.h"

#include "numbers/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>

namespace csg {
namespace {

constexpr int kMostBins = 16;
/// Few things do not need many places to be parted at.
int bins_for(std::uint32_t count) { return count <= 32 ? 8 : kMostBins; }
/// A node's eight boxes cost about as much as half a leaf's test (measured: notes on tracing speed, section 1).
constexpr double kNodeCost = 0.5;
/// Deeper cuts halve the count: 40 levels and the 28 that halving can add stay within kBvhStack.
constexpr int kFreeLevels = 40;
static_assert((kFreeLevels + 28) * 7 < kBvhStack);

/// Things of which a thread divides as many in 10 ms or more.
constexpr std::uint32_t kWorthAThread = 30000;

struct BinaryNode {
    Aabb bounds;
    std::uint32_t left = 0, right = 0;  ///< children; both 0 for a leaf
    std::uint32_t begin = 0, end = 0;   ///< inputs of a leaf
    bool leaf() const { return left == 0; }
};

double half_area(const Aabb& box)
{
    if (box.empty()) return 0.0;
    const glm::dvec3 e = box.upper - box.lower;
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// A box as the least of six numbers, the upper corner's with their signs turned: the compiler takes several at a time.
struct Box {
    alignas(16) std::array<double, 6> least;

    static Box of(const Aabb& box)
    {
        return {{box.lower.x, box.lower.y, box.lower.z, -box.upper.x, -box.upper.y, -box.upper.z}};
    }
    static Box none() { return {{kInfinity, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity}}; }
    void include(const Box& other)
    {
        for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], other.least[i]);
    }
    double half_area() const
    {
        const auto& v = least;
        const double x = -v[3] - v[0], y = -v[4] - v[1], z = -v[5] - v[2];
        return x >= 0.0 && y >= 0.0 && z >= 0.0 ? x * y + y * z + z * x : 0.0;
    }
};

/// Blocks that `count` things of a kind fill: the unit of cost of a leaf.
double blocks(std::uint32_t count, std::uint32_t capacity) { return (count + capacity - 1) / capacity; }

struct Split {
    int axis = -1;
    int bin = 0;
    double cost = kInfinity;
};

class Builder {
public:
    explicit Builder(std::vector<BvhInput>& inputs) : inputs_(inputs) {}

    std::vector<BinaryNode> build(int threads)
    {
        return branch(0, static_cast<std::uint32_t>(inputs_.size()), 0, threads);
    }

private:
    std::vector<BinaryNode> branch(std::uint32_t begin, std::uint32_t end, int level, int threads)
    {
        nodes_.reserve(2 * static_cast<std::size_t>(end - begin));
        add(begin, end, level, threads);
        return std::move(nodes_);
    }

    /// A node and all below it; its place.
    std::uint32_t add(std::uint32_t begin, std::uint32_t end, int level, int threads)
    {
        const auto at = static_cast<std::uint32_t>(nodes_.size());
        nodes_.emplace_back();
        divide(at, begin, end, level, threads);
        return at;
    }

    void divide(std::uint32_t at, std::uint32_t begin, std::uint32_t end, int level, int threads)
    {
        Aabb bounds, centers;
        bool one_kind = true;
        for (std::uint32_t i = begin; i < end; ++i) {
            bounds.include(inputs_[i].bounds);
            centers.include(center(inputs_[i]));
            one_kind = one_kind && inputs_[i].kind == inputs_[begin].kind;
        }
        nodes_[at].bounds = bounds;
        const std::uint32_t count = end - begin, capacity = block_capacity(inputs_[begin].kind);
        const bool fits = one_kind && count <= capacity;
        const Split split = count > 1 ? best_split(begin, end, centers, half_area(bounds), one_kind ? capacity : 1u)
                                      : Split();
        if (fits && (count == 1 || split.cost >= 1.0)) {
            nodes_[at].begin = begin;
            nodes_[at].end = end;
            return;
        }
        const std::uint32_t middle = level < kFreeLevels ? partition(begin, end, split, centers) : begin + count / 2;
        std::future<std::vector<BinaryNode>> other;
        if (threads > 1 && count >= kWorthAThread)
            other = std::async(std::launch::async, [&, half = threads / 2] {
                return Builder(inputs_).branch(middle, end, level + 1, half);
            });
        const std::uint32_t left = add(begin, middle, level + 1, other.valid() ? threads - threads / 2 : 1);
        const std::uint32_t right = other.valid() ? append(other.get()) : add(middle, end, level + 1, 1);
        nodes_[at].left = left;
        nodes_[at].right = right;
    }

    /// What another thread made; the place of its first node.
    std::uint32_t append(const std::vector<BinaryNode>& branch)
    {
        const auto first = static_cast<std::uint32_t>(nodes_.size());
        for (BinaryNode node : branch) {
            if (!node.leaf()) {
                node.left += first;
                node.right += first;
            }
            nodes_.push_back(node);
        }
        return first;
    }

    static glm::dvec3 center(const BvhInput& input) { return 0.5 * (input.bounds.lower + input.bounds.upper); }

    static int bin_of(double value, double lower, double scale, int bins)
    {
        return std::clamp(static_cast<int>((value - lower) * scale), 0, bins - 1);
    }

    /// What falls into the bins of each axis.
    struct Bins {
        Box boxes[3][kMostBins];
        std::uint32_t counts[3][kMostBins];

        explicit Bins(int bins)
        {
            for (int axis = 0; axis < 3; ++axis) {
                std::fill_n(boxes[axis], bins, Box::none());
                std::fill_n(counts[axis], bins, 0u);
            }
        }
    };

    /// The cheapest cut, in units of one leaf block tested; axis -1 if all centres coincide.
    Split best_split(std::uint32_t begin, std::uint32_t end, const Aabb& centers, double parent_area,
                     std::uint32_t capacity) const
    {
        Split best;
        const int bins = bins_for(end - begin);
        const glm::dvec3 extent = centers.upper - centers.lower;
        glm::dvec3 scale(0.0);  // of an axis without extent: all in the first bin, which is not looked at
        for (int axis = 0; axis < 3; ++axis)
            if (extent[axis] > 0.0) scale[axis] = bins / extent[axis];
        Bins all(bins);
        for (std::uint32_t i = begin; i < end; ++i) {
            const Box box = Box::of(inputs_[i].bounds);
            const glm::dvec3 at = center(inputs_[i]);
            for (int axis = 0; axis < 3; ++axis) {
                const int bin = bin_of(at[axis], centers.lower[axis], scale[axis], bins);
                all.boxes[axis][bin].include(box);
                ++all.counts[axis][bin];
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (!(extent[axis] > 0.0)) continue;
            const Box* const boxes = all.boxes[axis];
            const std::uint32_t* const counts = all.counts[axis];
            double right_cost[kMostBins] = {};
            Box sweep = Box::none();
            std::uint32_t count = 0;
            double cost_so_far = kInfinity;
            for (int bin = bins - 1; bin > 0; --bin) {
                if (counts[bin] > 0) {
                    sweep.include(boxes[bin]);
                    count += counts[bin];
                    cost_so_far = sweep.half_area() * blocks(count, capacity);
                }
                right_cost[bin] = cost_so_far;
            }
            sweep = Box::none();
            count = 0;
            for (int bin = 1; bin < bins; ++bin) {
                if (counts[bin - 1] == 0) continue;  // the same cut as before
                sweep.include(boxes[bin - 1]);
                count += counts[bin - 1];
                const double sum = sweep.half_area() * blocks(count, capacity) + right_cost[bin];
                const double cost = kNodeCost + (parent_area > 0.0 ? sum / parent_area : 0.0);
                if (cost < best.cost) best = {axis, bin, cost};
            }
        }
        return best;
    }

    /// What is meant to stand first does so then, both parts in their order; where the second begins.
    template <class First>
    std::uint32_t part(std::uint32_t begin, std::uint32_t end, First&& first)
    {
        later_.clear();
        std::uint32_t middle = begin;
        for (std::uint32_t i = begin; i < end; ++i) {
            if (!first(inputs_[i])) later_.push_back(inputs_[i]);
            else if (middle++ != i) inputs_[middle - 1] = inputs_[i];
        }
        std::copy(later_.begin(), later_.end(), inputs_.begin() + static_cast<std::ptrdiff_t>(middle));
        return middle;
    }

    std::uint32_t partition(std::uint32_t begin, std::uint32_t end, const Split& split, const Aabb& centers)
    {
        if (split.axis >= 0) {
            const double lower = centers.lower[split.axis];
            const int bins = bins_for(end - begin);
            const double scale = bins / (centers.upper[split.axis] - lower);
            const std::uint32_t middle = part(begin, end, [&](const BvhInput& input) {
                const double at = 0.5 * (input.bounds.lower[split.axis] + input.bounds.upper[split.axis]);
                return bin_of(at, lower, scale, bins) < split.bin;
            });
            if (middle != begin && middle != end) return middle;
        }
        // All centres coincide: part the kinds, or else the count.
        const LeafKind kind = inputs_[begin].kind;
        const std::uint32_t middle = part(begin, end, [&](const BvhInput& i) { return i.kind == kind; });
        return middle != end ? middle : begin + (end - begin) / 2;
    }

    std::vector<BvhInput>& inputs_;
    std::vector<BinaryNode> nodes_;
    std::vector<BvhInput> later_;  ///< scratch of part()
};

/// Gathers the binary tree into nodes of eight by opening the child of largest area.
class Collapser {
public:
    Collapser(const std::vector<BvhInput>& inputs, const std::vector<BinaryNode>& binary, Bvh& out)
        : inputs_(inputs), binary_(binary), out_(out)
    {}

    void run()
    {
        out_.sphere_first.push_back(0);
        out_.triangle_first.push_back(0);
        out_.nodes.emplace_back();
        collapse(0, 0, 1);
    }

private:
    std::uint32_t collapse(std::uint32_t from, std::uint32_t into, int level)
    {
        out_.depth = std::max(out_.depth, level);
        std::uint32_t open[8] = {from};
        int count = 1;
        while (count < 8) {
            int largest = -1;
            for (int i = 0; i < count; ++i) {
                if (binary_[open[i]].leaf()) continue;
                if (largest < 0 || half_area(binary_[open[i]].bounds) > half_area(binary_[open[largest]].bounds))
                    largest = i;
            }
            if (largest < 0) break;
            const BinaryNode& node = binary_[open[largest]];
            open[largest] = node.left;
            open[count++] = node.right;
        }
        std::uint32_t seen_below = 0;
        for (int i = 0; i < 8; ++i) {
            if (i >= count) {
                place(into, i, Aabb{}, ChildWord::node(0), 0);
                continue;
            }
            const BinaryNode& node = binary_[open[i]];
            ChildWord word{};
            std::uint32_t seen = 0;
            if (node.leaf()) {
                word = leaf(node);
                for (std::uint32_t k = node.begin; k < node.end; ++k)
                    seen |= inputs_[k].visible | (inputs_[k].quick ? kQuick : 0u);
            } else {
                const auto index = static_cast<std::uint32_t>(out_.nodes.size());
                out_.nodes.emplace_back();
                word = ChildWord::node(index);
                seen = collapse(open[i], index, level + 1);
            }
            place(into, i, node.bounds, word, seen);
            seen_below |= seen & ~kQuick;
        }
        return seen_below;
    }

    void place(std::uint32_t into, int slot, const Aabb& box, ChildWord word, std::uint32_t seen)
    {
        BvhNode& node = out_.nodes[into];
        for (int axis = 0; axis < 3; ++axis) {
            node.bounds[axis][slot] = rounded_down(box.lower[axis]);
            node.bounds[axis + 3][slot] = rounded_up(box.upper[axis]);
        }
        node.child[slot] = word;
        node.kinds[slot] = seen;
    }

    ChildWord leaf(const BinaryNode& node)
    {
        const LeafKind kind = inputs_[node.begin].kind;
        if (kind == LeafKind::Item) return ChildWord::leaf(kind, inputs_[node.begin].index);
        auto& members = kind == LeafKind::Spheres ? out_.sphere_members : out_.triangle_members;
        auto& first = kind == LeafKind::Spheres ? out_.sphere_first : out_.triangle_first;
        const auto block = static_cast<std::uint32_t>(first.size() - 1);
        for (std::uint32_t k = node.begin; k < node.end; ++k) members.push_back(inputs_[k].index);
        first.push_back(static_cast<std::uint32_t>(members.size()));
        return ChildWord::leaf(kind, block);
    }

    const std::vector<BvhInput>& inputs_;
    const std::vector<BinaryNode>& binary_;
    Bvh& out_;
};

}  // namespace

bool fits_hierarchy(const Aabb& box)
{
    constexpr double kWidest = 1e30;
    return box.finite() && glm::all(glm::lessThan(glm::abs(box.lower), glm::dvec3(kWidest))) &&
           glm::all(glm::lessThan(glm::abs(box.upper), glm::dvec3(kWidest)));
}

Bvh build_bvh(std::vector<BvhInput> inputs, int threads)
{
    Bvh out;
    if (inputs.empty()) return out;
    const std::vector<BinaryNode> binary = Builder(inputs).build(threads);
    out.bounds = binary[0].bounds;
    Collapser(inputs, binary, out).run();
    return out;
}

}  // namespace csg
