#include "render/kernel/radiosity/gather.h"

#include "render/kernel/gather/indirect_light.h"
#include "render/kernel/radiosity/samples/field.h"
#include "render/kernel/radiosity/sorted_rays.h"
#include "numbers/random.h"
#include "render/kernel/context/shade_tile.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/kernel/context/context.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace trace::radiosity {
namespace {

constexpr std::uint32_t kLowWays = 64, kHighWays = 32;  ///< directions are sorted by a number below their product
constexpr double kNothing = 2e10;                       ///< how far off the nearest thing is where there is none

class Gatherer {
public:
    explicit Gatherer(Context& context)
        : context_(context), field_(*context.indirect->radiosity),
          rules_(field_.rules[static_cast<std::size_t>(context.bounce)]), scratch_(context.scratch.gather()),
          nested_(context.gathering(rules_)),
          last_(nested_.bounce >= field_.settings().recursion_limit && !field_.black.empty())
    {
        first_.weight = rules_.weight;
        first_.level = rules_.level;
        first_.kind = plan::RayKind::Gather;
        scratch_.shaded_rays.common_origin = false;
    }

    void run(HitMask which)
    {
        scratch_.pending.clear();
        bool bent = false;
        for_each_hit(which, [&](std::size_t i) {
            begin(i);
            bent = bent || scratch_.gatherings[i].bent;
        });
        if (!bent && last_) {
            for_each_hit(which, [&](std::size_t i) { alone(i); });
            shade_waiting();
            for_each_hit(which, [&](std::size_t i) { finish(i); });
            return;
        }
        for_each_hit(which, [&](std::size_t i) {
            for (int ray = 0; ray < rules_.rays; ++ray)
                scratch_.pending.push_back({direction(scratch_.gatherings[i], scratch_.requests[i]),
                                            static_cast<std::uint16_t>(ray), static_cast<std::uint8_t>(i)});
        });
        sort();
        trace_tiles();
        for_each_hit(which, [&](std::size_t i) { finish(i); });
    }

private:
    void begin(std::size_t i)
    {
        Gathering& g = scratch_.gatherings[i] = {};
        const Request& of = scratch_.requests[i];
        const glm::dvec3 off = glm::abs(of.bent - of.normal);
        g.bent = field_.settings().normal && off.x + off.y + off.z >= kNearlyZero;
        g.nearest = kNothing;
        set_frame(g, g.bent ? of.bent : of.normal);
        const std::size_t pool = field_.directions.size();
        if (context_.filling != nullptr) {
            std::size_t& next = context_.filling->next[static_cast<std::size_t>(context_.bounce)];
            g.next = next;
            if (!g.bent) next = (next + static_cast<std::size_t>(rules_.rays)) % pool;
        } else {
            const double at = numbers::random_of(numbers::random_seed(of.point, of.normal),
                                                 static_cast<std::uint32_t>(context_.bounce), 0);
            g.next = static_cast<std::size_t>(at * static_cast<double>(pool)) * static_cast<std::size_t>(rules_.rays) %
                     pool;
        }
    }

    /// POV-Ray's: y becomes the normal.
    static void set_frame(Gathering& g, const glm::dvec3& n)
    {
        if (std::abs(n.y) > 0.999) {
            const double sign = n.y > 0.0 ? 1.0 : -1.0;
            g.x = {sign, 0, 0}, g.y = {0, sign, 0}, g.z = {0, 0, sign};
            return;
        }
        g.y = n;
        g.x = glm::normalize(glm::cross(n, std::abs(n.z) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1)));
        g.z = glm::normalize(glm::cross(g.x, n));
    }

    glm::dvec3 take(Gathering& g) const
    {
        const glm::dvec3& v = field_.directions[g.next];
        g.next = g.next + 1 == field_.directions.size() ? 0 : g.next + 1;
        return g.x * v.x + g.y * v.y + g.z * v.z;
    }

    glm::dvec3 direction(Gathering& g, const Request& of) const
    {
        const int most = std::min(5 * rules_.rays, field_.settings().pool_size());
        while (g.bent && g.examined < most) {
            ++g.examined;
            const glm::dvec3 d = take(g);
            if (glm::dot(d, of.normal) > 0.0) return d;
        }
        if (g.bent) {
            g.bent = false;
            set_frame(g, of.normal);
        }
        if (g.examined > 0) ++g.unbent;
        return take(g);
    }

    /// By octants, and by curves through them: neighbours point nearly the same way.
    static std::uint32_t way(const glm::dvec3& d)
    {
        constexpr double kSteps = 15.99;
        const glm::dvec3 a = glm::abs(d);
        const double scale = kSteps / (a.x + a.y + a.z);
        const auto spread = [](std::uint32_t v) {  // every other bit
            v = (v | v << 2) & 0x33u;
            return (v | v << 1) & 0x55u;
        };
        const std::uint32_t octant = (d.x < 0.0 ? 1u : 0u) | (d.y < 0.0 ? 2u : 0u) | (d.z < 0.0 ? 4u : 0u);
        return octant << 8 | spread(static_cast<std::uint32_t>(a.x * scale)) << 1 |
               spread(static_cast<std::uint32_t>(a.z * scale));
    }

    /// What the camera sees lies together, and rays that point the same way form a beam; points of later bounces are
    /// scattered, and a beam starts in one of them. In the first pass rays stay in order: later ones are to find what
    /// earlier ones have gathered deeper down.
    void sort()
    {
        const auto count = static_cast<std::uint32_t>(scratch_.pending.size());
        scratch_.order.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) scratch_.order[i] = i;
        if (context_.filling != nullptr && context_.filling->in_order) return;
        scratch_.keys.clear();
        for (const GatherRay& ray : scratch_.pending)
            scratch_.keys.push_back(static_cast<std::uint16_t>(way(ray.direction)));
        count_out(kLowWays, [this](std::uint32_t i) { return scratch_.keys[i] % kLowWays; });
        count_out(kHighWays, [this](std::uint32_t i) { return scratch_.keys[i] / kLowWays; });
        if (context_.bounce > 0)
            count_out(kTileRays, [this](std::uint32_t i) { return std::uint32_t{scratch_.pending[i].owner}; });
    }

    /// Sorts the rays by a small number, those that share one as they were.
    template <class Key>
    void count_out(std::size_t keys, Key&& key)
    {
        std::vector<std::uint32_t>& start = scratch_.start;
        start.assign(keys + 1, 0);
        for (const std::uint32_t i : scratch_.order) ++start[key(i) + 1];
        for (std::size_t k = 1; k <= keys; ++k) start[k] += start[k - 1];
        scratch_.before.swap(scratch_.order);
        scratch_.order.resize(scratch_.before.size());
        for (const std::uint32_t i : scratch_.before) scratch_.order[start[key(i)]++] = i;
    }

    /// The rays of a request, without those of others: they start in one point and are sorted beforehand. For rays
    /// that find no samples, whose order is of no account.
    void alone(std::size_t i)
    {
        const Gathering& g = scratch_.gatherings[i];
        const Request& of = scratch_.requests[i];
        RayTile& rays = scratch_.rays;
        rays.common_origin = true;
        rays.ox.fill(of.point.x);
        rays.oy.fill(of.point.y);
        rays.oz.fill(of.point.z);
        rays.t_min.fill(of.start);
        rays.t_max.fill(numbers::kInfinity);
        scratch_.owner.fill(static_cast<std::uint8_t>(i));
        SortedRays sorted(field_.order, g.next, static_cast<std::size_t>(rules_.rays), scratch_);
        while (sorted.next(g)) trace_alone(i);
    }

    /// Traces the tile at hand, all of one request. Those that matter are shaded when there are enough of them.
    void trace_alone(std::size_t i)
    {
        const RayTile& rays = scratch_.rays;
        const auto count = static_cast<std::size_t>(rays.count);
        context_.scratch.counts.gathered += static_cast<std::uint64_t>(count);
        nested_.world.nearest(rays, bit(plan::RayKind::Gather), nested_.scratch.geometry, scratch_.hits);
        Gathering& g = scratch_.gatherings[i];
        g.rays += rays.count;
        measure_all(g, count);
        std::size_t shaded = 0, black_ones = 0;
        for (std::size_t k = 0; k < count; ++k) {
            if (black(k)) ++black_ones;
            else if (matters(k)) scratch_.shaded[shaded++] = static_cast<std::uint8_t>(k);
        }
        g.quality += static_cast<double>(black_ones);
        if (shaded == count) return shade(shaded);
        for (std::size_t j = 0; j < shaded; ++j) wait(i, scratch_.shaded[j]);
    }

    /// measure() of the first rays of the tile.
    void measure_all(Gathering& g, std::size_t count)
    {
        const std::array<double, kTileRays>& t = scratch_.hits.t;
        for (std::size_t k = 0; k < count; ++k) scratch_.inverse[k] = 1.0 / t[k];  // 0 of rays that hit nothing
        std::array<double, 4> sums{};  // so many that none waits for the one before
        std::size_t k = 0;
        for (; k + 4 <= count; k += 4)
            for (std::size_t s = 0; s < 4; ++s) sums[s] += scratch_.inverse[k + s];
        for (; k < count; ++k) sums[0] += scratch_.inverse[k];
        g.inverse += (sums[0] + sums[1]) + (sums[2] + sums[3]);
        for (k = 0; k < count; ++k) {
            if (!(t[k] < g.nearest)) continue;
            g.nearest = t[k];
            g.nearest_way = scratch_.rays.ray(static_cast<int>(k)).direction;
        }
    }

    void wait(std::size_t i, std::size_t k)
    {
        const std::size_t j = scratch_.waiting++;
        scratch_.shaded_rays.set(j, scratch_.rays.ray(static_cast<int>(k)), scratch_.rays.t_min[k], numbers::kInfinity);
        scratch_.shaded_hits.set(static_cast<int>(j), scratch_.hits.at(static_cast<int>(k)));
        scratch_.waiting_owner[j] = static_cast<std::uint8_t>(i);
        scratch_.waiting_share[j] = importance(k);
        if (scratch_.waiting == kTileRays) shade_waiting();
    }

    void shade_waiting()
    {
        const std::size_t count = scratch_.waiting;
        if (count == 0) return;
        scratch_.shaded_rays.count = static_cast<int>(count);
        nested_.scratch.shade.quality.fill(1.0f);
        shade_tile(nested_, scratch_.shaded_rays, scratch_.shaded_hits, first_, nullptr, scratch_.colors.data());
        for (std::size_t j = 0; j < count; ++j)
            sum_up(scratch_.gatherings[scratch_.waiting_owner[j]], scratch_.waiting_share[j], j);
        scratch_.waiting = 0;
    }

    void trace_tiles()
    {
        for (std::size_t first = 0; first < scratch_.order.size(); first += kTileRays) {
            const std::size_t count = std::min<std::size_t>(kTileRays, scratch_.order.size() - first);
            RayTile& rays = scratch_.rays;
            rays.count = static_cast<int>(count);
            rays.common_origin = true;
            for (std::size_t k = 0; k < count; ++k) {
                const GatherRay& ray = scratch_.pending[scratch_.order[first + k]];
                const Request& of = scratch_.requests[ray.owner];
                rays.set(k, {of.point, ray.direction}, of.start, numbers::kInfinity);
                scratch_.owner[k] = ray.owner;
                scratch_.number[k] = ray.number;
                rays.common_origin = rays.common_origin && ray.owner == scratch_.owner[0];
            }
            trace_tile();
        }
    }

    /// Traces the rays of the tile at hand and shades those that matter.
    void trace_tile()
    {
        const RayTile& rays = scratch_.rays;
        context_.scratch.counts.gathered += static_cast<std::uint64_t>(rays.count);
        nested_.world.nearest(rays, bit(plan::RayKind::Gather), nested_.scratch.geometry, scratch_.hits);
        std::size_t shaded = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(rays.count); ++k) {
            measure(k);
            if (black(k)) {
                scratch_.gatherings[scratch_.owner[k]].quality += 1.0;
                continue;
            }
            if (matters(k)) scratch_.shaded[shaded++] = static_cast<std::uint8_t>(k);
        }
        if (shaded > 0) shade(shaded);
    }

    /// Whether the ray brings nothing: not even its colour has to be found then.
    bool black(std::size_t k) const
    {
        const csg::SurfaceId surface = scratch_.hits.surface[k];
        return last_ && surface != csg::kNoSurface && field_.black[surface] != 0;
    }

    /// Of surfaces that weigh less only the first rays are shaded.
    bool matters(std::size_t k) const
    {
        return static_cast<double>(importance(k)) * (rules_.rays - 1) >= scratch_.number[k];
    }

    float importance(std::size_t k) const
    {
        const csg::SurfaceId surface = scratch_.hits.surface[k];
        return surface == csg::kNoSurface ? field_.plan->importance : context_.scene.surfaces[surface].importance;
    }

    void measure(std::size_t k)
    {
        Gathering& g = scratch_.gatherings[scratch_.owner[k]];
        ++g.rays;
        if (scratch_.hits.surface[k] == csg::kNoSurface) return;
        const double t = scratch_.hits.t[k];
        g.inverse += 1.0 / t;
        if (!(t < g.nearest)) return;
        g.nearest = t;
        g.nearest_way = scratch_.rays.ray(static_cast<int>(k)).direction;
    }

    void shade(std::size_t count)
    {
        const bool all = count == static_cast<std::size_t>(scratch_.rays.count);
        if (!all) {
            for (std::size_t j = 0; j < count; ++j) {
                const std::size_t k = scratch_.shaded[j];
                scratch_.shaded_rays.set(j, scratch_.rays.ray(static_cast<int>(k)), scratch_.rays.t_min[k],
                                         numbers::kInfinity);
                scratch_.shaded_hits.set(static_cast<int>(j), scratch_.hits.at(static_cast<int>(k)));
            }
            scratch_.shaded_rays.count = static_cast<int>(count);
        }
        nested_.scratch.shade.quality.fill(1.0f);
        shade_tile(nested_, all ? scratch_.rays : scratch_.shaded_rays, all ? scratch_.hits : scratch_.shaded_hits,
                   first_, nullptr, scratch_.colors.data());
        for (std::size_t j = 0; j < count; ++j)
            sum_up(scratch_.gatherings[scratch_.owner[scratch_.shaded[j]]], importance(scratch_.shaded[j]), j);
    }

    void sum_up(Gathering& g, float importance, std::size_t shaded)
    {
        glm::dvec3 color(scratch_.colors[shaded].rgb());
        const double most = field_.settings().max_sample, largest = std::max({color.x, color.y, color.z});
        if (most > 0.0 && largest > most) color *= most / largest;
        auto quality = static_cast<double>(nested_.scratch.shade.quality[shaded]);
        const auto share = static_cast<double>(importance);
        if (share < 1.0) quality *= rules_.rays / (std::floor(share * (rules_.rays - 1)) + 1.0);
        g.sum += color * quality;
        g.quality += quality;
    }

    void finish(std::size_t i)
    {
        const Gathering& g = scratch_.gatherings[i];
        const Request& of = scratch_.requests[i];
        if (context_.filling != nullptr && g.examined > 0)
            context_.filling->next[static_cast<std::size_t>(context_.bounce)] = g.next;
        Sample& s = scratch_.made[i];
        s.point = of.point;
        const bool bent = field_.settings().normal && 2 * g.unbent <= g.rays;
        s.normal = glm::vec3(bent ? of.bent : of.normal);
        s.color = glm::vec3(g.quality > 0.0 ? g.sum / g.quality : g.sum);
        s.quality = static_cast<float>(g.quality / g.rays);
        s.nearest = static_cast<float>(g.nearest);
        s.nearest_way = glm::vec3(g.nearest_way);
        const double e = glm::distance(field_.eye, of.point), least = e * rules_.least_reach,
                     most = e * rules_.most_reach;
        const double mean = g.inverse > 0.0 ? g.rays / g.inverse : numbers::kInfinity;
        s.reach = static_cast<float>(std::min(std::max(mean, least), most));
        constexpr double kTooNear = 0.0001;
        scratch_.kept[i] = g.nearest > kTooNear * most;
    }

    Context& context_;
    const Field& field_;
    const BounceRules& rules_;
    GatherScratch& scratch_;
    Context nested_;
    RayState first_;
    const bool last_;  ///< no light is gathered for what its rays meet, and some of that may be black
};

}  // namespace

void gather(Context& context, std::uint64_t which)
{
    context.scratch.counts.samples += static_cast<std::uint64_t>(std::popcount(which));
    Gatherer(context).run(which);
}

}  // namespace trace::radiosity

namespace trace {

Context::Context(const Context& outer, const radiosity::BounceRules& rules)
    : scene(outer.scene), traits(outer.traits), world(outer.world), scratch(outer.scratch.nested()),
      indirect(outer.indirect), lights(outer.scene.radiosity->lights),
      max_trace_level(std::max(outer.scene.settings.max_trace_level, rules.level + 1)),
      adc_bailout(outer.scene.radiosity->settings.adc_bailout), bounce(outer.bounce + 1), filling(outer.filling)
{}

Context Context::gathering(const radiosity::BounceRules& rules) const { return {*this, rules}; }

}  // namespace trace
