#pragma once

#include "render/kernel/gather/photon_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace trace {

/// Photons by eights in boxes, eight boxes in a node, and so on up: what a search looks at in lanes. The order in which
/// POV-Ray's tree keeps photons (`photon_places.h`) says nothing here.
class PhotonBoxes {
public:
    static constexpr std::size_t kWide = 8;

    /// Photons that lie near each other; places behind the last are infinite.
    struct alignas(32) Leaf {
        std::array<float, kWide> x, y, z;
        std::array<std::uint32_t, kWide> photon;
        std::uint32_t gated = 0;  ///< a bit each: it has gates (`photon_places.h`)
        float gate_off = 0.0f;    ///< the farthest of their gates' planes off their photons
    };
    /// Boxes of what lies below; those behind the last are nowhere.
    struct alignas(32) Node {
        std::array<float, kWide> low_x, low_y, low_z, high_x, high_y, high_z;
    };

    /// Those of a map. A photon of a file that is nowhere is never found.
    void take(const PhotonPlaces& map)
    {
        std::vector<Place> places;
        places.reserve(map.size());
        for (std::size_t i = 0; i < map.size(); ++i)
            if (std::isfinite(map.x[i]) && std::isfinite(map.y[i]) && std::isfinite(map.z[i]))
                places.push_back({{map.x[i], map.y[i], map.z[i]}, static_cast<std::uint32_t>(i)});
        std::size_t below = kWide;  // photons below a child of the root
        while (below * kWide < places.size()) below *= kWide;
        order(places, below);
        fill_leaves(places, map);
        fill_levels();
    }

    /// The lowest level has leaves as children; the highest is one node.
    std::size_t levels() const { return levels_.size(); }
    const Node& node(std::size_t level, std::size_t i) const { return levels_[level][i]; }
    const Leaf& leaf(std::size_t i) const { return leaves_[i]; }

private:
    struct Place {
        std::array<float, 3> at;
        std::uint32_t photon;
    };
    struct Box {
        std::array<float, 3> low, high;
    };
    static constexpr float kFar = std::numeric_limits<float>::infinity();

    static Box nowhere() { return {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}}; }
    static void include(Box& box, const std::array<float, 3>& low, const std::array<float, 3>& high)
    {
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = std::min(box.low[k], low[k]);
            box.high[k] = std::max(box.high[k], high[k]);
        }
    }

    /// Halves across the widest axis until each `below` photons are a child, then the children the same way.
    static void order(std::span<Place> places, std::size_t below)
    {
        if (places.size() <= kWide) return;
        const std::size_t children = (places.size() + below - 1) / below;
        if (children == 1) return order(places, below / kWide);
        Box box = nowhere();
        for (const Place& place : places) include(box, place.at, place.at);
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k)
            if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
        const std::size_t middle = children / 2 * below;
        std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(middle), places.end(),
                         [axis](const Place& a, const Place& b) { return a.at[axis] < b.at[axis]; });
        order(places.first(middle), below);
        order(places.subspan(middle), below);
    }

    void fill_leaves(const std::vector<Place>& places, const PhotonPlaces& map)
    {
        leaves_.assign((places.size() + kWide - 1) / kWide, {});
        for (Leaf& leaf : leaves_) {
            leaf.x.fill(kFar);
            leaf.y.fill(kFar);
            leaf.z.fill(kFar);
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            Leaf& leaf = leaves_[i / kWide];
            const std::size_t k = i % kWide;
            leaf.x[k] = places[i].at[0];
            leaf.y[k] = places[i].at[1];
            leaf.z[k] = places[i].at[2];
            leaf.photon[k] = places[i].photon;
            if (map.gates[places[i].photon].first == PhotonPlaces::kNoGate) continue;
            leaf.gated |= 1u << k;
            leaf.gate_off = std::max(leaf.gate_off, map.gate_off(places[i].photon));
        }
    }

    void fill_levels()
    {
        levels_.clear();
        std::vector<Box> below;
        for (const Leaf& leaf : leaves_) {
            Box& box = below.emplace_back(nowhere());
            for (std::size_t k = 0; k < kWide && leaf.x[k] < kFar; ++k)
                include(box, {leaf.x[k], leaf.y[k], leaf.z[k]}, {leaf.x[k], leaf.y[k], leaf.z[k]});
        }
        while (!below.empty()) {
            std::vector<Node>& nodes = levels_.emplace_back((below.size() + kWide - 1) / kWide);
            std::vector<Box> boxes;
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                Box& all = boxes.emplace_back(nowhere());
                for (std::size_t k = 0; k < kWide; ++k) {
                    const Box& box = kWide * i + k < below.size() ? below[kWide * i + k] : nowhere();
                    include(all, box.low, box.high);
                    put(nodes[i], k, box);
                }
            }
            if (nodes.size() == 1) break;
            below = std::move(boxes);
        }
    }
    static void put(Node& node, std::size_t k, const Box& box)
    {
        node.low_x[k] = box.low[0], node.low_y[k] = box.low[1], node.low_z[k] = box.low[2];
        node.high_x[k] = box.high[0], node.high_y[k] = box.high[1], node.high_z[k] = box.high[2];
    }

    std::vector<Leaf> leaves_;
    std::vector<std::vector<Node>> levels_;
};

}  // namespace trace
