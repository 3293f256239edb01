#pragma once

#include "csg/base/tolerance.h"
#include "csg/items/leaving.h"
#include "render/texture/finish.h"
#include "render/texture/fresnel.h"
#include "render/kernel/interior/interior_fade.h"
#include "render/kernel/light/direct_batch.h"
#include "render/kernel/scatter/scatter.h"
#include "render/kernel/context/segment_tile.h"
#include "render/kernel/interior/interface.h"
#include "render/kernel/tile/nearly_zero.h"

/// scatter() for a tile's hits of one layer whose normals are not bent, in the same order of operations: what their
/// rays share is worked out in vector lanes, then they are sent one by one. Where the layer is clear (SingleLayer) the
/// ray goes on in place of the one before it: no node, no light.
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
            straight |= HitMask{unbent(crossing)} << k;
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
        using csg::lanes::Double;
        const TileHits& at = scratch_.hits;
        const Double least(context_.scene.tolerance.hit), coarse(csg::Tolerance::kCoarse), zero(0.0), two(2.0),
            one(1.0);
        each_vector(hits, [&](int i) {
            const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
            const Double dx = get(tile_.rays.dx), dy = get(tile_.rays.dy), dz = get(tile_.rays.dz), nx = get(at.nx),
                         ny = get(at.ny), nz = get(at.nz);
            const Double cosine = dx * nx + dy * ny + dz * nz, twice = two * cosine;
            const Double x = dx - twice * nx, y = dy - twice * ny, z = dz - twice * nz;
            const Double unit = one / xsimd::sqrt(x * x + y * y + z * z);
            const Double rx = x * unit, ry = y * unit, rz = z * unit;
            cosine.store_aligned(cosine_.data() + i);
            rx.store_aligned(mirrored_x_.data() + i);
            ry.store_aligned(mirrored_y_.data() + i);
            rz.store_aligned(mirrored_z_.data() + i);
            mirrored_along_ |= HitMask{csg::lanes::mask(nx * rx + ny * ry + nz * rz > zero)} << i;
            through_along_ |= HitMask{csg::lanes::mask(cosine > zero)} << i;
            const Double largest = xsimd::max(xsimd::max(xsimd::abs(get(at.x)), xsimd::abs(get(at.y))),
                                              xsimd::max(xsimd::abs(get(at.z)), get(tile_.hits.t)));
            xsimd::max(least, coarse * largest).store_aligned(start_.data() + i);
        });
    }

    /// Shares that Fresnel's equations give, of hits whose finish goes by them.
    void find_fresnel(HitMask hits)
    {
        using csg::lanes::Double;
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
        const bool disperses = std::abs(crossing.dispersion - 1.0) >= kNearlyZero;
        if (disperses && !(state.wavelength > 0.0f)) {
            ready_ &= ~bit;
        } else if (!unbent(crossing)) {
            bent_ |= bit;
            ratio_[k] = disperses ? scratch_.spectrum.ratio_at(crossing.ratio, crossing.dispersion, state.wavelength)
                                  : crossing.ratio;
            stretch_[k] = state.stretch;
        }
    }

    /// bend() of refraction.h.
    void bend()
    {
        using csg::lanes::Double;
        HitMask along_normal = 0;
        constexpr double kRounding = 1e-9;
        const TileHits& at = scratch_.hits;
        const Double one(1.0), zero(0.0);
        each_vector(bent_, [&](int i) {
            const auto get = [i](const TileLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
            const Double stretch = get(stretch_), ratio = get(ratio_), dx = stretch * get(tile_.rays.dx),
                         dy = stretch * get(tile_.rays.dy), dz = stretch * get(tile_.rays.dz), nx = get(at.nx),
                         ny = get(at.ny), nz = get(at.nz);
            const Double facing = dx * nx + dy * ny + dz * nz, c = xsimd::abs(facing);
            const Double k = one + ratio * ratio * (c * c - one), along = ratio * c - xsimd::sqrt(k);
            const auto outward = facing <= zero;
            const Double x = ratio * dx + along * xsimd::select(outward, nx, -nx),
                         y = ratio * dy + along * xsimd::select(outward, ny, -ny),
                         z = ratio * dz + along * xsimd::select(outward, nz, -nz);
            const Double length = xsimd::sqrt(x * x + y * y + z * z), unit = one / length;
            total_ |= HitMask{csg::lanes::mask(k < zero)} << i;
            const Double bx = x * unit, by = y * unit, bz = z * unit;
            bx.store_aligned(bent_x_.data() + i);
            by.store_aligned(bent_y_.data() + i);
            bz.store_aligned(bent_z_.data() + i);
            along_normal |= HitMask{csg::lanes::mask(nx * bx + ny * by + nz * bz > zero)} << i;
            xsimd::select(xsimd::abs(length - one) > Double(kRounding), length, one).store_aligned(stretch_.data() + i);
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
        const HitMask own = csg::lanes::equal(tile_.hits.instance, Hit::kNoInstance);
        const auto leaving = [&](HitMask inward) { return own & ((in & inward) | (out & ~inward)); };
        mirrored_inward_ = inward_of(mirrored_along_);
        through_inward_ = inward_of(through_along_);
        mirrored_leaves_ = leaving(mirrored_inward_);
        through_leaves_ = leaving(through_inward_);
    }
    /// Of rays whose directions lie along the normal that faces the viewer: those that go into the solid.
    HitMask inward_of(HitMask along_normal) const
    {
        const HitMask inverted = ~csg::lanes::equal(tile_.hits.inverted.data(), 0);
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
        node.fade = glm::vec3(interior.transmission);
        if (list.holds(own)) node.fade *= interior_fade(interior, tile_.hits.t[k], false);
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
        const glm::dvec3 direction = bent ? glm::dvec3(bent_x_[k], bent_y_[k], bent_z_[k])
                                          : glm::dvec3(tile_.rays.dx[k], tile_.rays.dy[k], tile_.rays.dz[k]);
        go_on(k, direction, weight, through_inward_, through_leaves_, ray.state);
        ray.state.kind = tile_.kind(k);
        ray.state.stretch = bent ? stretch_[k] : state.stretch;
        cross(context_.scene.interiors, list, own, way_[k], ray.state.interiors);
        context_.cross(interior);
        node.through = queue.keep(ray, !bent);
    }

    /// The ray behind a clear surface, whose colour is what the ray before it waits for.
    [[gnu::always_inline]] void go_through(std::size_t k, ColorSlot out)
    {
        RayQueue& queue = scratch_.queue;
        const RayState& state = tile_.inherited(k);
        const InteriorList& list = tile_.interiors(k);
        ++context_.scratch.counts.refracted;
        if (!worth_tracing(context_, tile_.level(k), state.weight)) {
            queue.colors[out] = scene::Color();
            return;
        }
        QueuedRay& ray = queue.rays.emplace_back();
        ray.slot = out;
        ray.level = tile_.level(k);
        go_on(k, {tile_.rays.dx[k], tile_.rays.dy[k], tile_.rays.dz[k]}, state.weight, through_inward_, through_leaves_,
              ray.state);
        ray.state.kind = tile_.kind(k);
        ray.state.stretch = state.stretch;
        const std::uint32_t own = context_.scene.surfaces[tile_.hits.surface[k]].interior;
        cross(context_.scene.interiors, list, own, way_[k], ray.state.interiors);
        context_.cross(context_.scene.interiors[own]);
    }

    [[gnu::always_inline]] void mirror_into(std::size_t k, float weight, RayState& out)
    {
        go_on(k, {mirrored_x_[k], mirrored_y_[k], mirrored_z_[k]}, weight, mirrored_inward_, mirrored_leaves_, out);
        out.kind = plan::RayKind::Reflection;
        out.stretch = 1.0;
        out.interiors = tile_.interiors(k);
    }

    /// What mirrored and transmitted rays have in common.
    [[gnu::always_inline]] void go_on(std::size_t k, const glm::dvec3& direction, float weight, HitMask inward,
                                      HitMask leaves, RayState& out)
    {
        const RayState& state = tile_.inherited(k);
        const glm::dvec3 point = scratch_.hits.point(k);
        out.ray.origin = point;
        out.ray.direction = direction;
        out.start = start_[k];
        if (!has(leaves, k))
            out.start = context_.world.spawn_distance({point, direction}, tile_.hits.at(static_cast<int>(k)),
                                                      glm::dot(scratch_.hits.normal(k), direction), has(inward, k),
                                                      out.start);
        out.weight = weight;
        out.level = tile_.level(k);
        out.root = tile_.root(k);
        out.scattered = state.scattered;
        out.wavelength = state.wavelength;
    }

    static bool unbent(const Crossing& crossing)
    {
        return !(std::abs(crossing.ratio - 1.0) >= kNearlyZero || std::abs(crossing.dispersion - 1.0) >= kNearlyZero);
    }

    template <class F>
    static void each_vector(HitMask hits, F&& f)
    {
        constexpr HitMask kVector = (HitMask{1} << csg::lanes::kDoubles) - 1;
        while (hits != 0) {
            const std::size_t i = first_hit(hits) / csg::lanes::kDoubles * csg::lanes::kDoubles;
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
    alignas(64) TileLanes cosine_, start_, mirrored_x_, mirrored_y_, mirrored_z_;
    alignas(64) TileLanes ratio_, bent_x_, bent_y_, bent_z_;
    alignas(64) TileLanes eta_, share_;  ///< of fresnel_
    alignas(64) TileLanes stretch_;      ///< RayState::stretch, before the surface and then behind it
    TileColors reflectivity_, filter_;
    alignas(64) TileFloats residual_, weight_;  ///< LayerStack::residual, Mirror::weight
    std::array<Crossing::Way, csg::kTileRays> way_;
};

}  // namespace trace
