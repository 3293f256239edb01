#include "parser/parse.h"
#include "render/plan/textures/textures.h"
#include "render/texture/evaluate.h"
#include "render/texture/evaluate_points.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

// Whole pigments and normals, read by the parser, against what POV-Ray answered (data/pigments.txt, data/normals.txt).
namespace {

struct Measured {
    std::string statement;
    std::vector<std::vector<double>> rows;
};

std::vector<Measured> measured(const std::string& name)
{
    std::ifstream in(WHITTLE_TEST_DATA "/" + name);
    std::vector<Measured> out;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (line[0] == '=') {
            out.push_back({line.substr(2), {}});
            continue;
        }
        std::istringstream numbers(line);
        out.back().rows.emplace_back();
        for (double v = 0; numbers >> v;) out.back().rows.back().push_back(v);
    }
    return out;
}

scene::Description parsed(const std::string& part, const std::string& version = "3.7")
{
    parser::Options options;
    options.library_path = {WHITTLE_TEST_DATA};
    return parser::parse_text("#version " + version + "; global_settings { assumed_gamma 1 } sphere { 0, 1 " + part +
                                  " }",
                              "test.pov", options)
        .scene;
}

const scene::Layer& layer_of(const scene::Description& scene)
{
    return std::get<std::vector<scene::Layer>>(scene.objects.at(0).texture->kind).at(0);
}

/// The index that `make` gets from a compiler of the scene's textures, which has nothing to complain of.
template <class Make>
std::uint32_t compiled(const scene::Description& scene, texture::TextureSet& set, Make&& make)
{
    std::vector<scene::Unsupported> notes;
    plan::TextureCompiler compiler(scene, plan::Quality(), set, notes);
    const std::uint32_t index = make(compiler);
    CHECK(notes.empty());
    return index;
}

}  // namespace

TEST_CASE("pigments answer as POV-Ray's do", "[plan][pigment]")
{
    const std::vector<Measured> all = measured("pigments.txt");
    REQUIRE(all.size() == 92);
    for (const Measured& one : all) {
        const scene::Description scene = parsed("pigment { " + one.statement + " }");
        texture::TextureSet set;
        const std::uint32_t pigment =
            compiled(scene, set, [&](plan::TextureCompiler& c) { return c.pigment(layer_of(scene).pigment); });
        for (const auto& row : one.rows) {
            INFO(one.statement << " at " << row[0] << ' ' << row[1] << ' ' << row[2]);
            const scene::Color c = texture::pigment_color(set, pigment, {row[0], row[1], row[2]}, {});
            const float got[] = {c.red, c.green, c.blue, c.filter, c.transmit};
            // Half a unit of the last written digit, and the rounding of single precision.
            for (std::size_t k = 0; k < 5; ++k) CHECK(std::abs(static_cast<double>(got[k]) - row[3 + k]) <= 7e-8);
        }
    }
}

TEST_CASE("pigments answer as POV-Ray 3.8's do, by themselves and many at a time", "[plan][pigment]")
{
    const std::vector<Measured> all = measured("pigments38.txt");
    REQUIRE(all.size() == 68);
    for (const Measured& one : all) {
        const scene::Description scene = parsed("pigment { " + one.statement + " }", "3.8");
        texture::TextureSet set;
        const std::uint32_t pigment =
            compiled(scene, set, [&](plan::TextureCompiler& c) { return c.pigment(layer_of(scene).pigment); });
        texture::Points points;
        for (const auto& row : one.rows) points.add({row[0], row[1], row[2]});
        points.pad();
        texture::ColorPoints together;
        texture::pigment_colors(set, pigment, points, {}, together);
        for (std::size_t i = 0; i < one.rows.size(); ++i) {
            const auto& row = one.rows[i];
            INFO(one.statement << " at " << row[0] << ' ' << row[1] << ' ' << row[2]);
            const scene::Color c = texture::pigment_color(set, pigment, points.at(i), {});
            const float got[] = {c.red, c.green, c.blue, c.filter, c.transmit};
            for (std::size_t k = 0; k < 5; ++k)
                CHECK(static_cast<double>(got[k]) == Approx(row[3 + k]).margin(2e-7).epsilon(2e-7));
            CHECK(together.at(i) == c);
        }
    }
}

TEST_CASE("normals with maps answer as POV-Ray's do", "[plan][normal]")
{
    const std::vector<Measured> all = measured("normals.txt");
    REQUIRE(all.size() == 7);
    for (const Measured& one : all) {
        const scene::Description scene = parsed("normal { " + one.statement + " }");
        texture::TextureSet set;
        const std::uint32_t normal =
            compiled(scene, set, [&](plan::TextureCompiler& c) { return c.normal(*layer_of(scene).normal, false); });
        for (const auto& row : one.rows) {
            INFO(one.statement << " at " << row[0] << ' ' << row[1]);
            texture::Surroundings around;
            const glm::dvec3 n = glm::normalize(texture::perturb(set, normal, {0, 0, -1}, {row[0], row[1], 0}, around));
            for (int k = 0; k < 3; ++k)
                CHECK(n[k] == Approx(row[2 + static_cast<std::size_t>(k)]).margin(1e-4));  // 16 bits of a picture
        }
    }
}
