#pragma once

#include "render/kernel/light/tile_attenuation.h"
#include "render/kernel/light/shade_light.h"
#include "render/kernel/context/context.h"

namespace trace {

/// The nodes of an area light with area_illumination, each a light of its own over all hits of a tile, in vector lanes
/// (spec 3, 12.7). The operations are those of light::illuminate() at light::node_offset(), and of node_color(), in the
/// same order.
class NodeLanes {
public:
    /// which: the hits that are asked for.
    NodeLanes(const light::Light& light, HitMask which, ShadeScratch& scratch, int count)
        : light_(light), which_(which), scratch_(scratch), count_(count)
    {
        if (!turns()) return;
        for_each_hit(which, [&](std::size_t k) {
            const light::AreaAxes axes = light::oriented_axes(light, scratch.hits.point(k));
            a_.set(k, axes.a);
            b_.set(k, axes.b);
        });
        size_ = glm::length(light.axis1);
    }

    /// Where the hits see node (i, j) goes into ShadeScratch::light, its colours into ShadeScratch::reaching.
    /// \param seen  what shadows leave of the whole light
    void ask(int i, int j, const TileColors& seen)
    {
        if (turns()) {
            const glm::dvec3& middle = light_.location;
            const light::NodeShares at = light::node_shares(light_, i, j);
            const Double p(size_ * at.p * at.m), q(size_ * at.q * at.m);
            const auto along = [&](double from, const TileLanes& a, const TileLanes& b, int k) {
                return Double(from) + (p * load(a, k) + q * load(b, k));
            };
            const auto place = [&](int k) {
                return LanePoints{along(middle.x, a_.x, b_.x, k), along(middle.y, a_.y, b_.y, k),
                                  along(middle.z, a_.z, b_.z, k)};
            };
            toward_places(place, scratch_.hits, count_, scratch_.lamp.light);
        } else {
            toward_lamp(light_, scratch_.hits, count_, scratch_.lamp.light,
                        light::node_offset(light_, glm::dvec3(0), i, j));
        }
        color(seen);
    }

private:
    using Double = numbers::lanes::Double;
    struct alignas(64) Vectors {
        alignas(64) TileLanes x{}, y{}, z{};
        void set(std::size_t k, const glm::dvec3& v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
    };

    /// Toward each hit, which parallel light does alike toward all.
    bool turns() const { return light_.circular && light_.orient && !light::seen_in_one_direction(light_); }
    static Double load(const TileLanes& lanes, int k) { return Double::load_aligned(lanes.data() + k); }

    void color(const TileColors& seen)
    {
        const bool steady = light::steady_color(light_);
        if (!steady) {
            attenuate(light_, which_, scratch_.hits, scratch_.lamp.light, exact_);
            each_place(count_, [&](std::size_t k) { share_[k] = static_cast<float>(exact_[k]); });
        }
        const float part = 1.0f / static_cast<float>(light_.size1 * light_.size2);
        const auto channel = [&](int c, TileFloats TileColors::*of) {
            const float *from = (seen.*of).data(), whole = light_.color[c];
            float* to = (scratch_.lamp.reaching.*of).data();
            if (steady || whole == 0.0f) return each_place(count_, [&](std::size_t k) { to[k] = from[k] * part; });
            each_place(count_, [&](std::size_t k) { to[k] = (from[k] * part) * ((whole * share_[k]) / whole); });
        };
        channel(0, &TileColors::red);
        channel(1, &TileColors::green);
        channel(2, &TileColors::blue);
    }

    const light::Light& light_;
    const HitMask which_;
    ShadeScratch& scratch_;
    const int count_;
    double size_ = 0.0;
    alignas(64) TileLanes exact_{};   ///< by hit, what is left of the node's light; 0 where none has asked,
    alignas(64) TileFloats share_{};  ///< and as it counts
    Vectors a_, b_;                   ///< by hit, the axes of a light that turns to it
};

}  // namespace trace
