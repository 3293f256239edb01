#include "numbers/lanes.h"
#include "render/kernel/context/projected.h"
#include "render/kernel/light/area_light.h"
#include "numbers/random_lanes.h"

#include <algorithm>
#include <cmath>

// Shadow rays to the samples of an area light, a sample a lane.
namespace trace {
/// Moves the samples within their cells, by numbers of the point and the node (random_at).
void AreaLight::jitter(TileLanes& row, TileLanes& column) const
{
    const csg::RayTile& rays = scratch_.shadow.rays;
    alignas(64) TileLanes by;
    const auto move = [&](TileLanes& of, std::uint32_t number) {
        numbers::random_at(rays.ox.data(), rays.oy.data(), rays.oz.data(), purpose_.data(), number, lanes_, by.data());
        for (std::size_t n = 0; n < lanes_; ++n) of[n] += by[n] - 0.5;
    };
    move(row, 0);
    move(column, 1);
}

/// Where samples of a node lie on the light, for all hits and samples alike (same_places_).
glm::dvec3 AreaLight::node_place(int i, int j) const
{
    const auto [p, q, m] = light::node_shares(light_, i, j);
    return p * m * light_.axis1 + q * m * light_.axis2;
}

/// Places of the samples on the light: light::node_offset, a sample a lane. Their rays have their origins.
void AreaLight::place_on_light()
{
    alignas(64) TileLanes p, q, m;
    std::copy_n(row_.begin(), lanes_, p.begin());
    std::copy_n(column_.begin(), lanes_, q.begin());
    if (light_.jitter) jitter(p, q);
    const auto share = [this](TileLanes& of, int size) {
        if (size <= 1) return of.fill(0.0);
        const double over = size - 1;
        for (std::size_t n = 0; n < lanes_; ++n) of[n] = of[n] / over - 0.5;
    };
    share(p, light_.size1);
    share(q, light_.size2);
    m.fill(1.0);
    if (light_.circular)
        for (std::size_t n = 0; n < lanes_; ++n) {
            p[n] += light::kCircleShift;
            q[n] += light::kCircleShift;
            m[n] = std::max(std::abs(p[n]), std::abs(q[n])) / std::sqrt(p[n] * p[n] + q[n] * q[n]);
        }
    if (light_.circular && light_.orient) {
        for (std::size_t n = 0; n < lanes_; ++n) {
            const light::AreaAxes& axes = axes_[hit_[n]];
            const glm::dvec3 at = (axes.size * p[n] * m[n]) * axes.a + (axes.size * q[n] * m[n]) * axes.b;
            x_[n] = at.x, y_[n] = at.y, z_[n] = at.z;
        }
        return;
    }
    const glm::dvec3 a = light_.axis1, b = light_.axis2;
    for (std::size_t n = 0; n < lanes_; ++n) {
        const double pm = p[n] * m[n], qm = q[n] * m[n];
        x_[n] = pm * a.x + qm * b.x;
        y_[n] = pm * a.y + qm * b.y;
        z_[n] = pm * a.z + qm * b.z;
    }
}

/// Directions and distances to the samples (light::toward), and their shadow rays in ShadeScratch::rays.
void AreaLight::make_rays()
{
    const TileHits& hits = scratch_.hits;
    csg::RayTile& rays = scratch_.shadow.rays;
    rays.common_origin = false;
    rays.count = static_cast<int>(samples_);
    if (asked_[0].hits == ~HitMask{0}) {
        rays.ox = hits.x, rays.oy = hits.y, rays.oz = hits.z, rays.t_min = from_;
    } else {
        for (std::size_t n = 0; n < lanes_; ++n) {
            const std::size_t k = hit_[n];
            rays.ox[n] = hits.x[k], rays.oy[n] = hits.y[k], rays.oz[n] = hits.z[k];
            rays.t_min[n] = from_[k];
        }
    }
    if (!same_places_) place_on_light();
    if (light_.kind == light::Light::Kind::Cylinder || light_.parallel) {
        for (std::size_t n = 0; n < lanes_; ++n) {
            const light::Illumination lit =
                light::toward(light_, {rays.ox[n], rays.oy[n], rays.oz[n]}, {x_[n], y_[n], z_[n]});
            rays.dx[n] = lit.direction.x, rays.dy[n] = lit.direction.y, rays.dz[n] = lit.direction.z;
            distance_[n] = lit.distance;
        }
    } else {
        for (std::size_t n = 0; n < lanes_; n += numbers::lanes::kDoubles) {
            using numbers::lanes::Double;
            const auto to = [n](double location, const TileLanes& offset, const auto& origin) {
                return (Double(location) + Double::load_aligned(offset.data() + n)) -
                       Double::load_aligned(origin.data() + n);
            };
            const Double x = to(light_.location.x, x_, rays.ox), y = to(light_.location.y, y_, rays.oy),
                         z = to(light_.location.z, z_, rays.oz);
            const Double distance = xsimd::sqrt(x * x + y * y + z * z), share = Double(1.0) / distance;
            distance.store_aligned(distance_.data() + n);
            (x * share).store_aligned(rays.dx.data() + n);
            (y * share).store_aligned(rays.dy.data() + n);
            (z * share).store_aligned(rays.dz.data() + n);
        }
    }
    if (light_.projector) project();
    for (std::size_t n = 0; n < lanes_; ++n) rays.t_max[n] = distance_[n] - rays.t_min[n];
}

/// Samples that are not seen through the light's projector get a distance of -infinity; the others end there.
void AreaLight::project()
{
    csg::RayTile& rays = scratch_.shadow.rays;
    const auto from = rays.t_min;
    projected_depths(*light_.projector, rays, [&](std::size_t n, double depth) {
        distance_[n] = depth < 0.0 || depth >= distance_[n] ? -numbers::kInfinity : depth;
    });
    rays.t_min = from;
}

}  // namespace trace
