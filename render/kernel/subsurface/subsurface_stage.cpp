#include "render/kernel/subsurface/subsurface_stage.h"

#include "numbers/functions/functions.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/kernel/media/point_lights.h"
#include "render/kernel/radiosity/ambient.h"
#include "numbers/random.h"
#include "render/kernel/context/shade_tile.h"
#include "render/kernel/subsurface/entry_lanes.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/plan/shines_on.h"
#include "render/kernel/context/photon_shadow.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr double kFromBelow = 1e-10;  ///< where rays from below a surface begin: they start on none
constexpr std::size_t kFewest = 40;   ///< rays waiting at the end of an octant that are worth a beam of their own

class SubsurfaceLight {
public:
    SubsurfaceLight(Context& context, const SegmentTile& tile)
        : context_(context), plan_(*context.scene.subsurface), tile_(tile), own_(context, context.scratch.nested()),
          sites_(context.scratch.subsurface().sites), ways_(context.scratch.subsurface().ways),
          photons_(has_surface_photons(context)), order_(context.scratch.subsurface().order)
    {
        sites_.clear();
        ++own_.below;
        around_.fill(&nothing_);
        const radiosity::Field* field = context.indirect != nullptr ? context.indirect->radiosity.get() : nullptr;
        gathers_ = plan_.radiosity && field != nullptr && context.bounce < field->settings().recursion_limit;
    }

    void add_site(std::size_t k, std::size_t row, const RowPage& at)
    {
        const plan::CompiledScene& scene = context_.scene;
        const texture::Finish& finish = *at.finish[k];
        const std::uint32_t interior = scene.surfaces[tile_.hits.surface[k]].interior;
        if (interior == plan::kNone) return;
        const InteriorList& outside = tile_.interiors(k);
        double eta = static_cast<double>(scene.interiors[interior].ior);
        if (!outside.empty()) eta /= static_cast<double>(scene.interiors[outside.last()].ior);
        const glm::dvec3 point = context_.scratch.shade.hits.point(k), normal = context_.scratch.shade.hits.normal(k);
        const glm::dvec3 viewer = -tile_.ray(k).direction;
        sites_.push_back({k, row, interior, point, normal, viewer,
                          Scattering(at.pigment[k] * finish.subsurface_diffuse, finish.translucency, eta,
                                     plan_.tables[plan_.table_of[interior]]),
                          numbers::random_seed(point, viewer), point});
        SubsurfaceSite& site = sites_.back();
        site.passed = 1.0 - texture::fresnel_share(site.matter.eta, site.cosine());
    }

    void run()
    {
        // Light that has come from below a surface looks at the next one with one sample, and below that at none.
        const int diffuse = context_.below > 0 ? std::min(1, plan_.diffuse_samples) : plan_.diffuse_samples;
        const int single = context_.below > 0 ? std::min(1, plan_.single_samples) : plan_.single_samples;
        if (context_.below > 1 || sites_.empty()) return;
        find_bases();
        add_diffuse(diffuse);
        find_ways_out();
        add_single(single);
        add_unscattered();
    }

    template <class F>
    void each(F&& f) const
    {
        for (const SubsurfaceSite& site : sites_)
            f(site.lane, site.row, glm::vec3(site.diffuse + site.single + site.unscattered));
    }

private:
    std::uint32_t interior_of(csg::SurfaceId surface) const { return context_.scene.surfaces[surface].interior; }

    void trace(int count, bool common_origin = false)
    {
        rays_.count = count;
        rays_.common_origin = common_origin;
        context_.world.nearest(rays_, bit(plan::RayKind::Image), own_.scratch.geometry, met_);
        found_ = first_hits(count) & ~numbers::lanes::equal(met_.surface, csg::kNoSurface);
    }

    /// A point below each site, half way where the object is thin.
    void find_bases()
    {
        for (std::size_t first = 0; first < sites_.size(); first += kTileRays) {
            const std::size_t count = std::min<std::size_t>(kTileRays, sites_.size() - first);
            for (std::size_t i = 0; i < count; ++i) {
                const SubsurfaceSite& site = sites_[first + i];
                rays_.set(i, {site.point, -site.normal}, context_.scene.tolerance.hit, 2.0 * way_of(site));
            }
            trace(static_cast<int>(count));
            for (std::size_t i = 0; i < count; ++i) {
                SubsurfaceSite& site = sites_[first + i];
                double way = way_of(site);
                if (has(found_, i) && interior_of(met_.surface[i]) == site.interior) way = 0.5 * met_.t[i];
                else if (has(found_, i)) way = std::min(way, met_.t[i] - kNearlyZero);
                site.base = site.point - way * site.normal;
            }
        }
    }

    /// Mean free path in scene units.
    double way_of(const SubsurfaceSite& site) const { return site.matter.mean_way() / plan_.mm_per_unit; }

    /// Light that goes in somewhere around the site, is scattered many times and comes out there (spec 6, 5.3).
    void add_diffuse(int samples)
    {
        std::size_t waiting = 0;
        const auto flush = [&] {
            if (waiting != 0) light_diffuse(static_cast<int>(waiting));
            waiting = 0;
            sent_.clear();
        };
        for (std::size_t s = 0; s < sites_.size(); ++s) {
            const SubsurfaceSite& site = sites_[s];
            if (!(way_of(site) > 0.0)) continue;
            order_.sort(plan_.directions, site.seed, static_cast<std::size_t>(samples));
            for (std::size_t octant = 0; octant < OctantOrder::kOctants; ++octant) {
                for (const std::uint32_t number : order_.of(octant)) {
                    sent_.add(s, waiting);
                    rays_.set(waiting++, {site.base, plan_.directions[number]}, kFromBelow, numbers::kInfinity);
                    if (waiting == kTileRays) flush();
                }
                if (waiting >= kFewest) flush();
            }
        }
        flush();
        for (SubsurfaceSite& site : sites_)
            if (site.met > 0) site.diffuse /= static_cast<double>(site.met);
    }

    void light_diffuse(int count)
    {
        trace(count, sent_.of_one_site());
        HitMask same = 0;
        each_sent(found_, [&](SubsurfaceSite& site, HitMask met) {
            site.met += std::popcount(met);
            for_each_hit(met, [&](std::size_t k) {
                if (interior_of(met_.surface[k]) == site.interior) same |= HitMask{1} << k;
            });
        });
        if (same == 0) return;
        context_.world.shading_points(rays_, met_, same, places_);
        diffuse_.begin();
        light_points(same, [&](HitMask lit, const PointLights& light) {
            each_sent(lit, [&](SubsurfaceSite& site, HitMask which) {
                diffuse_.add(entries_, site, which, light.directions(), [&](std::size_t k) { return light.color(k); });
            });
        });
        if (gathers_) add_ambient(same);
    }

    /// f(site, its rays) for the sites that have sent rays of the mask.
    template <class F>
    void each_sent(HitMask rays, F&& f)
    {
        sent_.each(rays, [&](std::size_t site, HitMask which) { f(sites_[site], which); });
    }

    /// Light of surroundings that goes in where a ray has met the object (spec 6, 5.5).
    void add_ambient(HitMask same)
    {
        radiosity::GatherScratch& gather = own_.scratch.gather();
        std::size_t count = 0;
        each_sent(same, [&](const SubsurfaceSite& site, HitMask which) {
            for_each_hit(which, [&](std::size_t k) {
                radiosity::Request& to = gather.requests[count++];
                to.point = places_.point(k);
                to.normal = to.bent = places_.normal(k);
                to.weight = area(k);
                to.start = context_.scene.tolerance.hit_from(to.point, met_.t[k]);
                to.lane = static_cast<std::uint8_t>(site.lane);
                to.root = tile_.state(site.lane).root;
            });
        });
        radiosity::find_ambient(own_, count);
        count = 0;
        each_sent(same, [&](SubsurfaceSite& site, HitMask which) {
            diffuse_.add_around(entries_, site, which, [&](std::size_t) { return gather.ambient[count++]; });
        });
    }

    /// Of the surface that a ray stands for, mm^2.
    double area(std::size_t k) const
    {
        const glm::dvec3 direction{rays_.dx[k], rays_.dy[k], rays_.dz[k]};
        const double mm = met_.t[k] * plan_.mm_per_unit;
        return entry_area(mm, std::abs(glm::dot(direction, places_.normal(k))));
    }

    /// f(hits, lights) for every light: the points that were met and that it reaches.
    template <class F>
    void light_points(HitMask which, F&& f)
    {
        texture::Points points;
        points.count = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(rays_.count); ++k)
            points.add(has(which, k) ? places_.point(k) : glm::dvec3(0));
        points.pad();
        const auto& lights = context_.lights.lights;
        for (std::size_t i = 0; i < lights.size(); ++i) ask(i, which, points, f);
    }

    template <class F>
    void ask(std::size_t light, HitMask which, const texture::Points& points, F&& f)
    {
        HitMask asking = 0, collecting = 0;
        csg::SurfaceId known = csg::kNoSurface;
        bool asks = false, collects_here = false;
        for_each_hit(which, [&](std::size_t k) {
            if (const csg::SurfaceId surface = met_.surface[k]; surface != known) {
                known = surface;
                asks = shines_on(context_.lights.lights[light], context_.scene.surfaces[surface]);
                collects_here = asks && photons_ && collects(context_.scene, surface);
            }
            asking |= HitMask{asks ? 1u : 0u} << k;
            collecting |= HitMask{collects_here ? 1u : 0u} << k;
        });
        if (asking == 0) return;
        PointLights lit(own_, met_, around_, points, collecting);
        if (const HitMask reached = lit.ask(light, asking)) f(reached, std::as_const(lit));
    }

    /// Where the viewer's ray goes on below the surface, and how far until it comes out.
    void find_ways_out()
    {
        ways_.resize(sites_.size());
        for (std::size_t first = 0; first < sites_.size(); first += kTileRays) {
            const std::size_t count = std::min<std::size_t>(kTileRays, sites_.size() - first);
            for (std::size_t i = 0; i < count; ++i) {
                const SubsurfaceSite& site = sites_[first + i];
                WayBelow& way = ways_[first + i];
                const double ratio = 1.0 / site.matter.eta, c = site.cosine(), k = 1.0 + ratio * ratio * (c * c - 1.0);
                way.open = k >= 0.0;
                way.direction = way.open ? glm::normalize(-ratio * site.viewer +
                                                          (ratio * c - std::sqrt(std::max(0.0, k))) * site.normal)
                                         : -site.normal;
                rays_.set(i, {site.point, way.direction}, context_.scene.tolerance.hit, numbers::kInfinity);
            }
            trace(static_cast<int>(count));
            context_.world.shading_points(rays_, met_, found_, places_);
            for (std::size_t i = 0; i < count; ++i) {
                WayBelow& way = ways_[first + i];
                way.length = has(found_, i) ? met_.t[i] * plan_.mm_per_unit : numbers::kInfinity;
                way.same = has(found_, i) && interior_of(met_.surface[i]) == sites_[first + i].interior;
                if (!way.same) continue;
                way.end = places_.point(i);
                way.normal = places_.normal(i);
            }
        }
    }

    /// Light that is scattered once on the viewer's way (spec 6, 5.4).
    void add_single(int samples)
    {
        const auto& lights = context_.lights.lights;
        for (std::size_t number = 0; number < lights.size(); ++number) {
            const light::Light& light = lights[number];
            std::size_t waiting = 0;
            const auto flush = [&] {
                if (waiting != 0) light_single(number, static_cast<int>(waiting));
                waiting = 0;
            };
            for (std::size_t s = 0; s < sites_.size(); ++s) {
                if (!ways_[s].open) continue;
                const SubsurfaceSite& site = sites_[s];
                const std::uint32_t all = 3u * static_cast<std::uint32_t>(samples);
                for (std::uint32_t i = 0; i < all; ++i) {
                    if (i % kTileRays == 0) depths_.draw(site.seed, i, std::min<std::uint32_t>(kTileRays, all - i));
                    const int c = static_cast<int>(i % 3);
                    const double way = depths_.drawn[i % kTileRays] / site.matter.extinction[c];
                    if (!(way < ways_[s].length)) continue;
                    const glm::dvec3 place = site.point + way / plan_.mm_per_unit * ways_[s].direction;
                    const light::Illumination to = light::toward(light, place, glm::dvec3(0));
                    if (!(to.distance > kFromBelow)) continue;
                    owner_[waiting] = s;
                    channel_[waiting] = c;
                    single_.set(waiting, site, c, depths_.left[i % kTileRays]);
                    rays_.set(waiting++, {place, to.direction}, kFromBelow, to.distance);
                    if (waiting == kTileRays) flush();
                }
            }
            flush();
        }
        for (SubsurfaceSite& site : sites_)
            if (samples > 0) site.single /= static_cast<double>(samples);
    }

    void light_single(std::size_t light, int count)
    {
        trace(count);
        HitMask same = 0;
        for_each_hit(found_, [&](std::size_t k) {
            if (interior_of(met_.surface[k]) == sites_[owner_[k]].interior) same |= HitMask{1} << k;
        });
        if (same == 0) return;
        context_.world.shading_points(rays_, met_, same, places_);
        texture::Points points;
        points.count = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
            points.add(has(same, k) ? places_.point(k) : glm::dvec3(0));
        points.pad();
        ask(light, same, points, [&](HitMask lit, const PointLights& lights) {
            single_.each(entries_, lit, lights.directions(), [&](std::size_t k, double share) {
                const int c = channel_[k];
                if (std::isfinite(share))
                    sites_[owner_[k]].single[c] += share * static_cast<double>(lights.color(k)[c]);
            });
        });
    }

    /// What shows through where little is scattered (spec 6, 5.4).
    void add_unscattered()
    {
        std::size_t waiting = 0;
        const auto flush = [&] {
            if (waiting == 0) return;
            trace(static_cast<int>(waiting));
            std::array<scene::Color, kTileRays> seen;
            shade_tile(own_, rays_, met_, RayState{}, nullptr, seen.data());
            for (std::size_t i = 0; i < waiting; ++i) {
                SubsurfaceSite& site = sites_[owner_[i]];
                const double length = ways_[owner_[i]].length;
                for (int c = 0; c < 3; ++c)
                    site.unscattered[c] += numbers::exp(-site.matter.extinction[c] * length) *
                                           static_cast<double>(seen[i].rgb()[c]);
            }
            waiting = 0;
        };
        for (std::size_t s = 0; s < sites_.size(); ++s) {
            const WayBelow& way = ways_[s];
            const Scattering& matter = sites_[s].matter;
            if (!way.open || !way.same) continue;
            const double least = std::min({matter.extinction.x, matter.extinction.y, matter.extinction.z});
            if (!(numbers::exp(-least * way.length) > context_.adc_bailout)) continue;
            const double facing = glm::dot(way.direction, way.normal);
            const glm::dvec3 normal = facing > 0.0 ? -way.normal : way.normal;
            const double c = std::abs(facing), k = 1.0 + matter.eta * matter.eta * (c * c - 1.0);
            if (k < 0.0) continue;
            const glm::dvec3 out = matter.eta * way.direction + (matter.eta * c - std::sqrt(k)) * normal;
            owner_[waiting] = s;
            rays_.set(waiting++, {way.end, glm::normalize(out)}, context_.scene.tolerance.hit, numbers::kInfinity);
            if (waiting == kTileRays) flush();
        }
        flush();
    }

    Context& context_;
    const plan::SubsurfacePlan& plan_;
    const SegmentTile& tile_;
    Context own_;  ///< of rays and points below the surface
    std::vector<SubsurfaceSite>& sites_;
    std::vector<WayBelow>& ways_;
    const InteriorList nothing_{};
    std::array<const InteriorList*, csg::kTileRays> around_;
    RayTile rays_;
    csg::HitTile met_;
    csg::ShadingPoints places_;
    HitMask found_ = 0;
    bool gathers_ = false;  ///< light of surroundings goes in too
    const bool photons_;    ///< there are some on surfaces
    SentRays sent_;
    OctantOrder& order_;
    const EntryTile entries_{rays_, met_, places_, plan_.mm_per_unit};
    DiffuseEntries diffuse_;
    SingleEntries single_;
    DrawnDepths depths_;
    std::array<std::size_t, csg::kTileRays> owner_;
    std::array<int, csg::kTileRays> channel_;
};

}  // namespace

void add_subsurface_light(Context& context, const SegmentTile& tile, DirectBatch& batch)
{
    ShadeScratch& scratch = context.scratch.shade;
    HitMask asking = 0;
    for_each_hit(batch.all(), [&](std::size_t k) {
        for (std::size_t d = 0; d < batch.rows(k); ++d)
            if (scratch.rows.pages[d].finish[k]->subsurface) asking |= HitMask{1} << k;
    });
    if (asking == 0) return;
    SubsurfaceLight light(context, tile);
    for_each_hit(asking, [&](std::size_t k) {
        for (std::size_t d = 0; d < batch.rows(k); ++d)
            if (scratch.rows.pages[d].finish[k]->subsurface) light.add_site(k, d, scratch.rows.pages[d]);
    });
    light.run();
    light.each([&](std::size_t k, std::size_t d, const glm::vec3& gained) {
        RowPage& at = scratch.rows.pages[d];
        at.gained.set(k, at.gained[k] + gained);
    });
}

}  // namespace trace
