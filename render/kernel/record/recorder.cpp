#include "render/kernel/record/recorder.h"

#include "render/texture/finish.h"

#include <algorithm>
#include <array>

namespace trace {
namespace {

/// What a row gains between two looks. Sums that are infinite stay so: nothing is added to them any more.
glm::dvec3 gained(const glm::vec3& before, const glm::vec3& now)
{
    glm::dvec3 out(0);
    for (int c = 0; c < 3; ++c)
        if (before[c] != now[c]) out[c] = static_cast<double>(now[c]) - static_cast<double>(before[c]);
    return out;
}

}  // namespace

Recorder::Recorder(const plan::CompiledScene& scene, ShadeScratch& scratch, Record& into)
    : scene_(scene), world_(scene.world()), scratch_(scratch), record_(into)
{
    scratch.recorder = this;
}

void Recorder::air(HitMask segments, RecordedAir::Effect effect)
{
    for_each_hit(segments, [&](std::size_t k) {
        const Air before = air_[k].empty() ? Air() : air_[k].back().so_far;
        const Air& now = scratch_.air[k];
        if (now.share != before.share || now.glow != before.glow || now.clear != before.clear)
            air_[k].push_back({effect, now});
    });
}

void Recorder::pigments(RowPage& page, HitMask hits, HitMask clear, const texture::ColorPoints& of)
{
    for_each_hit(hits, [&](std::size_t k) {
        const scene::Color c = of.at(k);
        page.passes[k] = {c.filter, c.transmit};
        page.alpha[k] = has(clear, k) ? texture::opacity(c, scene_.textures.legacy_opacity) : 1.0f;
    });
}

/// A shadow ray of hit k, and how it ended.
void Recorder::shadow_ray(std::size_t k, const csg::Ray& ray, double from, double to, bool blocked, bool filtered)
{
    RecordedShadow& shadow = shadows_[k];
    ++shadow.asked;
    shadow.blocked += blocked ? 1 : 0;
    shadow.filtered += filtered ? 1 : 0;
    if (!(blocked || filtered) || shadow.surface != csg::kNoSurface) return;
    const Hit first = world_.nearest(ray, from, to, bit(plan::RayKind::Shadow), geometry_);
    if (!first.found()) return;
    shadow.surface = first.surface;
    shadow.distance = first.t;
}

void Recorder::shadow_rays(bool in_order)
{
    for (std::size_t i = 0; i < static_cast<std::size_t>(scratch_.shadow.rays.count); ++i) {
        const std::size_t k = in_order ? i : scratch_.shadow.lane[i];
        const Shadow ending = scratch_.shadow.crossings.ending[i];
        shadow_ray(k, {scratch_.hits.point(k), scratch_.lamp.light.direction(k)}, scratch_.shadow.ends.from[k],
                   scratch_.shadow.ends.to[k], ending == Shadow::Blocked, ending == Shadow::Filtered);
    }
}

void Recorder::area_rays(const std::uint32_t* hits, std::size_t count, HitMask lit, HitMask filtered)
{
    const RayTile& rays = scratch_.shadow.rays;
    for (std::size_t i = 0; i < count; ++i)
        shadow_ray(hits[i], rays.ray(static_cast<int>(i)), rays.t_min[i], rays.t_max[i], !has(lit, i),
                   has(filtered, i));
}

void Recorder::diffuse(const RowPage& page, HitMask rows, const TileFloats& amount)
{
    Depth& at = depth(static_cast<std::size_t>(&page - scratch_.rows.pages.data()));
    for_each_hit(rows & page.lit, [&](std::size_t k) {
        at.diffuse[k] += glm::dvec3(amount[k] * page.pigment[k] * scratch_.lamp.reaching[k]);
    });
}

void Recorder::lamp(std::size_t depths, std::size_t number, HitMask asked)
{
    for_each_hit(asked, [&](std::size_t k) {
        lamps_[k].push_back({static_cast<std::uint32_t>(number), scratch_.lamp.light.direction(k),
                             scratch_.lamp.colors[k], shadows_[k]});
        shadows_[k] = {};
    });
    gains(depths, static_cast<std::int32_t>(number));
}

void Recorder::gains(std::size_t depths, std::int32_t source)
{
    for (std::size_t d = 0; d < depths; ++d) {
        Depth& at = depth(d);
        for_each_hit(scratch_.rows.pages[d].holds, [&](std::size_t k) {
            const glm::vec3 now = scratch_.rows.pages[d].gained[k];
            const glm::dvec3 sum = gained(at.before[k], now);
            if (sum != glm::dvec3(0)) at.gains[k].push_back({source, sum, at.diffuse[k]});
            at.before[k] = now;
            at.diffuse[k] = {};
        });
    }
}

void Recorder::scalar_lamp(std::size_t number, const glm::vec3& so_far)
{
    const glm::dvec3 sum = gained(scalar_before_, so_far);
    if (sum != glm::dvec3(0)) scalar_.push_back({static_cast<std::int32_t>(number), sum, scalar_diffuse_});
    scalar_before_ = so_far;
    scalar_diffuse_ = {};
}

void Recorder::scalar_row(std::size_t d, std::size_t k)
{
    depth(d).gains[k] = std::move(scalar_);
    depth(d).before[k] = scratch_.rows.pages[d].gained[k];
    scalar_.clear();
    scalar_before_ = {};
}

void Recorder::sky(HitMask missed, const scene::Color* of)
{
    for_each_hit(missed, [&](std::size_t k) { sky_[k] = of[k]; });
}

void Recorder::tile(const SegmentTile& tile, std::size_t depths, HitMask dimmed, HitMask alone)
{
    const RayQueue& queue = scratch_.queue;
    const RayQueue::Frame& frame = queue.frame();
    number_slots(tile, frame.colors);
    const auto first = static_cast<std::uint32_t>(record_.rays.size());
    air(dimmed, RecordedAir::Effect::Fog);
    for (std::size_t k = 0; k < static_cast<std::size_t>(tile.count()); ++k) {
        RecordedRay& ray = record_.rays.emplace_back();
        ray.slot = slots_[tile.slot(k)];
        ray.level = tile.level(k);
        ray.state = tile.state(k);
        ray.met = tile.hits.at(static_cast<int>(k));
        ray.air = std::move(air_[k]);
        ray.lamps = std::move(lamps_[k]);
        ray.seen = sky_[k];
        ray.ends = !has(tile.found(), k) || has(alone, k);
        if (!has(tile.found(), k)) continue;
        ray.point = scratch_.hits.point(k);
        ray.normal = scratch_.hits.normal(k);
        ray.from_inside = has(tile.from_inside(), k);
        for (std::size_t d = 0; d < depths && has(scratch_.rows.pages[d].holds, k); ++d) add_row(ray, d, k);
    }
    for (const RecordedEntry& entry : entries_)
        record_.entries.push_back({slots_[entry.slot], entry.entry, entry.of_map});
    add_nodes(tile, frame, first);
    entries_.clear();
    depths_.clear();
    air_ = {};
    lamps_ = {};
    shadows_ = {};
    sky_ = {};
}

Recorder::Depth& Recorder::depth(std::size_t d)
{
    while (depths_.size() <= d) depths_.emplace_back();
    return depths_[d];
}

/// Numbers for the colours that came with the tile: its queue's places are taken again by other tiles.
void Recorder::number_slots(const SegmentTile& tile, std::size_t first)
{
    slots_.resize(scratch_.queue.colors.size());
    const auto number = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) slots_[i] = record_.slots++;
    };
    if (!tile.is_queued()) {
        number(0, first);
        record_.camera.insert(record_.camera.end(), slots_.begin(),
                              slots_.begin() + static_cast<std::ptrdiff_t>(first));
    }
    number(first, slots_.size());
}

void Recorder::add_row(RecordedRay& ray, std::size_t d, std::size_t k)
{
    const RowPage& page = scratch_.rows.pages[d];
    const glm::vec3 rgb = page.pigment[k];
    ray.rows.push_back({{rgb.x, rgb.y, rgb.z, page.passes[k].x, page.passes[k].y},
                        page.alpha[k],
                        has(page.bent, k) ? page.normal(k) : ray.normal,
                        page.finish[k],
                        d == 0 ? glm::vec3(1) : page.filter[k],
                        page.glow[k],
                        d < depths_.size() ? std::move(depths_[d].gains[k]) : std::vector<RecordedGain>()});
}

void Recorder::add_nodes(const SegmentTile& tile, const RayQueue::Frame& frame, std::uint32_t first_ray)
{
    const RayQueue& queue = scratch_.queue;
    const auto moved = static_cast<std::uint32_t>(record_.terms.size() - frame.terms);
    for (std::size_t i = frame.terms; i < queue.terms.size(); ++i) {
        record_.terms.push_back(queue.terms[i]);
        record_.terms.back().slot = numbered(queue.terms[i].slot);
    }
    const std::size_t first_node = record_.nodes.size();
    for (std::size_t i = frame.nodes; i < queue.nodes.size(); ++i) {
        ShadeNode& node = record_.nodes.emplace_back(queue.nodes[i]);
        node.out = numbered(node.out);
        node.through = numbered(node.through);
        node.first = node.count != 0 ? node.first + moved : 0;
        record_.owners.push_back({0, 0, 0});
    }
    for (const ClosingNode& of : scratch_.rows.closing)
        record_.owners[first_node + of.node - frame.nodes] = {first_ray + of.hit, of.first, of.last};
    for (std::size_t k = 0; k < static_cast<std::size_t>(tile.count()); ++k)
        own_nodes(first_node, first_ray + static_cast<std::uint32_t>(k));
}

/// The nodes of a ray's colour are the ray's.
void Recorder::own_nodes(std::size_t first_node, std::uint32_t ray)
{
    std::vector<ColorSlot> of{record_.rays[ray].slot};
    for (std::size_t i = first_node; i < record_.nodes.size(); ++i) {
        const ShadeNode& node = record_.nodes[i];
        if (std::find(of.begin(), of.end(), node.out) == of.end()) continue;
        record_.owners[i].ray = ray;
        if (node.kind != ShadeNode::Kind::Surface || node.through != kNoSlot) of.push_back(node.through);
        for (std::uint32_t t = node.first; t < node.first + node.count; ++t) of.push_back(record_.terms[t].slot);
    }
}

}  // namespace trace
