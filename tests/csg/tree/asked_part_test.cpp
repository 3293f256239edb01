#include "csg/freeform/freeform.h"
#include "csg/items/world_data.h"
#include "csg/world/world.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace csg;
using csg_test::Rng;
using csg_test::share;

namespace {

HeightField::Grid random_grid(Rng& rng)
{
    HeightField::Grid grid;
    grid.columns = static_cast<std::uint32_t>(8 + rng.below(32));
    grid.rows = static_cast<std::uint32_t>(8 + rng.below(32));
    for (std::uint32_t n = 0; n < grid.columns * grid.rows; ++n)
        grid.levels.push_back(static_cast<std::uint16_t>(rng.below(65536)));
    return grid;
}

/// A solid smaller than the terrain; some of them have no end of their own.
Solid random_cut(Rng& rng)
{
    const glm::dvec3 c(rng.uniform(0.2, 0.8), rng.uniform(0.2, 0.8), rng.uniform(0.2, 0.8));
    const double r = rng.uniform(0.05, 0.3);
    switch (rng.below(5)) {
    case 0: return Sphere{c, r};
    case 1: return Box{c - r, c + r};
    case 2: return Plane{rng.direction(), rng.uniform(-0.5, 1.0)};
    case 3: return Quadric{{1, -2, 1}, {0, 0, 0}, {0, 0, 0}, r - 0.15, Transform::translate(c)};  // of one sheet or two
    default: return Quadric{{1, 0, 1}, {0, 0, 0}, {0, 0, 0}, -r * r, Transform::translate(c)};
    }
}

enum Form { Common, CutLessTerrain, TerrainLessCut, TerrainClipped, CutClipped, kForms };

Tree tree_of(Form form, PartId terrain, PartId cut)
{
    const Tree ground = Tree::leaf(terrain), other = Tree::leaf(cut);
    Tree tree{.op = form == Common ? Tree::Op::Intersection : Tree::Op::Difference};
    if (form == Common) tree.operands = {ground, other};
    else if (form == CutLessTerrain) tree.operands = {other, ground};
    else if (form == TerrainLessCut) tree.operands = {ground, other};
    else tree = form == TerrainClipped ? ground : other;
    if (form == TerrainClipped) tree.clips = {other};
    if (form == CutClipped) tree.clips = {ground};
    return tree;
}

struct Spans {
    std::vector<Span> memory = std::vector<Span>(300);
    SpanList of{memory.data(), 300};

    Spans(const SolidStore& store, PartId part, const Ray& ray)
    {
        with_solid(store, part, [&](const auto& solid) {
            if constexpr (requires { solid.intersect(ray, of); }) solid.intersect(ray, of);
            else if constexpr (requires(Interval in) { solid.interval(ray, in); })
                if (Interval in; solid.interval(ray, in)) of.push({{.t = in.entry}, {.t = in.exit}});
        });
    }
    bool hold(double t) const
    {
        return std::any_of(of.begin(), of.end(), [t](const Span& s) { return s.in.t < t && t < s.out.t; });
    }
    /// The drawn ends where the other holds the place or does not.
    void seen(const Spans& other, bool held, std::vector<double>& out) const
    {
        for (const Span& span : of)
            for (const auto* end : {&span.in, &span.out})
                if (std::isfinite(end->t) && end->face != kUndrawnFace && other.hold(end->t) == held)
                    out.push_back(end->t);
    }
};

std::vector<double> expected(Form form, const Spans& terrain, const Spans& cut)
{
    std::vector<double> out;
    if (form != CutClipped) terrain.seen(cut, form != TerrainLessCut, out);
    if (form != TerrainClipped) cut.seen(terrain, form != CutLessTerrain, out);
    std::sort(out.begin(), out.end());
    return out;
}

}  // namespace

TEST_CASE("a terrain among other solids is met in their boxes as everywhere, in a tile as alone", "[csg][boolean]")
{
    int ends = 0;
    Scratch scratch;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(800)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const auto form = static_cast<Form>(seed % kForms);
        WorldData data;
        const PartId terrain = data.store.add(Freeform{make_freeform<HeightField>(random_grid(rng)), {}}, 0),
                     cut = data.store.add(random_cut(rng), 0);
        Program program = build(tree_of(form, terrain, cut), data.store);
        if (program.nodes.empty()) continue;
        RayTile tile{};
        tile.count = kTileRays;
        const glm::dvec3 from = glm::dvec3(0.5) + 2.0 * rng.direction();
        for (std::size_t k = 0; k < kTileRays; ++k) {
            const glm::dvec3 to(rng.uniform(0, 1), rng.uniform(0, 1), rng.uniform(0, 1));
            const Ray ray{from, glm::normalize(to - from)};
            tile.set(k, ray, 0.0, kInfinity);
            const auto [begin, end] = visible_crossings(program, data.store, ray, -kInfinity, kInfinity, scratch);
            const auto want = expected(form, {data.store, terrain, ray}, {data.store, cut, ray});
            REQUIRE(static_cast<std::size_t>(end - begin) == want.size());
            for (std::size_t i = 0; i < want.size(); ++i) REQUIRE(begin[i].t == Approx(want[i]).epsilon(1e-9));
            ends += static_cast<int>(want.size());
        }
        data.add_program(std::move(program), 0, 0xff);
        data.surface_opaque.assign(1, 1);
        data.finish();
        const World world(data);
        HitTile found;
        world.nearest(tile, 1, scratch, found);
        for (int i = 0; i < tile.count; ++i) {
            const Hit hit = world.nearest(tile.ray(i), 0.0, kInfinity, 1, scratch);
            REQUIRE(found.at(i).found() == hit.found());
            if (hit.found()) REQUIRE(found.at(i).t == hit.t);
        }
    }
    CHECK(ends > share(800) * 20);
}

TEST_CASE("a quadric without an end narrows the box of what it is cut by", "[csg][program]")
{
    csg_test::Object o;
    Tree tree{.op = Tree::Op::Intersection};  // a tube along y through a flat box
    tree.operands = {Tree::leaf(o.store.add(Box{{-3, 0, -3}, {3, 2, 3}})),
                     Tree::leaf(o.store.add(Quadric{{1, 0, 1}, {0, 0, 0}, {0, 0, 0}, -1, {}}))};
    const Program program = build(tree, o.store);
    CHECK(program.bounds.lower.x == Approx(-1.0).margin(1e-5));
    CHECK(program.bounds.upper.z == Approx(1.0).margin(1e-5));
    CHECK(program.bounds.upper.y == Approx(2.0).margin(1e-5));
}
