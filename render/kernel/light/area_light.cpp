#include "render/kernel/light/area_light.h"

#include "numbers/lane_equal.h"
#include "csg/base/tolerance.h"
#include "render/kernel/light/surface_filters.h"
#include "render/kernel/extinction/shadow_media.h"
#include "render/kernel/light/shadow_filter.h"
#include "render/kernel/record/recorder.h"

#include <algorithm>
#include <utility>

namespace trace {
namespace {

constexpr std::uint64_t kJitterPurpose = 1000;  // of the random numbers of node 0
bool all_grey(HitMask hits, const TileColors& of)
{
    bool grey = true;
    for_each_hit(hits, [&](std::size_t k) { grey &= of.red[k] == of.green[k] && of.green[k] == of.blue[k]; });
    return grey;
}

}  // namespace

AreaLight::AreaLight(Context& context, const light::Light& light, const csg::HitTile& met,
                     const InteriorList* const* interiors)
    : context_(context), scratch_(context.scratch.shade), area_(context.scratch.shade.area()), light_(light),
      interiors_(interiors), same_places_(!light.jitter && !(light.circular && light.orient))
{
    area_.known.clear();
    area_.lit.clear();
    area_.mixed.clear();
    area_.row.clear();
    area_.column.clear();
    area_.at.clear();
    area_.place.assign(static_cast<std::size_t>(light.size1) * static_cast<std::size_t>(light.size2),
                       AreaScratch::kNone);
    const TileHits& at = scratch_.hits;
    for (std::size_t k = 0; k < kRays; ++k) from_[k] = context.scene.tolerance.shadow_from(at.point(k), met.t[k]);
    for (std::size_t k = 0; k < kRays; ++k)
        color_.set(k, light.area_illumination ? light.color : scratch_.lamp.colors[k]);
    if (context_.traits.media || (light.atmosphere && context.scene.atmosphere.extinguishes))
        later_ = &context.scratch.shadow_media().area_shadows;
}

void AreaLight::shadows(HitMask hits, TileColors& out)
{
    if (light_.circular && light_.orient)
        for_each_hit(hits, [&](std::size_t k) { axes_[k] = light::oriented_axes(light_, scratch_.hits.point(k)); });
    by_hit_ = scattered(hits);
    find_shaft(hits);
    if (shaft_ && shaft_->empty() && !light_.projector) {
        out = color_;
        if (light_.atmosphere) for_each_hit(hits, [this](std::size_t k) { rests_[k] = rest_to_corner(k); });
        return;
    }
    bright_ = bright(hits);
    grey_ = !context_.traits.filters && all_grey(hits, color_);
    want_all(0, 0, light_.size1 - 1, light_.size2 - 1, 0);
    ask(hits);
    // Dimmed light asks in POV-Ray's order: what was asked last counts (Rest). Where the rays of a hit are a beam,
    // others do not join it.
    by_level_ = !light_.atmosphere && (shaft_ || !by_hit_);
    if (by_level_) refine(hits);
    rectangle(0, 0, light_.size1 - 1, light_.size2 - 1, 0, hits, false, out);
    if (grey_) out.green = out.red, out.blue = out.red;
}

/// Of the last corner, where nothing stands between.
AreaLight::Rest AreaLight::rest_to_corner(std::size_t k) const
{
    const glm::dvec3 point = scratch_.hits.point(k);
    const light::Illumination lit =
        light::toward(light_, point, light::node_offset(light_, point, light_.size1 - 1, light_.size2 - 1));
    return {lit.direction, 0.0, lit.distance};
}

/// The hits are farther apart than the light is wide.
bool AreaLight::scattered(HitMask hits) const
{
    if ((hits & (hits - 1)) == 0) return true;
    glm::dvec3 low(numbers::kInfinity), high(-numbers::kInfinity);
    for_each_hit(hits, [&](std::size_t k) {
        low = glm::min(low, scratch_.hits.point(k));
        high = glm::max(high, scratch_.hits.point(k));
    });
    return glm::length(high - low) > glm::length(light_.axis1) + glm::length(light_.axis2);
}

void AreaLight::find_shaft(HitMask hits)
{
    if (light_.kind == light::Light::Kind::Cylinder || light_.parallel) return;  // rays end beside the light
    csg::PointSet from, to;
    double least = numbers::kInfinity;
    for_each_hit(hits, [&](std::size_t k) {
        from.add(scratch_.hits.point(k));
        least = std::min(least, from_[k]);
    });
    // Half a cell of jitter, and the shift of a circle's nodes.
    const auto reach = [](int size) { return size > 1 ? 0.502 + 0.5 / (size - 1) : 0.0; };
    const double p = reach(light_.size1), q = reach(light_.size2);
    if (light_.circular && light_.orient) {
        const double r = 1.5 * glm::length(light_.axis1) *
                         std::max(p, q);  // a node's coordinates are at most sqrt(2) of this, in any direction
        for (int c = 0; c < 8; ++c)
            to.add(light_.location + glm::dvec3((c & 1) != 0 ? r : -r, (c & 2) != 0 ? r : -r, (c & 4) != 0 ? r : -r));
    } else {
        for (int c = 0; c < 4; ++c)
            to.add(light_.location + ((c & 1) != 0 ? p : -p) * light_.axis1 + ((c & 2) != 0 ? q : -q) * light_.axis2);
    }
    from.pad();
    to.pad();
    shaft_.emplace(context_.world.data(), from, to, least);
    if (!shaft_->serves()) shaft_.reset();
}

std::uint32_t AreaLight::place(int i, int j) const
{
    return area_
        .place[static_cast<std::size_t>(i) * static_cast<std::size_t>(light_.size2) + static_cast<std::size_t>(j)];
}

void AreaLight::want(int i, int j)
{
    std::uint32_t& place =
        area_.place[static_cast<std::size_t>(i) * static_cast<std::size_t>(light_.size2) + static_cast<std::size_t>(j)];
    const bool fresh = place == AreaScratch::kNone;
    if (fresh) {
        place = static_cast<std::uint32_t>(area_.known.size());
        area_.known.push_back(0);
        area_.lit.push_back(0);
        area_.mixed.push_back(0);
        area_.row.push_back(i);
        area_.column.push_back(j);
        if (same_places_) area_.at.push_back(node_place(i, j));
    }
    // What is asked for again is one of the corners asked for just before.
    constexpr std::ptrdiff_t kCorners = 16;
    const auto end = area_.wanted.end(), begin = end - std::min<std::ptrdiff_t>(kCorners, end - area_.wanted.begin());
    if (fresh || std::find(begin, end, place) == end) area_.wanted.push_back(place);
}

/// The nodes wanted, for the hits that do not know them.
void AreaLight::ask(HitMask hits)
{
    ask_nodes(hits);
    trace_samples();
}

/// The same without the samples that do not fill a tile: they wait.
void AreaLight::ask_nodes(HitMask hits)
{
    if (by_hit_)
        for_each_hit(hits, [&](std::size_t k) {
            for (const std::uint32_t n : area_.wanted) ask(n, HitMask{1} << k);
        });
    else
        for (const std::uint32_t n : area_.wanted) ask(n, hits);
    area_.wanted.clear();
}

void AreaLight::ask(std::uint32_t node, HitMask hits)
{
    HitMask& known = area_.known[node];
    HitMask asking = hits & ~known;
    known |= asking;
    while (asking != 0) {
        // The first of them, as many as there are places left.
        const HitMask now = deposited(first_hits(static_cast<int>(kRays - samples_)), asking);
        asking &= ~now;
        const Asked asked{now, node, static_cast<std::uint32_t>(samples_)};
        asked_[asked_count_++] = asked;
        for_each_hit(now, [&](std::size_t k) { hit_[samples_++] = static_cast<std::uint32_t>(k); });
        const double row = area_.row[node], column = area_.column[node];
        if (same_places_) {
            const glm::dvec3 at = area_.at[node];
            for (std::size_t n = asked.first; n < samples_; ++n) x_[n] = at.x, y_[n] = at.y, z_[n] = at.z;
        } else {
            for (std::size_t n = asked.first; n < samples_; ++n) row_[n] = row, column_[n] = column;
        }
        if (light_.jitter) {
            const auto number = static_cast<std::int64_t>(row * static_cast<double>(light_.size2) + column);
            const std::uint64_t purpose = 2 * static_cast<std::uint64_t>(number) + kJitterPurpose;
            for (std::size_t n = asked.first; n < samples_; ++n) purpose_[n] = purpose;
        }
        if (samples_ == kRays) trace_samples();
    }
}

void AreaLight::trace_samples()
{
    if (samples_ == 0) return;
    lanes_ = (samples_ + 7) & ~std::size_t{7};
    for (std::size_t n = samples_; n < lanes_; ++n) {
        hit_[n] = hit_[0];
        if (same_places_) x_[n] = x_[0], y_[n] = y_[0], z_[n] = z_[0];
        else row_[n] = row_[0], column_[n] = column_[0];
        if (light_.jitter) purpose_[n] = purpose_[0];
    }
    make_rays();
    const csg::RayTile& rays = scratch_.shadow.rays;
    csg::CrossingTile& met = scratch_.shadow.crossings;
    csg::Scratch& geometry = context_.scratch.geometry;
    if (light_.shadowless) {
        met.ending.fill(Shadow::Clear);
    } else {
        context_.scratch.counts.shadow += samples_;
        if (context_.traits.filters)
            shaft_ ? context_.world.shadow_crossings(rays, *shaft_, geometry, met)
                   : context_.world.shadow_crossings(rays, geometry, met);
        else
            shaft_ ? context_.world.shadow(rays, *shaft_, geometry, met.ending.data())
                   : context_.world.shadow(rays, geometry, met.ending.data());
    }
    HitMask seen = 0, near = 0;  // by sample: the light is there; it is too near for a shadow
    for (std::size_t n = 0; n < lanes_; n += numbers::lanes::kDoubles) {
        using numbers::lanes::Double;
        const auto at = [n](const auto& values) { return Double::load_aligned(values.data() + n); };
        seen |= HitMask{numbers::lanes::mask(at(distance_) > Double(-numbers::kInfinity))} << n;
        near |= HitMask{numbers::lanes::mask(at(rays.t_max) <= at(rays.t_min))} << n;
    }
    const auto ends = [&](Shadow as) {
        return numbers::lanes::equal(reinterpret_cast<const std::uint8_t*>(met.ending.data()),
                                     static_cast<std::uint8_t>(as));
    };
    const HitMask lit = seen & (near | ~ends(Shadow::Blocked)), filtered = seen & ~near & ends(Shadow::Filtered);
    tell<&Recorder::area_rays>(scratch_, hit_.data(), samples_, lit, filtered);
    if (filtered != 0 && context_.traits.filters_together && !context_.traits.restarts()) find_filters(filtered);
    for (std::size_t i = 0; i < asked_count_; ++i) {
        const Asked& asked = asked_[i];
        area_.lit[asked.node] |= deposited(lit >> asked.first, asked.hits);
        if (light_.atmosphere) keep_rests(asked);
        const HitMask mixed = deposited(filtered >> asked.first, asked.hits);
        if (mixed != 0) keep_filtered(asked, mixed);
    }
    if (later_ != nullptr && !later_->empty()) dim_by_media();
    asked_count_ = 0;
    samples_ = 0;
}

/// What surfaces with patterns or caustics leave of these samples.
void AreaLight::find_filters(HitMask samples)
{
    SurfaceFilters filters(context_);
    const csg::CrossingTile& met = scratch_.shadow.crossings;
    for_each_hit(samples, [&](std::size_t n) {
        if (met.count[n] == csg::CrossingTile::kTooMany) return;
        const glm::dvec3 direction = scratch_.shadow.rays.ray(static_cast<int>(n)).direction;
        filters.add(n, {scratch_.hits.point(hit_[n]), direction}, met.hits[n].data(), met.count[n]);
    });
    filters.run();
}

void AreaLight::keep_filtered(const Asked& asked, HitMask hits)
{
    area_.mixed[asked.node] |= hits;
    if (area_.filtered.size() <= asked.node) area_.filtered.resize(area_.known.size());
    for (std::size_t n = asked.first; n < asked.last(); ++n) {
        if (!has(hits, hit_[n])) continue;
        node_[n] = asked.node;
        area_.filtered[asked.node].set(hit_[n], sample_color(n));
    }
}

/// What media leave of the samples whose stretches of media wait.
void AreaLight::dim_by_media()
{
    later_->run(context_.scene, [this](std::size_t n, const glm::vec3& share) {
        TileColors& filtered = area_.filtered[node_[n]];
        filtered.set(hit_[n], filtered[hit_[n]] * share);
    });
}

void AreaLight::keep_rests(const Asked& asked)
{
    for (std::size_t n = asked.first; n < asked.last(); ++n)
        rests_[hit_[n]] = {scratch_.shadow.rays.ray(static_cast<int>(n)).direction, 0.0, distance_[n]};
}

/// Of a sample whose shadow ray crosses what filters light.
glm::vec3 AreaLight::sample_color(std::size_t ray)
{
    csg::CrossingTile& met = scratch_.shadow.crossings;
    const std::size_t k = hit_[ray];
    const light::Illumination lit{scratch_.shadow.rays.ray(static_cast<int>(ray)).direction, distance_[ray], color_[k]};
    const glm::dvec3 point = scratch_.hits.point(k);
    const bool too_many = met.count[ray] == csg::CrossingTile::kTooMany;
    double unused = 0.0;
    const ShadowAir air{light_.atmosphere, later_, ray, light_.atmosphere ? &rests_[k].from : &unused};
    const PhotonShadow& caught = scratch_.lamp.photons;
    if (too_many || context_.traits.restarts()) {
        const glm::vec3 passed = filtered_light(context_, point, from_[k], *interiors_[k], lit, lit.color, air,
                                                too_many ? nullptr : met.hits[ray].data());
        const auto& crossings = context_.scratch.crossings;
        return caught.stops(k, crossings.data(), crossings.size()) ? glm::vec3(0) : passed;
    }
    if (caught.stops(k, met.hits[ray].data(), met.count[ray])) return glm::vec3(0);
    return shadow_transmittance(context_, point, from_[k], *interiors_[k], lit, false, met.hits[ray].data(),
                                met.count[ray], air,
                                context_.traits.filters_together ? scratch_.filters().filters[ray].data() : nullptr);
}

}  // namespace trace
