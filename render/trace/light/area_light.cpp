#include "render/trace/light/area_light.h"

#include "csg/packet/lane_equal.h"
#include "csg/base/tolerance.h"
#include "render/trace/queue/lane_masks.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr float kRefined = 0.1f;  // neighbouring samples that differ by more are refined (spec 3, 12.6)

/// f(k, channel) for every lane of the groups of eight that have a hit, and every channel of colours.
template <class F>
void each_lane(HitMask hits, F&& f)
{
    for (std::size_t first = 0; hits >> first != 0; first += csg::kTileSide) {
        if ((hits >> first & 0xff) == 0) {
            if (first + csg::kTileSide >= csg::kTileRays) return;
            continue;
        }
        for (TileFloats TileColors::*channel : {&TileColors::red, &TileColors::green, &TileColors::blue})
            for (std::size_t k = first; k < first + csg::kTileSide; ++k) f(k, channel);
        if (first + csg::kTileSide >= csg::kTileRays) return;
    }
}

/// Which of the hits, or of their neighbours.
HitMask differ(HitMask hits, const TileColors& a, const TileColors& b)
{
    alignas(64) std::array<std::uint32_t, csg::kTileRays> far{};
    for (std::size_t first = 0; first < csg::kTileRays; first += csg::kTileSide) {
        if ((hits >> first & 0xff) == 0) continue;
        for (std::size_t k = first; k < first + csg::kTileSide; ++k) {
            const float d = std::abs(a.red[k] - b.red[k]) + std::abs(a.green[k] - b.green[k]) +
                            std::abs(a.blue[k] - b.blue[k]);
            far[k] = d > kRefined ? 1u : 0u;
        }
    }
    return csg::lanes::equal(far, 1u);
}

}  // namespace

AreaLight::AreaLight(Context& context, const light::Light& light, const csg::HitTile& met,
                     const InteriorList* const* interiors)
    : context_(context), scratch_(context.scratch.shade), area_(context.scratch.shade.area), light_(light),
      interiors_(interiors)
{
    area_.known.clear();
    area_.row.clear();
    area_.column.clear();
    area_.place.assign(static_cast<std::size_t>(light.size1) * static_cast<std::size_t>(light.size2),
                       AreaScratch::kNone);
    const TileHits& at = scratch_.hits;
    for (std::size_t k = 0; k < kRays; ++k) from_[k] = context.scene.tolerance.shadow_from(at.point(k), met.t[k]);
    for (std::size_t k = 0; k < kRays; ++k)
        color_.set(k, light.area_illumination ? light.color : scratch_.lit_colors[k]);
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
    want_all(0, 0, light_.size1 - 1, light_.size2 - 1, 0);
    ask(hits);
    rectangle(0, 0, light_.size1 - 1, light_.size2 - 1, 0, hits, out);
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
    glm::dvec3 low(csg::kInfinity), high(-csg::kInfinity);
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
    double least = csg::kInfinity;
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
    shaft_.emplace(context_.world.data(), from, to, least);
    if (!shaft_->serves()) shaft_.reset();
}

/// All nodes that are asked for whatever they tell.
void AreaLight::want_all(int i1, int j1, int i2, int j2, int depth)
{
    want(i1, j1), want(i2, j1), want(i1, j2), want(i2, j2);
    if (depth >= light_.adaptive || !(i2 - i1 > 1 || j2 - j1 > 1)) return;
    const int i_low = (i1 + i2) / 2, i_high = (i1 + i2 + 1) / 2, j_low = (j1 + j2) / 2, j_high = (j1 + j2 + 1) / 2;
    want_all(i1, j1, i_low, j_low, depth + 1);
    want_all(i_high, j1, i2, j_low, depth + 1);
    want_all(i1, j_high, i_low, j2, depth + 1);
    want_all(i_high, j_high, i2, j2, depth + 1);
}

const TileColors& AreaLight::value(int i, int j) const
{
    return area_.values[area_.place[static_cast<std::size_t>(i) * static_cast<std::size_t>(light_.size2) +
                                    static_cast<std::size_t>(j)]];
}

void AreaLight::want(int i, int j)
{
    std::uint32_t& place =
        area_.place[static_cast<std::size_t>(i) * static_cast<std::size_t>(light_.size2) + static_cast<std::size_t>(j)];
    const bool fresh = place == AreaScratch::kNone;
    if (fresh) {
        place = static_cast<std::uint32_t>(area_.known.size());
        area_.known.push_back(0);
        area_.row.push_back(i);
        area_.column.push_back(j);
        if (area_.values.size() < area_.known.size()) area_.values.emplace_back();
    }
    // What is asked for again is one of the corners asked for just before.
    constexpr std::ptrdiff_t kCorners = 16;
    const auto end = area_.wanted.end(), begin = end - std::min<std::ptrdiff_t>(kCorners, end - area_.wanted.begin());
    if (fresh || std::find(begin, end, place) == end) area_.wanted.push_back(place);
}

/// The nodes wanted, for the hits that do not know them.
void AreaLight::ask(HitMask hits)
{
    if (by_hit_)
        for_each_hit(hits, [&](std::size_t k) {
            for (const std::uint32_t n : area_.wanted) ask(n, HitMask{1} << k);
        });
    else
        for (const std::uint32_t n : area_.wanted) ask(n, hits);
    area_.wanted.clear();
    trace_samples();
}

void AreaLight::ask(std::uint32_t node, HitMask hits)
{
    HitMask& known = area_.known[node];
    const HitMask asking = hits & ~known;
    known |= asking;
    for_each_hit(asking, [&](std::size_t k) {
        node_[samples_] = node;
        hit_[samples_++] = static_cast<std::uint32_t>(k);
        if (samples_ == kRays) trace_samples();
    });
}

void AreaLight::rectangle(int i1, int j1, int i2, int j2, int depth, HitMask hits, TileColors& out)
{
    HitMask divided = i2 - i1 > 1 || j2 - j1 > 1 ? hits : 0;
    {
        const TileColors &c00 = value(i1, j1), &c10 = value(i2, j1), &c01 = value(i1, j2), &c11 = value(i2, j2);
        if (divided != 0 && depth >= light_.adaptive)
            divided &= differ(hits, c00, c10) | differ(hits, c00, c01) | differ(hits, c11, c10) |
                       differ(hits, c11, c01);
        each_lane(hits, [&](std::size_t k, auto c) {
            (out.*c)[k] = ((c00.*c)[k] + (c10.*c)[k] + (c01.*c)[k] + (c11.*c)[k]) * 0.25f;
        });
    }
    if (divided == 0) return;
    const int i_low = (i1 + i2) / 2, i_high = (i1 + i2 + 1) / 2, j_low = (j1 + j2) / 2, j_high = (j1 + j2 + 1) / 2;
    const int quarters[4][4] = {
        {i1, j1, i_low, j_low}, {i_high, j1, i2, j_low}, {i1, j_high, i_low, j2}, {i_high, j_high, i2, j2}};
    if (depth >= light_.adaptive) {
        for (const auto& q : quarters) want(q[0], q[1]), want(q[2], q[1]), want(q[0], q[3]), want(q[2], q[3]);
        ask(divided);
    }
    TileColors sum, quarter;
    for (int c = 0; c < 4; ++c) {
        const auto& q = quarters[c];
        rectangle(q[0], q[1], q[2], q[3], depth + 1, divided, c == 0 ? sum : quarter);
        if (c == 0) continue;
        each_lane(divided, [&](std::size_t k, auto of) { (sum.*of)[k] += (quarter.*of)[k]; });
    }
    const LaneMask here(divided);
    each_lane(divided,
              [&](std::size_t k, auto of) { (out.*of)[k] = here[k] != 0 ? (sum.*of)[k] * 0.25f : (out.*of)[k]; });
}

void AreaLight::trace_samples()
{
    if (samples_ == 0) return;
    std::fill(node_.begin() + static_cast<std::ptrdiff_t>(samples_), node_.end(), node_[0]);
    std::fill(hit_.begin() + static_cast<std::ptrdiff_t>(samples_), hit_.end(), hit_[0]);
    make_rays();
    const csg::RayTile& rays = scratch_.rays;
    csg::CrossingTile& met = scratch_.crossings;
    csg::Scratch& geometry = context_.scratch.geometry;
    if (light_.shadowless) {
        met.ending.fill(Shadow::Clear);
    } else {
        context_.scratch.counts.shadow += samples_;
        if (scratch_.traits.filters)
            shaft_ ? context_.world.shadow_crossings(rays, *shaft_, geometry, met)
                   : context_.world.shadow_crossings(rays, geometry, met);
        else
            shaft_ ? context_.world.shadow(rays, *shaft_, geometry, met.ending.data())
                   : context_.world.shadow(rays, geometry, met.ending.data());
    }
    for (std::size_t first = 0; first < samples_;) {
        std::size_t last = first + 1;
        while (last < samples_ && node_[last] == node_[first]) ++last;
        keep(first, last);
        first = last;
    }
    samples_ = 0;
}

/// What samples first <= n < last of one node found.
void AreaLight::keep(std::size_t first, std::size_t last)
{
    const csg::RayTile& rays = scratch_.rays;
    const csg::CrossingTile& met = scratch_.crossings;
    HitMask here = 0, lit = 0, other = 0;
    for (std::size_t n = first; n < last; ++n) {
        const HitMask bit = HitMask{1} << hit_[n];
        here |= bit;
        if (!(distance_[n] > -csg::kInfinity)) continue;  // it does not see the light
        const Shadow ending = met.ending[n];
        const bool near = rays.t_max[n] <= rays.t_min[n];  // too near to the light for a shadow
        if (ending == Shadow::Blocked && !near) continue;
        lit |= bit;
        if (ending == Shadow::Filtered && !near) other |= bit;
    }
    TileColors& value = area_.values[node_[first]];
    constexpr std::size_t kFew = 16;  // hits that are cheaper one by one
    if (last - first < kFew) {
        for (std::size_t n = first; n < last; ++n)
            value.set(hit_[n], has(lit, hit_[n]) ? color_[hit_[n]] : glm::vec3(0));
    } else {
        const LaneMask mine(here), bright(lit);
        each_lane(here, [&](std::size_t k, auto c) {
            const float v = bright[k] != 0 ? (color_.*c)[k] : 0.0f;
            (value.*c)[k] = mine[k] != 0 ? v : (value.*c)[k];
        });
    }
    if (light_.atmosphere) keep_rests(first, last);
    if (other != 0) keep_filtered(first, last, other, value);
}

void AreaLight::keep_filtered(std::size_t first, std::size_t last, HitMask hits, TileColors& value)
{
    for (std::size_t n = first; n < last; ++n)
        if (has(hits, hit_[n])) value.set(hit_[n], sample_color(n));
}

void AreaLight::keep_rests(std::size_t first, std::size_t last)
{
    for (std::size_t n = first; n < last; ++n) rests_[hit_[n]] = {{x_[n], y_[n], z_[n]}, 0.0, distance_[n]};
}

/// Of a sample whose shadow ray crosses what filters light.
glm::vec3 AreaLight::sample_color(std::size_t ray)
{
    csg::CrossingTile& met = scratch_.crossings;
    const std::size_t k = hit_[ray];
    const light::Illumination lit{{x_[ray], y_[ray], z_[ray]}, distance_[ray], color_[k]};
    const glm::dvec3 point = scratch_.hits.point(k);
    const bool too_many = met.count[ray] == csg::CrossingTile::kTooMany;
    double unused = 0.0;
    const ShadowAir air{light_.atmosphere, nullptr, 0, light_.atmosphere ? &rests_[k].from : &unused};
    const PhotonShadow& caught = scratch_.photon_shadow;
    if (too_many || scratch_.traits.restarts()) {
        const glm::vec3 passed = filtered_light(context_, point, from_[k], *interiors_[k], lit, lit.color, air,
                                                too_many ? nullptr : met.hits[ray].data());
        const auto& crossings = context_.scratch.crossings;
        return caught.stops(k, crossings.data(), crossings.size()) ? glm::vec3(0) : passed;
    }
    if (caught.stops(k, met.hits[ray].data(), met.count[ray])) return glm::vec3(0);
    return shadow_transmittance(context_, point, from_[k], *interiors_[k], lit, false, met.hits[ray].data(),
                                met.count[ray], air);
}

}  // namespace trace
