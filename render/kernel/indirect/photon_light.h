#pragma once

#include "numbers/functions/lane_functions.h"
#include "render/kernel/gather/indirect_light.h"
#include "render/kernel/light/direct_batch.h"
#include "render/kernel/light/direct_light.h"
#include "render/kernel/light/highlight_lanes.h"
#include "render/kernel/context/segment_tile.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/kernel/context/photon_shadow.h"

#include <numbers>

/// Light of photons on surfaces, over a tile's rows (spec 6, 3.9).
namespace trace {

class PhotonLightStage {
public:
    PhotonLightStage(Context& context, const SegmentTile& tile, DirectBatch& batch)
        : context_(context), scratch_(context.scratch.shade), map_(context.indirect->photons), tile_(tile),
          batch_(batch)
    {}

    /// Adds to RowPage::gained.
    void run()
    {
        if (map_.empty() || !context_.scene.settings.quality.effects) return;
        const plan::CompiledScene& scene = context_.scene;
        scratch_.photons.near.forget();  // pictures do not depend on the order of tiles
        scratch_.photons.wide.forget();
        HitMask collecting = 0;
        glm::dvec3 low(numbers::kInfinity), high(-numbers::kInfinity);
        for_each_hit(batch_.lit(), [&](std::size_t k) {
            if (!collects(scene, tile_.hits.surface[k])) return;
            collecting |= HitMask{1} << k;
            low = glm::min(low, scratch_.hits.point(k));
            high = glm::max(high, scratch_.hits.point(k));
        });
        if (collecting == 0) return;
        const PhotonReach reach = map_.reach(low, high);
        if (reach.nothing) return;
        for_each_hit(collecting, [&](std::size_t k) { add(k, scene.surfaces[tile_.hits.surface[k]], reach); });
    }

private:
    /// The photons around hit k, for all its rows: the first one that photons light says how the surface lies.
    void add(std::size_t k, const plan::Surface& surface, const PhotonReach& reach)
    {
        bool gathered = false;
        for (std::size_t d = 0; d < batch_.rows(k); ++d) {
            RowPage& at = scratch_.rows.pages[d];
            const texture::Finish& finish = *at.finish[k];
            if (!(finish.diffuse > 0.0f || finish.diffuse_back > 0.0f || finish.phong > 0.0f || finish.specular > 0.0f))
                continue;
            const glm::dvec3 normal = at.bent != 0 ? at.normal(k) : scratch_.hits.normal(k);
            if (!gathered) {
                map_.gather(scratch_.hits.point(k), &normal, reach, scratch_.photons.wide, scratch_.photons.near);
                gathered = true;
                if (scratch_.photons.near.found.empty()) return;
            }
            const double area = std::numbers::pi * scratch_.photons.near.radius2;
            at.gained.set(k, at.gained[k] + row(k, surface, at, normal) / static_cast<float>(area));
        }
    }

    /// What they all give to a row.
    glm::vec3 row(std::size_t k, const plan::Surface& surface, const RowPage& at, const glm::dvec3& normal) const
    {
        const texture::Finish& finish = *at.finish[k];
        const bool scalar = has(at.scalar, k);
        if (!scalar && !has(at.shiny, k) && !has(at.raised, k)) return plain_row(k, at, normal);
        const scene::Color pigment = scalar ? at.scalar_pigment.at(k) : scene::Color::of(at.pigment[k]);
        const double alpha = scalar                   ? static_cast<double>(at.alpha[k])
                             : finish.diffuse != 0.0f ? at.diffuse[k] / static_cast<double>(finish.diffuse)
                                                      : 0.0;
        const glm::dvec3 direction = tile_.ray(k).direction;
        const LitLayer met{finish, pigment, direction, normal, alpha};
        const glm::dvec3 raw = scratch_.hits.normal(k);
        const Hit hit = tile_.hits.at(static_cast<int>(k));
        const HitPlace place = tile_.place(k, tile_.state(k), hit);
        const bool shiny = context_.bounce == 0 && (finish.phong > 0.0f || finish.specular > 0.0f);
        const bool tinted = finish.irid > 0.0f || finish.metallic > 0.0f || scalar;
        glm::vec3 sum(0);
        const std::size_t count = scratch_.photons.near.found.size();
        for (std::size_t first = 0; first < count; first += kLanes) {
            const std::size_t here = std::min(kLanes, count - first);
            const Arriving photons = arriving(first);
            Lanes strengths{}, facing, opening, raised;
            find_cosines(photons, normal, raw, facing, opening);
            find_raised(finish, facing, raised);
            if (shiny && !scalar) find_strengths(met, photons, strengths);
            if (!tinted) {
                add_untinted(met, photons, !surface.double_illuminate, {facing, opening, raised, strengths}, here, sum);
                continue;
            }
            for (std::size_t lane = 0; lane < here; ++lane) {
                const bool behind = !surface.double_illuminate && facing[lane] < kNearlyZero;
                if (behind && finish.diffuse_back == 0.0f) continue;
                const glm::dvec3 back(photons.x[lane], photons.y[lane], photons.z[lane]);
                const glm::vec3 flux(photons.red[lane], photons.green[lane], photons.blue[lane]);
                const double strength = behind || !shiny ? 0.0 : scalar ? highlight(met, back) : strengths[lane];
                glm::vec3 gained = surface_light(met, back, flux / static_cast<float>(opening[lane]), behind, strength,
                                                 0.0, [&] { return raised[lane]; });
                if (finish.irid > 0.0f) gained *= film_color(context_, place, finish, normal, back);
                sum += gained;
            }
        }
        return sum;
    }

    static constexpr std::size_t kLanes = numbers::lanes::kDoubles;
    using Lanes = std::array<double, kLanes>;

    /// A vector of photons: unit vectors to where they came from, and what they bring.
    struct Arriving {
        alignas(64) Lanes x, y, z;
        alignas(64) std::array<float, kLanes> red, green, blue;
    };

    /// Of those that were found, from the first-th on; the last again where there are no more.
    Arriving arriving(std::size_t first) const
    {
        const std::vector<NearPhotons::Near>& found = scratch_.photons.near.found;
        Arriving out;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const PhotonRay& photon = map_.ray(found[std::min(first + lane, found.size() - 1)].photon);
            const glm::dvec3 back(photon.back);
            out.x[lane] = back.x, out.y[lane] = back.y, out.z[lane] = back.z;
            out.red[lane] = photon.flux.x, out.green[lane] = photon.flux.y, out.blue[lane] = photon.flux.z;
        }
        return out;
    }

    /// Cosines with the layer's normal, and with the surface's own: those that come in flat count as if they came less
    /// so.
    static void find_cosines(const Arriving& photons, const glm::dvec3& normal, const glm::dvec3& raw, Lanes& facing,
                             Lanes& opening)
    {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const glm::dvec3 back(photons.x[lane], photons.y[lane], photons.z[lane]);
            facing[lane] = glm::dot(normal, back);
            opening[lane] = std::clamp(glm::dot(raw, back), kFlattest, 1.0);
        }
    }

    /// raised_facing() of each.
    static void find_raised(const texture::Finish& finish, const Lanes& facing, Lanes& raised)
    {
        using numbers::lanes::Double;
        for (std::size_t lane = 0; lane < kLanes; ++lane) raised[lane] = std::abs(facing[lane]);
        if (finish.brilliance == 1.0f) return;
        numbers::pow(Double::load_unaligned(raised.data()), Double(static_cast<double>(finish.brilliance)))
            .store_unaligned(raised.data());
    }

    static void find_strengths(const LitLayer& met, const Arriving& photons, Lanes& strengths)
    {
        using numbers::lanes::Double;
        const auto all = [](const glm::dvec3& v) { return LaneVectors{Double(v.x), Double(v.y), Double(v.z)}; };
        const auto amount = [](float f) { return Double(static_cast<double>(f)); };
        const texture::Finish& f = met.finish;
        highlight_strengths(all(met.direction), all(met.normal),
                            {Double::load_aligned(photons.x.data()), Double::load_aligned(photons.y.data()),
                             Double::load_aligned(photons.z.data())},
                            {amount(f.phong), amount(f.phong_size), amount(f.specular), amount(f.specular_exponent)},
                            (1u << kLanes) - 1)
            .store_unaligned(strengths.data());
    }

    struct Strengths {
        const Lanes &facing, &opening, &raised, &highlights;
    };

    /// surface_light() of photons whose highlights have the light's own colour, for the compiler to put into lanes; one
    /// after the other they are added.
    static void add_untinted(const LitLayer& met, const Arriving& photons, bool one_sided, const Strengths& of,
                             std::size_t count, glm::vec3& sum)
    {
        const double front = static_cast<double>(met.finish.diffuse) * met.alpha,
                     back = static_cast<double>(met.finish.diffuse_back) * met.alpha;
        const glm::vec3 pigment = met.pigment.rgb();
        std::array<float, kLanes> red, green, blue;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const bool behind = one_sided && of.facing[lane] < kNearlyZero;
            const auto diffuse = static_cast<float>(of.raised[lane] * (behind ? back : front)),
                       highlight = static_cast<float>(behind ? 0.0 : of.highlights[lane]),
                       opening = static_cast<float>(of.opening[lane]);
            const float r = photons.red[lane] / opening, g = photons.green[lane] / opening,
                        b = photons.blue[lane] / opening;
            red[lane] = diffuse * pigment.x * r + highlight * r;
            green[lane] = diffuse * pigment.y * g + highlight * g;
            blue[lane] = diffuse * pigment.z * b + highlight * b;
        }
        for (std::size_t lane = 0; lane < count; ++lane) sum += glm::vec3(red[lane], green[lane], blue[lane]);
    }

    /// Of diffuse light alone.
    glm::vec3 plain_row(std::size_t k, const RowPage& at, const glm::dvec3& normal) const
    {
        constexpr std::size_t kMany = 16;
        const glm::vec3 n(normal), raw(scratch_.hits.normal(k));
        const std::vector<NearPhotons::Near>& found = scratch_.photons.near.found;
        glm::vec3 sum(0);
        for (std::size_t first = 0; first < found.size(); first += kMany) {
            const std::size_t count = std::min(kMany, found.size() - first);
            std::array<float, kMany> share{}, opening{};
            std::array<const PhotonRay*, kMany> photons;
            for (std::size_t i = 0; i < count; ++i) {
                photons[i] = &map_.ray(found[first + i].photon);
                share[i] = glm::dot(n, photons[i]->back);
                opening[i] = glm::dot(raw, photons[i]->back);
            }
            for (std::size_t i = 0; i < kMany; ++i)
                share[i] = (share[i] < kDark ? 0.0f : share[i]) /
                           std::clamp(opening[i], static_cast<float>(kFlattest), 1.0f);
            for (std::size_t i = 0; i < count; ++i) sum += photons[i]->flux * share[i];
        }
        return sum * at.pigment[k] * static_cast<float>(at.diffuse[k]);
    }

    static constexpr double kFlattest = 0.1;  ///< cosine: photons that come in flatter count as if they came so

    Context& context_;
    ShadeScratch& scratch_;
    const PhotonMap& map_;
    const SegmentTile& tile_;
    DirectBatch& batch_;
};

}  // namespace trace
