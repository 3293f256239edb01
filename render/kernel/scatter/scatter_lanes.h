#pragma once

#include "csg/base/tolerance.h"
#include "csg/items/leaving.h"
#include "render/texture/finish.h"
#include "render/texture/fresnel.h"
#include "render/kernel/light/direct_batch.h"
#include "render/kernel/scatter/refraction.h"
#include "render/kernel/scatter/scatter.h"
#include "render/kernel/scatter/turned.h"
#include "render/kernel/context/segment_tile.h"
#include "render/kernel/interior/interface.h"
#include "render/kernel/tile/nearly_zero.h"

/// scatter() for a tile's hits of one layer whose normals are not bent: what their rays share is worked out in vector
/// lanes (turned.h), then they are sent one by one. Where the layer is clear (SingleLayer) the ray goes on in place of
/// the one before it: no node, no light.
namespace trace {

class LaneScatter {
public:
    LaneScatter(Context& context, const SegmentTile& tile, DirectBatch& batch)
        : context_(context), scratch_(context.scratch.shade), tile_(tile), batch_(batch)
    {}

    /// Hits of a clear layer around `own`: those that light passes unbent need nothing else. Which.
    HitMask pass_through(HitMask hits, std::uint32_t own)
    {
        HitMask straight = 0;
        for_each_hit(hits, [&](std::size_t k) {
            const Crossing crossing = crossing_of(context_.scene.interiors, tile_.interiors(k), own);
            way_[k] = crossing.way;
            straight |= HitMask{!crossing.bends()} << k;
        });
        clear_ |= straight;
        return straight;
    }
    /// Gets these hits ready, and those of pass_through(); those that only scatter() knows about (white light that is
    /// dispersed, iridescence) are not.
    void prepare(HitMask hits)
    {
        ready_ = clear_;
        if ((hits | clear_) == 0) return;
        find_mirrored(hits | clear_);
        if (hits != 0 && context_.traits.fresnel) find_fresnel(hits);
        for_each_hit(hits, [this](std::size_t k) { look(k); });
        if (bent_ != 0) bend();
        find_leaving(hits | clear_);
    }
    bool ready(std::size_t k) const { return has(ready_, k); }

    /// The node of a hit that is ready, and its rays. Hits come in their order.
    void send(std::size_t k, ColorSlot out)
    {
        RayQueue& queue = scratch_.queue;
        if (has(clear_, k)) return go_through(k, out);
        const auto index = static_cast<std::uint32_t>(queue.nodes.size());
        ShadeNode& node = queue.new_node(ShadeNode::Kind::Surface, out);
        node.filter = filter_[k];
        node.residual = residual_[k];
        if (has(through_, k)) transmit(k, node);
        const glm::vec3 reflectivity = reflectivity_[k];
        if (!black(reflectivity) && !node.total) {  // a total reflection has sent that ray
            ++context_.scratch.counts.reflected;
            const float weight = weight_[k];
            ColorSlot seen = kNoSlot;
            if (worth_tracing(context_, tile_.level(k), weight)) {
                QueuedRay& ray = queue.mirrors.emplace_back();
                mirror_into(k, weight, ray.state);
                seen = queue.keep(ray, false);
            }
            node.first = static_cast<std::uint32_t>(queue.terms.size());
            node.count = 1;
            queue.terms.emplace_back(seen, reflectivity, batch_.top_finish(k).reflection_power);
        }
        batch_.close_node(k, 0, index);
    }

private:
    /// Cosines with the normals, directions of mirrored rays, and where rays begin to look.
    void find_mirrored(HitMask hits)
    {
        using csg::lanes::Directions;
        using numbers::lanes::Double;
        const TileHits& at = scratch_.hits;
        const Double least(context_.scene.tolerance.hit), coarse(csg::Tolerance::kCoarse), zero(0.0);
        each_vector(hits, [&](int i) {
            const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
            const Directions d{get(tile_.rays.dx), get(tile_.rays.dy), get(tile_.rays.dz)},
                n{get(at.nx), get(at.ny), get(at.nz)};
            const Double along = dot(d, n);
            const Directions r = mirrored_unit(mirrored_about(d, n, along), context_.scene.camera.povray);
            along.store_aligned(cosine_.data() + i);
            mirrored_.store(i, r);
            mirrored_along_ |= HitMask{numbers::lanes::mask(dot(n, r) > zero)} << i;
            through_along_ |= HitMask{numbers::lanes::mask(along > zero)} << i;
            const Double largest = xsimd::max(xsimd::max(xsimd::abs(get(at.x)), xsimd::abs(get(at.y))),
                                              xsimd::max(xsimd::abs(get(at.z)), get(tile_.hits.t)));
            xsimd::max(least, coarse * largest).store_aligned(start_.data() + i);
        });
    }

    /// Shares that Fresnel's equations give, of hits whose finish goes by them.
    void find_fresnel(HitMask hits)
    {
        using numbers::lanes::Double;
        for_each_hit(hits, [this](std::size_t k) {
            const texture::Finish& finish = batch_.top_finish(k);
            if (!finish.fresnel || finish.schlick || finish.reflection_min == finish.reflection_max) return;
            fresnel_ |= HitMask{1} << k;
            eta_[k] = fresnel_index(context_.scene.interiors, tile_.interiors(k),
                                    context_.scene.surfaces[tile_.hits.surface[k]].interior);
        });
        if (fresnel_ == 0) return;
        each_vector(fresnel_, [&](int i) {
            texture::fresnel_share(Double::load_aligned(eta_.data() + i), -Double::load_aligned(cosine_.data() + i))
                .store_aligned(share_.data() + i);
        });
    }

    /// What the layer lets through and mirrors, and how the interface bends.
    [[gnu::always_inline]] void look(std::size_t k)
    {
        const auto& interiors = context_.scene.interiors;
        const HitMask bit = HitMask{1} << k;
        const texture::Finish& finish = batch_.top_finish(k);
        const scene::Color c = batch_.top_pigment(k);
        const std::uint32_t own = context_.scene.surfaces[tile_.hits.surface[k]].interior;
        const InteriorList& list = tile_.interiors(k);
        const RayState& state = tile_.inherited(k);
        if (finish.irid > 0.0f) return;
        glm::vec3 reflectivity(0);
        if (finish.reflects()) {
            const auto by_index = [&] { return finish.fresnel ? fresnel_index(interiors, list, own) : 1.0; };
            reflectivity = has(fresnel_, k)
                               ? texture::reflectivity_at(finish, c, -cosine_[k], static_cast<float>(share_[k]))
                               : texture::reflectivity(finish, c, -cosine_[k], by_index());
            weight_[k] = mirror_weight(state.weight, 1.0f, finish, reflectivity);
        }
        const glm::vec3 filter = texture::past_layer(glm::vec3(1), c, finish, reflectivity);
        const float residual = residual_of(filter);
        reflectivity_.set(k, reflectivity);
        filter_.set(k, filter);
        residual_[k] = residual;
        ready_ |= bit;
        if (!(residual > static_cast<float>(context_.adc_bailout)) || own == plan::kNone) return;
        through_ |= bit;
        const Crossing crossing = crossing_of(interiors, list, own);
        way_[k] = crossing.way;
        const bool disperses = crossing.disperses();
        if (disperses && !(state.wavelength > 0.0f)) {
            ready_ &= ~bit;
        } else if (crossing.bends()) {
            bent_ |= bit;
            ratio_[k] = disperses ? scratch_.spectrum.ratio_at(crossing.ratio, crossing.dispersion, state.wavelength)
                                  : crossing.ratio;
            stretch_[k] = state.stretch;
        }
    }

    void bend()
    {
        using csg::lanes::Directions;
        using numbers::lanes::Double;
        HitMask along_normal = 0;
        const TileHits& at = scratch_.hits;
        each_vector(bent_, [&](int i) {
            const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
            const Directions n{get(at.nx), get(at.ny), get(at.nz)};
            Double stretch = get(stretch_);
            const Directions d{stretch * get(tile_.rays.dx), stretch * get(tile_.rays.dy),
                               stretch * get(tile_.rays.dz)};
            numbers::lanes::Bool total;
            const Directions bent = bent_behind(d, n, get(ratio_), stretch, total);
            total_ |= HitMask{numbers::lanes::mask(total)} << i;
            bent_ray_.store(i, bent);
            stretch.store_aligned(stretch_.data() + i);
            along_normal |= HitMask{numbers::lanes::mask(dot(n, bent) > Double(0.0))} << i;
        });
        total_ &= bent_;
        through_along_ = (through_along_ & ~bent_) | (along_normal & bent_);
    }

    /// Whose rays meet no more of the solid that they begin on, as far as its kind tells.
    void find_leaving(HitMask hits)
    {
        HitMask out = 0, in = 0;
        for_each_hit(hits, [&](std::size_t k) {
            const HitMask ways = csg::leaving_ways(csg::kind_of(tile_.hits.part[k]));
            out |= (ways & 1) << k;
            in |= (ways >> 1) << k;
        });
        const HitMask own = numbers::lanes::equal(tile_.hits.instance, Hit::kNoInstance);
        const auto leaving = [&](HitMask inward) { return own & ((in & inward) | (out & ~inward)); };
        mirrored_inward_ = inward_of(mirrored_along_);
        through_inward_ = inward_of(through_along_);
        mirrored_leaves_ = leaving(mirrored_inward_);
        through_leaves_ = leaving(through_inward_);
    }
    /// Of rays whose directions lie along the normal that faces the viewer: those that go into the solid.
    HitMask inward_of(HitMask along_normal) const
    {
        const HitMask inverted = ~numbers::lanes::equal(tile_.hits.inverted.data(), 0);
        return ~(along_normal ^ tile_.from_inside() ^ inverted);
    }

    /// The ray behind the surface, or the one that is mirrored where none gets through.
    [[gnu::always_inline]] void transmit(std::size_t k, ShadeNode& node)
    {
        RayQueue& queue = scratch_.queue;
        const std::uint32_t own = context_.scene.surfaces[tile_.hits.surface[k]].interior;
        const plan::Interior& interior = context_.scene.interiors[own];
        const InteriorList& list = tile_.interiors(k);
        const RayState& state = tile_.inherited(k);
        const float weight = state.weight * largest(glm::abs(node.filter));
        node.fade = fade_behind(interior, list, own, tile_.hits.t[k]);
        node.total = has(total_, k);
        ++(node.total ? context_.scratch.counts.reflected : context_.scratch.counts.refracted);
        if (!worth_tracing(context_, tile_.level(k), weight)) return;
        if (node.total) {
            QueuedRay& ray = queue.mirrors.emplace_back();
            mirror_into(k, weight, ray.state);
            node.through = queue.keep(ray, false);
            return;
        }
        const bool bent = has(bent_, k);
        QueuedRay& ray = queue.rays.emplace_back();
        if (bent) go_behind(k, bent_ray_.at(k), stretch_[k], weight, own, ray.state);
        else go_behind(k, straight_on(k), state.stretch, weight, own, ray.state);
        node.through = queue.keep(ray, !bent);
    }

    /// The ray behind a clear surface, whose colour is what the ray before it waits for.
    [[gnu::always_inline]] void go_through(std::size_t k, ColorSlot out)
    {
        RayQueue& queue = scratch_.queue;
        const RayState& state = tile_.inherited(k);
        ++context_.scratch.counts.refracted;
        if (!worth_tracing(context_, tile_.level(k), state.weight)) {
            queue.colors[out] = scene::Color();
            return;
        }
        QueuedRay& ray = queue.rays.emplace_back();
        ray.slot = out;
        ray.level = tile_.level(k);
        go_behind(k, straight_on(k), state.stretch, state.weight,
                  context_.scene.surfaces[tile_.hits.surface[k]].interior, ray.state);
    }

    glm::dvec3 straight_on(std::size_t k) const { return {tile_.rays.dx[k], tile_.rays.dy[k], tile_.rays.dz[k]}; }

    /// own: the interior that the surface closes.
    [[gnu::always_inline]] void go_behind(std::size_t k, const glm::dvec3& direction, double stretch, float weight,
                                          std::uint32_t own, RayState& out)
    {
        go_on(k, direction, weight, through_inward_, through_leaves_, out);
        out.kind = tile_.kind(k);
        out.stretch = stretch;
        cross(context_.scene.interiors, tile_.interiors(k), own, way_[k], out.interiors);
        context_.cross(context_.scene.interiors[own]);
    }

    [[gnu::always_inline]] void mirror_into(std::size_t k, float weight, RayState& out)
    {
        go_on(k, mirrored_.at(k), weight, mirrored_inward_, mirrored_leaves_, out);
        be_mirrored(tile_.interiors(k), out);
    }

    /// What mirrored and transmitted rays have in common.
    [[gnu::always_inline]] void go_on(std::size_t k, const glm::dvec3& direction, float weight, HitMask inward,
                                      HitMask leaves, RayState& out)
    {
        const csg::Ray ray{scratch_.hits.point(k), direction};
        leave(tile_.inherited(k), tile_.level(k), tile_.root(k), ray, weight, out);
        out.start = start_[k];
        if (!has(leaves, k))
            out.start = context_.world.spawn_distance(ray, tile_.hits.at(static_cast<int>(k)),
                                                      glm::dot(scratch_.hits.normal(k), direction), has(inward, k),
                                                      out.start);
    }

    struct alignas(64) TileDirections {
        alignas(64) TileLanes x, y, z;

        void store(int i, const csg::lanes::Directions& v)
        {
            v.x.store_aligned(x.data() + i);
            v.y.store_aligned(y.data() + i);
            v.z.store_aligned(z.data() + i);
        }
        glm::dvec3 at(std::size_t k) const { return {x[k], y[k], z[k]}; }
    };

    template <class F>
    static void each_vector(HitMask hits, F&& f)
    {
        constexpr HitMask kVector = (HitMask{1} << numbers::lanes::kDoubles) - 1;
        while (hits != 0) {
            const std::size_t i = first_hit(hits) / numbers::lanes::kDoubles * numbers::lanes::kDoubles;
            f(static_cast<int>(i));
            hits &= ~(kVector << i);
        }
    }

    Context& context_;
    ShadeScratch& scratch_;
    const SegmentTile& tile_;
    DirectBatch& batch_;
    HitMask ready_ = 0, clear_ = 0;
    HitMask fresnel_ = 0;           ///< those whose share_ is known
    HitMask through_ = 0;           ///< those that a ray behind the surface is asked of
    HitMask bent_ = 0, total_ = 0;  ///< of them, those whose rays change direction; are mirrored within
    HitMask mirrored_along_ = 0, through_along_ = 0;    ///< rays with a positive cosine with the normal
    HitMask mirrored_inward_ = 0, through_inward_ = 0;  ///< rays that go into their own solid
    HitMask mirrored_leaves_ = 0, through_leaves_ = 0;  ///< rays that surely meet no more of their own solid
    // Not cleared.
    TileDirections mirrored_, bent_ray_;
    alignas(64) TileLanes cosine_, start_, ratio_;
    alignas(64) TileLanes eta_, share_;  ///< of fresnel_
    alignas(64) TileLanes stretch_;      ///< RayState::stretch, before the surface and then behind it
    TileColors reflectivity_, filter_;
    alignas(64) TileFloats residual_, weight_;  ///< LayerStack::residual, Mirror::weight
    std::array<Crossing::Way, csg::kTileRays> way_;
};

}  // namespace trace
