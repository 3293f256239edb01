#include "csg/freeform/revolution/lathe.h"
#include "csg/freeform/revolution/sor.h"
#include "csg/freeform/sweep/conic_prism.h"
#include "csg/packet/lanes/extrusion_sieve.h"
#include "csg/solids/extrusion.h"
#include "tests/csg/freeform/many_rays.h"

#include <algorithm>

using namespace csg;
using csg_test::check_batch;
using csg_test::check_many;
using csg_test::Rng;
using csg_test::runs_here;
using csg_test::share;

namespace {

glm::dvec2 corner(Rng& rng, double leftmost) { return {rng.uniform(leftmost, 1.0), rng.uniform(-1.0, 1.0)}; }

/// Lines, parabolas and cubics between random points, a few as a rule. No point lies to the left of `leftmost`.
std::vector<OutlinePiece> random_outline(Rng& rng, double leftmost, bool closed)
{
    std::vector<OutlinePiece> pieces;
    const glm::dvec2 first = corner(rng, leftmost);
    glm::dvec2 from = first;
    for (int left = 2 + rng.below(rng.below(8) == 0 ? 40 : 10); left >= 0; --left) {
        const glm::dvec2 to = left == 0 && closed ? first : corner(rng, leftmost), a = corner(rng, leftmost),
                         b = corner(rng, leftmost);
        switch (rng.below(3)) {
        case 0: pieces.push_back(OutlinePiece::line(from, to)); break;
        case 1: pieces.push_back(OutlinePiece::quadratic(from, a, to)); break;
        default:
            pieces.push_back({to - from + 3.0 * (a - b), 3.0 * (from - 2.0 * a + b), 3.0 * (a - from), from, from, to});
        }
        from = to;
    }
    return pieces;
}

std::shared_ptr<const OutlineShape> random_shape(Rng& rng)
{
    return std::make_shared<const OutlineShape>(random_outline(rng, -1.0, true));
}

}  // namespace

TEST_CASE("many rays of a prism that narrows to its apex are told what each is told alone", "[csg][many][prism]")
{
    if (!runs_here()) return;
    const glm::dvec2 heights[] = {{0.25, 1.0}, {-1.0, -0.3}, {0.0, 1.0}, {-0.6, 0.8}, {-1.0, 0.0}};
    const glm::dvec2 reach[2] = {glm::dvec2(-1.0), glm::dvec2(1.0)};
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(800)); ++seed) {
        Rng rng(seed + 5000);
        const glm::dvec2 height = heights[rng.below(5)];
        ends += check_many(ConicPrism(random_shape(rng), height.x, height.y, rng.coin(), reach), 1.0, seed);
    }
    CHECK(ends > share(800) * 10);
}

TEST_CASE("many rays of a lathe are told what each is told alone", "[csg][many][lathe]")
{
    if (!runs_here()) return;
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(800)); ++seed) {
        Rng rng(seed + 6000);
        const bool closed = rng.coin();
        const std::vector<OutlinePiece> pieces = random_outline(rng, rng.below(4) == 0 ? -0.3 : 0.0, closed);
        double least = 1.0;
        for (const OutlinePiece& piece : pieces) least = std::min({least, piece.start.x, piece.end.x});
        ends += check_many(Lathe(pieces, {glm::dvec3(-1.0), glm::dvec3(1.0)}, least), 1.0, seed);
    }
    CHECK(ends > share(800) * 10);
}

TEST_CASE("many rays of a surface of revolution are told what each is told alone", "[csg][many][sor]")
{
    if (!runs_here()) return;
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(1600)); ++seed) {
        Rng rng(seed + 8000);
        std::vector<glm::dvec2> points;
        double height = -1.4;
        for (int left = 4 + rng.below(rng.below(8) == 0 ? 20 : 6); left > 0; --left) {
            points.emplace_back(rng.below(6) == 0 ? 0.0 : rng.uniform(0.0, 1.0), height);
            height += rng.below(8) == 0 ? 1e-6 : rng.uniform(0.05, 0.8);
        }
        ends += check_many(Sor(points, rng.coin()), 1.0, seed);
    }
    CHECK(ends > share(1600) * 10);
}

TEST_CASE("many rays of a text or prism are told what each is told alone", "[csg][many][prism]")
{
    if (!runs_here()) return;
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(800)); ++seed) {
        Rng rng(seed + 7000);
        Extrusion solid;
        solid.shape = random_shape(rng);
        solid.low = rng.uniform(-1.0, 0.0);
        solid.high = rng.uniform(0.0, 1.0);
        solid.open = rng.coin();
        solid.frame = Transform::rotate_degrees(rng.point(180.0)) * Transform::scale(glm::dvec3(rng.uniform(0.5, 2.0)));
        // Of the nearest end alone either may tell others behind it: only that one is compared.
        const auto nearest = [](IntersectionList& told) {
            if (!told.first_only) return;
            double t = kInfinity;
            std::uint32_t side = 0;
            const auto offer = [&](double at, std::uint32_t face) {
                if (at >= told.from && at <= told.to && face != kUndrawnFace && at <= t) t = at, side = face;
            };
            told.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                offer(in, in_face);
                offer(out, out_face);
            });
            told.begin(told.from, told.to, true);
            told.touch(t, side);
        };
        ends += check_batch(
            1.0, seed,
            [&](RayBatch& batch) {
                solid.intersect_many(batch);
                for (std::size_t k = 0; k < batch.count; ++k) nearest(batch.records[k]);
            },
            [&](const Ray& ray, IntersectionList& out) {
                solid.each_span(
                    ray,
                    [&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
                        out.enter(in, in_face);
                        out.leave(end, end_face);
                    },
                    out.from, out.to, out.first_only);
                nearest(out);
            });
    }
    CHECK(ends > share(800) * 5);
}

TEST_CASE("a ray that is told something of a text or prism is one that comes near", "[csg][many][prism]")
{
    if (!runs_here()) return;
    int told = 0, near = 0, all = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(800)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed + 8000);
        Extrusion solid;
        solid.shape = random_shape(rng);
        solid.high = rng.uniform(0.05, 1.0);
        solid.frame = csg_test::random_transform(rng);
        RayTile tile{};
        tile.count = 1 + rng.below(kTileRays);
        for (std::size_t k = 0; k < static_cast<std::size_t>(tile.count); ++k) {
            Ray ray = csg_test::ray_to(rng, 1.5);
            ray.origin = solid.frame.point(ray.origin);
            ray.direction = solid.frame.vector(ray.direction);
            tile.set(k, ray, rng.coin() ? 0.0 : 1.0, rng.coin() ? kInfinity : rng.uniform(1.0, 6.0));
        }
        const TileRays<OwnOrigins> rays(tile);
        const RayMask mask = rays_near(solid, rays, rays.all());
        for (std::size_t k = 0; k < static_cast<std::size_t>(tile.count); ++k) {
            bool drawn = false;
            solid.each_span(
                tile.ray(static_cast<int>(k)),
                [&](double in, std::uint32_t, double end, std::uint32_t) {
                    for (const double t : {in, end}) drawn = drawn || (t >= tile.t_min[k] && t <= tile.t_max[k]);
                },
                tile.t_min[k], tile.t_max[k]);
            ++all;
            told += drawn ? 1 : 0;
            near += (mask >> k & 1) != 0 ? 1 : 0;
            if (drawn) REQUIRE((mask >> k & 1) != 0);
        }
    }
    CHECK(told > share(800) * 2);
    CHECK(near < all * 9 / 10);
}
