#pragma once

#include "render/trace/light/dimmed_lanes.h"
#include "render/trace/light/shade_light.h"
#include "render/trace/shade/shade_context.h"

namespace trace {

/// The nodes of an area light with area_illumination, each a light of its own over all hits of a tile, in vector lanes
/// (spec 3, 12.7). The operations are those of light::illuminate() at light::node_offset(), and of node_color(), in the
/// same order. Compiled once per instruction set.
class NodeLanes {
public:
    static bool serve(const light::Light& light) { return DimmedLanes::serve(light); }

    /// which: the hits that are asked for.
    NodeLanes(const light::Light& light, HitMask which, ShadeScratch& scratch, int count)
        : light_(light), which_(which), scratch_(scratch), count_(count), dimmed_(light)
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
            const light::NodeShares at = light::node_shares(light_, i, j);
            const Double p(size_ * at.p * at.m), q(size_ * at.q * at.m);
            toward([&](std::size_t k) {
                return Vector{p * load(a_.x, k) + q * load(b_.x, k), p * load(a_.y, k) + q * load(b_.y, k),
                              p * load(a_.z, k) + q * load(b_.z, k)};
            });
        } else {
            const glm::dvec3 offset = light::node_offset(light_, glm::dvec3(0), i, j);
            toward([&](std::size_t) { return Vector{Double(offset.x), Double(offset.y), Double(offset.z)}; });
        }
        color(seen);
    }

private:
    using Double = csg::lanes::Double;
    struct Vector {
        Double x, y, z;
    };
    struct alignas(64) Vectors {
        alignas(64) TileLanes x{}, y{}, z{};
        void set(std::size_t k, const glm::dvec3& v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
    };

    bool turns() const { return light_.circular && light_.orient; }
    static Double load(const TileLanes& lanes, std::size_t k) { return Double::load_aligned(lanes.data() + k); }

    template <class Offset>
    void toward(const Offset& offset)
    {
        const glm::dvec3& at = light_.location;
        TileLight& out = scratch_.light;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count_); k += csg::lanes::kDoubles) {
            const Vector from = offset(k);
            const Double x = (Double(at.x) + from.x) - load(scratch_.hits.x, k),
                         y = (Double(at.y) + from.y) - load(scratch_.hits.y, k),
                         z = (Double(at.z) + from.z) - load(scratch_.hits.z, k);
            const Double distance = xsimd::sqrt(x * x + y * y + z * z);
            distance.store_aligned(out.distance.data() + k);
            (x / distance).store_aligned(out.x.data() + k);
            (y / distance).store_aligned(out.y.data() + k);
            (z / distance).store_aligned(out.z.data() + k);
        }
    }

    void color(const TileColors& seen)
    {
        const bool steady = light::steady_color(light_);
        if (!steady) {
            dimmed_.find(which_, scratch_.light, exact_);
            each_place(count_, [&](std::size_t k) { share_[k] = static_cast<float>(exact_[k]); });
        }
        const float part = 1.0f / static_cast<float>(light_.size1 * light_.size2);
        const auto channel = [&](int c, TileFloats TileColors::*of) {
            const float *from = (seen.*of).data(), whole = light_.color[c];
            float* to = (scratch_.reaching.*of).data();
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
    const DimmedLanes dimmed_;
    double size_ = 0.0;
    alignas(64) TileLanes exact_{};   ///< by hit, what is left of the node's light; 0 where none has asked,
    alignas(64) TileFloats share_{};  ///< and as it counts
    Vectors a_, b_;                   ///< by hit, the axes of a light that turns to it
};

}  // namespace trace
