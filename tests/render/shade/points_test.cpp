#include "render/texture/noise/noise.h"
#include "render/texture/evaluate_points.h"
#include "render/texture/function_host.h"
#include "tests/render/shade/random_points.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace texture;

namespace {

Pattern random_pattern(Rng& rng, TextureSet& set)
{
    using K = PatternKind;
    constexpr std::array kKinds{K::Bozo,         K::Dents,       K::Granite, K::Wrinkles,       K::Agate,   K::Marble,
                                K::Wood,         K::Crackle,     K::Crackle, K::Mandel,         K::Julia,   K::Gradient,
                                K::Planar,       K::Cylindrical, K::Checker, K::Leopard,        K::Spiral1, K::Cells,
                                K::Square,       K::Brick,       K::Onion,   K::PigmentPattern, K::Ripples, K::Waves,
                                K::MagnetMandel, K::MagnetJulia, K::Spiral2, K::Radial,         K::Quilted};
    constexpr std::array kMetrics{2.0, 2.0, 1.0, 3.0, 1.5, 0.7, 130.0};
    Pattern p;
    p.kind = kKinds[static_cast<std::size_t>(rng.below(kKinds.size()))];
    if (p.kind == K::PigmentPattern) {
        if (set.pigments.empty()) p.kind = K::Onion;
        else p.pigment = static_cast<std::uint32_t>(rng.below(static_cast<int>(set.pigments.size())));
    }
    if (set.wave_sources.empty()) {
        constexpr int kSources = 5;
        set.wave_sources.resize(kSources);
        set.wave_frequencies.resize(kSources);
        wave_sources(kSources, set.wave_sources.data(), set.wave_frequencies.data());
    }
    p.noise_generator = static_cast<std::uint8_t>(1 + rng.below(3));
    p.wave = static_cast<scene::WaveForm>(rng.below(5));
    p.has_turbulence = rng.flip();
    const bool inside = p.kind == K::Agate || p.kind == K::Marble || p.kind == K::Wood || p.kind == K::Spiral1 ||
                        p.kind == K::Spiral2;
    p.displaces = p.has_turbulence && !inside;
    p.turbulence = {rng.vector(1.0), 1 + rng.below(8), rng.uniform(1.5, 2.5), rng.uniform(0.3, 0.7)};
    for (int k = 0; k < 3; ++k)
        if (rng.below(3) == 0) p.turbulence.amount[k] = 0.0;
    p.frequency = rng.uniform(-3.0, 3.0);
    p.phase = rng.uniform(-1.0, 1.0);
    p.vector = rng.vector(1.0);
    if (rng.flip()) p.vector.z = 0.0;
    if (rng.flip()) p.vector.y = 0.0;
    if (p.kind == K::Crackle)
        p.numbers = {kMetrics[static_cast<std::size_t>(rng.below(kMetrics.size()))],
                     rng.flip() ? 0.0 : 0.3,
                     rng.below(4) == 0 ? 1.0 : 0.0,
                     1.0 * rng.below(4),
                     1.0 * rng.below(3),
                     1.0 * rng.below(2)};
    else if (p.kind == K::Mandel || p.kind == K::Julia || p.kind == K::MagnetMandel || p.kind == K::MagnetJulia)
        p.numbers = {1.0 + rng.below(40),  2.0 + rng.below(3),     double(rng.below(9)), rng.uniform(0.5, 3.0),
                     double(rng.below(7)), rng.uniform(-1.0, 1.0), 1.0 + rng.below(2)};
    else p.numbers = {rng.uniform(0.0, 2.0)};
    p.first_warp = static_cast<std::uint32_t>(set.warps.size());
    p.warp_count = static_cast<std::uint32_t>(rng.below(3));
    for (std::uint32_t i = 0; i < p.warp_count; ++i) switch (rng.below(5)) {
        case 0:
            set.warps.push_back(Affine{glm::dmat3(rng.vector(1.0), rng.vector(1.0), rng.vector(1.0)), rng.vector(1.0)});
            break;
        case 1:
            set.warps.push_back(
                scene::Turbulence{rng.flip() ? glm::dvec3(0, 0.5, 0) : rng.vector(1.0), 1 + rng.below(6)});
            break;
        case 2:
            set.warps.push_back(scene::BlackHoleWarp{rng.vector(1.0), rng.uniform(0.1, 3.0), rng.uniform(0.5, 2.0),
                                                     rng.uniform(0.5, 2.0), rng.flip(),
                                                     rng.flip() ? glm::dvec3(0) : glm::dvec3(0.0, 2.0, 1.5)});
            break;
        case 3:
            set.warps.push_back(scene::MappingWarp{static_cast<scene::MappingWarp::Kind>(rng.below(5)),
                                                   rng.flip() ? glm::dvec3(0, 0, 1) : rng.vector(1.0), 0.5,
                                                   rng.flip() ? 0.0 : rng.uniform(-1.0, 1.0), rng.uniform(0.5, 1.5)});
            break;
        default: set.warps.push_back(scene::RepeatWarp{{0, 1.5, 0}, {0.3, 0, 0}, {0, 1, 0}});
        }
    for (int holes = rng.below(4) == 0 ? 20 + rng.below(60) : 0; holes > 0; --holes, ++p.warp_count)
        set.warps.push_back(scene::BlackHoleWarp{rng.vector(4.0), rng.uniform(0.1, 1.0), rng.uniform(0.5, 2.0)});
    while (set.reach.far.size() < set.warps.size()) set.reach.add(set.warps[set.reach.far.size()]);
    return p;
}

/// A pigment of up to `depth` more levels of maps; its index.
std::uint32_t random_pigment(Rng& rng, TextureSet& set, int depth)
{
    using Kind = Pigment::Kind;
    Pigment pigment;
    pigment.kind = depth == 0 || rng.flip() ? (rng.below(6) == 0 ? Kind::Solid : Kind::ColorMap)
                   : rng.below(4) == 0      ? Kind::Average
                   : rng.below(4) == 0      ? Kind::Uv
                                            : Kind::PigmentMap;
    const float clear = rng.flip() ? 1.0f : 0.0f;
    const auto color = [&] {
        return scene::Color{float(rng.uniform(0, 1)), float(rng.uniform(0, 1)), float(rng.uniform(0, 1)), 0.1f * clear,
                            float(rng.uniform(0, 1)) * clear};
    };
    pigment.color = color();
    if (rng.below(6) == 0)
        pigment.blending = {static_cast<scene::Blending::Mode>(rng.below(4)), float(rng.uniform(0.3, 3.0))};
    pigment.count = static_cast<std::uint32_t>(1 + rng.below(rng.below(4) == 0 ? 40 : 5));
    if (pigment.kind == Kind::ColorMap && rng.below(8) == 0) pigment.count += 200;
    std::vector<std::uint32_t> children(pigment.count, 0);
    if (pigment.kind == Kind::PigmentMap || pigment.kind == Kind::Average || pigment.kind == Kind::Uv)
        for (auto& child : children) child = random_pigment(rng, set, depth - 1);
    pigment.pattern = static_cast<std::uint32_t>(set.patterns.size());
    set.patterns.push_back(random_pattern(rng, set));
    pigment.first = static_cast<std::uint32_t>(set.keys.size());
    for (std::uint32_t i = 0; i < pigment.count; ++i) {
        set.keys.push_back((float(i) + 0.5f) / float(pigment.count));
        set.colors.push_back(color());
        set.children.push_back(children[i]);
    }
    set.pigments.push_back(pigment);
    return static_cast<std::uint32_t>(set.pigments.size() - 1);
}

}  // namespace

TEST_CASE("pigments of many points have the bits of each point alone", "[texture][pigment]")
{
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        const std::uint32_t pigment = random_pigment(rng, set, 2);
        const Points p = random_points(rng);
        std::array<Surroundings, kMostPoints> places;
        Around around;
        for (std::size_t i = 0; i < places.size(); ++i) {
            places[i].uv = {rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)};
            around[i] = &places[i];
        }
        ColorPoints colors;
        pigment_colors(set, pigment, p, around, colors);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const scene::Color c = pigment_color(set, pigment, p.at(i), places[i]), m = colors.at(i);
            REQUIRE(bits(c.red) == bits(m.red));
            REQUIRE(bits(c.green) == bits(m.green));
            REQUIRE(bits(c.blue) == bits(m.blue));
            REQUIRE(bits(c.filter) == bits(m.filter));
            REQUIRE(bits(c.transmit) == bits(m.transmit));
        }
    }
}

TEST_CASE("points that a function asks for have the bits of each point alone", "[texture][function]")
{
    const auto same = [](double a, double b) { return bits(a) == bits(b) || (a != a && b != b); };
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        const std::uint32_t pigment = random_pigment(rng, set, 1),
                            pattern = static_cast<std::uint32_t>(rng.below(static_cast<int>(set.patterns.size())));
        const Points p = random_points(rng);
        const FunctionHost host(set);
        const std::size_t count = seed % 4 == 0 ? function::kMostTogether : function::kLanes;
        alignas(64) std::array<std::array<double, function::kMostTogether>, 3> at;
        alignas(64) std::array<std::array<double, function::kMostTogether>, 6> out;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 3; ++k) at[k][i] = p.at(i % p.size())[static_cast<int>(k)];
        host.patterns(pattern, at[0].data(), at[1].data(), at[2].data(), count, out[5].data());
        host.pigments(pigment, at[0].data(), at[1].data(), at[2].data(), count,
                      {out[0].data(), out[1].data(), out[2].data(), out[3].data(), out[4].data()});
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 q = p.at(i % p.size());
            const auto color = host.pigment(pigment, q);
            for (std::size_t k = 0; k < color.size(); ++k) REQUIRE(same(color[k], out[k][i]));
            REQUIRE(same(host.pattern(pattern, q), out[5][i]));
        }
    }
}

TEST_CASE("pattern values of many points have the bits of each point alone", "[texture]")
{
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        const Pattern pattern = random_pattern(rng, set);
        Points p = random_points(rng);
        const Points before = p;
        warp_points(set, pattern, p, kAllLive);
        const Surroundings none;
        Around around;
        around.fill(&none);
        Values values;
        pattern_values(set, pattern, p, around, values);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec3 q = warp_point(set, pattern, before.at(i));
            // A coordinate that is not displaced keeps the sign of its zero; nothing looks at it.
            for (int k = 0; k < 3; ++k) REQUIRE((q[k] == p.at(i)[k] || (q[k] != q[k] && p.at(i)[k] != p.at(i)[k])));
            const double v = pattern_value(set, pattern, q, none);
            REQUIRE((bits(values[i]) == bits(v) || (v != v && values[i] != values[i])));
        }
    }
}

TEST_CASE("density files of many points have the bits of each point alone", "[texture][density]")
{
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        auto volume = std::make_shared<scene::Volume>();
        std::size_t samples = 1;
        for (auto& size : volume->size) samples *= size = static_cast<std::uint32_t>(1 + rng.below(6));
        for (std::size_t i = 0; i < samples; ++i) volume->samples.push_back(static_cast<std::uint32_t>(rng.below(256)));
        set.volumes.push_back(volume);
        Pattern pattern;
        pattern.kind = PatternKind::DensityFile;
        pattern.data = 0;
        pattern.numbers = {1.0 * rng.below(3)};
        Points p;
        for (int i = 0, count = 1 + rng.below(kMostPoints); i < count; ++i)
            p.add(glm::dvec3(0.5) + rng.vector(rng.flip() ? 0.51 : 0.7));
        p.set(0, glm::dvec3(rng.below(2), 0.0, std::nextafter(1.0, 0.0)));
        if (rng.flip()) p.x[p.size() - 1] = std::nan("");
        p.pad();
        const Surroundings none;
        Around around;
        around.fill(&none);
        Values values;
        pattern_values(set, pattern, p, around, values);
        for (std::size_t i = 0; i < p.size(); ++i)
            REQUIRE(bits(values[i]) == bits(pattern_value(set, pattern, p.at(i), none)));
    }
}

namespace {

template <class T>
bool alike(T a, T b)
{
    return bits(a) == bits(b) || (a != a && b != b);
}

/// A few texels in any of the ways in which pictures are kept and shown.
Image random_image(Rng& rng)
{
    Image out;
    auto picture = std::make_shared<image::Picture>();
    out.width = 1 + static_cast<std::uint32_t>(rng.below(5));
    out.height = 1 + static_cast<std::uint32_t>(rng.below(5));
    picture->width = static_cast<int>(out.width);
    picture->height = static_cast<int>(out.height);
    picture->channels = 1 + static_cast<int>(rng.below(4));
    const std::size_t count = picture->count() * static_cast<std::size_t>(picture->channels);
    const auto levels = [&](auto of, std::uint32_t most) {
        for (auto& level : of)
            level = static_cast<typename decltype(of)::value_type>(rng.below(static_cast<int>(most) + 1));
        return image::Samples(of, most);
    };
    switch (rng.below(4)) {
    case 0: picture->samples = levels(image::Samples::Bytes(count), 255); break;
    case 1: picture->samples = levels(image::Samples::Shorts(count), 65535); break;
    case 2: {
        image::Samples::Floats values(count);
        for (float& v : values) v = static_cast<float>(rng.uniform(0.0, 2.0));
        picture->samples = {values};
        break;
    }
    default:
        picture->indices.resize(picture->count());
        for (auto& place : picture->indices) place = static_cast<std::uint8_t>(rng.below(3));
        for (int i = 0; i < 3; ++i) out.palette.push_back({float(i) / 2.0f, 0.25f, 0.5f, 0.0f, float(i) / 4.0f});
        out.by_place = rng.flip();
    }
    if (picture->samples.kept.index() == 1 && rng.flip())
        for (int i = 0; i < 256; ++i) out.levels.push_back(float(i * i) / 65025.0f);
    if (rng.flip()) out.transmit.push_back(0.25f);
    out.projection = static_cast<Image::Projection>(rng.below(4));
    out.interpolation = static_cast<Image::Interpolation>(rng.below(4));
    out.once = rng.flip();
    out.premultiplied = rng.flip();
    out.value = static_cast<Image::Value>(rng.below(3));
    out.repeat = {rng.uniform(0.3, 3.0), rng.uniform(0.3, 3.0)};
    out.offset = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    out.picture = std::move(picture);
    return out;
}

}  // namespace

TEST_CASE("pictures show many points the bits of each alone", "[texture][image]")
{
    std::size_t there = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Image image = random_image(rng);
        const Points p = random_points(rng);
        Points normals;
        for (std::size_t i = 0; i < p.size(); ++i)
            normals.add(i % 7 == 0 ? glm::dvec3(0, -1, 0) : glm::normalize(rng.vector(1.0)));
        normals.pad();
        const Points before = normals;
        ColorPoints shown;
        Values values;
        images_shown(image, p, shown);
        image_values(image, p, values);
        image_bumps(image, 0.7, p, normals);
        for (std::size_t i = 0; i < p.size(); ++i) {
            glm::dvec2 place;
            there += image_place(image, p.at(i), place) ? 1 : 0;
            const scene::Color one = image_shown(image, p.at(i)), many = shown.at(i);
            REQUIRE(alike(one.red, many.red));
            REQUIRE(alike(one.green, many.green));
            REQUIRE(alike(one.blue, many.blue));
            REQUIRE(alike(one.filter, many.filter));
            REQUIRE(alike(one.transmit, many.transmit));
            REQUIRE(alike(image_value(image, p.at(i)), values[i]));
            const glm::dvec3 bent = image_bump(image, 0.7, before.at(i), p.at(i));
            for (int k = 0; k < 3; ++k) REQUIRE(alike(bent[k], normals.at(i)[k]));
        }
    }
    CHECK(there > 10000);  // not all beside the picture
}

TEST_CASE("normals of many points have the bits of each bent alone", "[texture][normal]")
{
    using Map = Normal::Map;
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        set.wave_sources.resize(10);
        set.wave_frequencies.resize(10);
        wave_sources(10, set.wave_sources.data(), set.wave_frequencies.data());
        Normal normal;
        normal.map = std::array{Map::None, Map::None, Map::Slopes, Map::Average,
                                Map::Normals}[static_cast<std::size_t>(rng.below(5))];
        normal.amount = rng.uniform(-1.0, 1.0);
        normal.no_bump_scale = rng.flip();
        normal.count = 1 + static_cast<std::uint32_t>(rng.below(3));
        if (normal.map == Map::Average || normal.map == Map::Normals)
            set.normals.push_back({Map::None, 0, 0.3});  // of its own, bent by the first pattern
        for (std::uint32_t i = 0; i < normal.count; ++i) {
            set.keys.push_back((float(i) + 0.5f) / float(normal.count));
            set.slopes.emplace_back(rng.uniform(0.0, 1.0), rng.uniform(-1.0, 1.0));
            set.children.push_back(0);
        }
        Pattern pattern = random_pattern(rng, set);
        using K = PatternKind;
        if (rng.flip())
            pattern.kind = std::array{K::Bumps, K::Dents, K::Wrinkles, K::Ripples, K::Waves, K::Quilted, K::Facets}
                [static_cast<std::size_t>(rng.below(7))];
        if (pattern.kind == K::Facets || pattern.kind == K::Quilted)
            pattern.numbers = {rng.uniform(0.1, 1.0), rng.uniform(0.1, 1.0), 2.0};
        set.patterns.push_back(pattern);
        set.normals.push_back(normal);
        const auto index = static_cast<std::uint32_t>(set.normals.size() - 1);
        set.normals.back().pattern = set.normals.front().pattern = 0;
        const Points p = random_points(rng);
        const Surroundings none;
        Around around;
        around.fill(&none);
        Points many;
        for (std::size_t i = 0; i < p.size(); ++i) many.add(glm::normalize(rng.vector(1.0)));
        many.pad();
        const Points before = many;
        perturb_points(set, index, p, around, many);
        for (std::size_t i = 0; i < p.size(); ++i) {
            Surroundings own = none;
            const glm::dvec3 one = perturb(set, index, before.at(i), p.at(i), own);
            for (int k = 0; k < 3; ++k)
                REQUIRE((bits(many.at(i)[k]) == bits(one[k]) || (one[k] != one[k] && many.at(i)[k] != many.at(i)[k])));
        }
    }
}
