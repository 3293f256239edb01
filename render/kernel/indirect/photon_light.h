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
        glm::dvec3 low(csg::kInfinity), high(-csg::kInfinity);
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
        const bool in_lanes = shiny && !scalar;
        glm::vec3 sum(0);
        const std::vector<NearPhotons::Near>& found = scratch_.photons.near.found;
        alignas(64) std::array<double, csg::lanes::kDoubles> strengths, raised;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const std::size_t lane = i % strengths.size();
            if (in_lanes && lane == 0) find_strengths(met, i, strengths.data());
            if (lane == 0) find_raised(met, i, raised.data());
            const PhotonRay& photon = map_.ray(found[i].photon);
            const glm::dvec3 back(photon.back);
            bool behind = false;
            if (!surface.double_illuminate && glm::dot(normal, back) < kNearlyZero) {
                if (finish.diffuse_back == 0.0f) continue;
                behind = true;
            }
            const glm::vec3 color = photon.flux / static_cast<float>(std::clamp(glm::dot(raw, back), kFlattest, 1.0));
            const double strength = behind || !shiny ? 0.0 : in_lanes ? strengths[lane] : highlight(met, back);
            glm::vec3 gained = surface_light(met, back, color, behind, strength, 0.0, [&] { return raised[lane]; });
            if (finish.irid > 0.0f) gained *= film_color(context_, place, finish, normal, back);
            sum += gained;
        }
        return sum;
    }

    /// Strengths of the highlights of photons from the first-th on, a vector of them; none behind the last.
    void find_strengths(const LitLayer& met, std::size_t first, double* out) const
    {
        using csg::lanes::Double;
        const auto all = [](const glm::dvec3& v) { return LaneVectors{Double(v.x), Double(v.y), Double(v.z)}; };
        const auto amount = [](float f) { return Double(static_cast<double>(f)); };
        const std::vector<NearPhotons::Near>& found = scratch_.photons.near.found;
        constexpr std::size_t kLanes = csg::lanes::kDoubles;
        alignas(64) double x[kLanes], y[kLanes], z[kLanes];
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const glm::dvec3 back(map_.ray(found[std::min(first + lane, found.size() - 1)].photon).back);
            x[lane] = back.x, y[lane] = back.y, z[lane] = back.z;
        }
        const texture::Finish& f = met.finish;
        highlight_strengths(all(met.direction), all(met.normal),
                            {Double::load_aligned(x), Double::load_aligned(y), Double::load_aligned(z)},
                            {amount(f.phong), amount(f.phong_size), amount(f.specular), amount(f.specular_exponent)},
                            (1u << kLanes) - 1)
            .store_aligned(out);
    }

    /// raised_facing() of as many photons.
    void find_raised(const LitLayer& met, std::size_t first, double* out) const
    {
        using csg::lanes::Double;
        const std::vector<NearPhotons::Near>& found = scratch_.photons.near.found;
        for (std::size_t lane = 0; lane < csg::lanes::kDoubles; ++lane) {
            const glm::dvec3 back(map_.ray(found[std::min(first + lane, found.size() - 1)].photon).back);
            out[lane] = std::abs(glm::dot(met.normal, back));
        }
        const float brilliance = met.finish.brilliance;
        if (brilliance == 1.0f) return;
        numbers::pow(Double::load_aligned(out), Double(static_cast<double>(brilliance))).store_aligned(out);
    }

    /// Of diffuse light alone.
    glm::vec3 plain_row(std::size_t k, const RowPage& at, const glm::dvec3& normal) const
    {
        const glm::vec3 n(normal), raw(scratch_.hits.normal(k));
        glm::vec3 sum(0);
        for (const NearPhotons::Near& near : scratch_.photons.near.found) {
            const PhotonRay& photon = map_.ray(near.photon);
            const float facing = glm::dot(n, photon.back);
            const float share = facing < kDark ? 0.0f : facing;
            sum += photon.flux * (share / std::clamp(glm::dot(raw, photon.back), static_cast<float>(kFlattest), 1.0f));
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
