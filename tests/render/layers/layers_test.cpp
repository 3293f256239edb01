// What lies behind a picture's pixels: docs/tools/layers.md.
#include "render/layers/cryptomatte.h"
#include "render/layers/layers.h"
#include "render/layers/object_names.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr int kSize = 65;  // the middle pixel's middle is the middle of the picture

const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                          "camera { orthographic location <0,0,-10> look_at 0 right 4*x up 4*y }\n";

struct Made {
    image::Channels channels;
    std::vector<std::string> names;

    std::size_t channel(const std::string& name) const
    {
        const auto at = std::find(channels.names.begin(), channels.names.end(), name);
        REQUIRE(at != channels.names.end());
        return static_cast<std::size_t>(at - channels.names.begin());
    }
    double at(const std::string& name, int x, int y) const
    {
        return static_cast<double>(
            channels.values[channels.names.size() * static_cast<std::size_t>(y * channels.width + x) + channel(name)]);
    }
};

Made made(const std::string& text, const std::string& kinds, bool antialiased)
{
    const scene::Description description = parser::parse_text(kHead + text, "t.pov", {}).scene;
    plan::Options options;
    options.width = options.height = kSize;
    Made out;
    out.names = layers::object_names(description, [&](const std::string&) { return kHead + text; });
    const auto compiled = plan::compile(description, options);
    out.channels =
        layers::make_layers(compiled, layers::kinds_of(kinds), out.names, {}, antialiased, {0, compiled.options.height})
            .value();
    return out;
}

}  // namespace

TEST_CASE("depth, position and normal of a sphere are those of the formula", "[layers]")
{
    const Made m = made("sphere { 0, 1.5 pigment { rgb <1,.5,0> } finish { ambient 0 diffuse .8 } }\n"
                        "plane { z, 5 pigment { rgb 1 } no_image }\n",
                        "depth,normal,position,albedo,uv,material,object", false);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const double px = 4.0 * (x + 0.5) / kSize - 2.0, py = 2.0 - 4.0 * (y + 0.5) / kSize;
            const double rest = 2.25 - px * px - py * py;
            if (std::abs(rest) < 1e-3) continue;
            if (rest < 0) {
                CHECK(m.at("depth.Z", x, y) == static_cast<double>(layers::kNothing));
                CHECK(m.at("object.id", x, y) == 0.0);
                CHECK(m.at("normal.Z", x, y) == 0.0);
                continue;
            }
            const double z = -std::sqrt(rest);
            CHECK(m.at("depth.Z", x, y) == Approx(10.0 + z).epsilon(1e-6));
            CHECK(m.at("position.X", x, y) == Approx(px).margin(1e-6));
            CHECK(m.at("position.Y", x, y) == Approx(py).margin(1e-6));
            CHECK(m.at("position.Z", x, y) == Approx(z).margin(1e-6));
            CHECK(m.at("normal.X", x, y) == Approx(px / 1.5).margin(1e-6));
            CHECK(m.at("normal.Y", x, y) == Approx(py / 1.5).margin(1e-6));
            CHECK(m.at("normal.Z", x, y) == Approx(z / 1.5).margin(1e-6));
            CHECK(m.at("object.id", x, y) == 1.0);
            CHECK(m.at("material.id", x, y) >= 1.0);
            // uv_mapping of a sphere: u goes round, v from pole to pole (reference manual, "UV Mapping").
            CHECK(m.at("uv.V", x, y) == Approx(0.5 + std::asin(py / 1.5) / M_PI).margin(1e-6));
        }
    CHECK(m.at("albedo.R", kSize / 2, kSize / 2) == Approx(0.8));
    CHECK(m.at("albedo.G", kSize / 2, kSize / 2) == Approx(0.4));
    CHECK(m.at("albedo.B", kSize / 2, kSize / 2) == Approx(0.0).margin(1e-6));
}

TEST_CASE("an object's shares add up to what it covers of the picture", "[layers]")
{
    const Made m = made("#declare Ball = sphere { 0, 1.3 }\nobject { Ball pigment { rgb 1 } }\n", "object", true);
    const double ball = static_cast<double>(layers::id_of(m.names[0]));
    double area = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const double id = m.at("CryptoObject00.R", x, y), share = m.at("CryptoObject00.G", x, y);
            CHECK((id == ball || (id == 0.0 && share == 0.0)));
            area += share * 16.0 / (kSize * kSize);
        }
    CHECK(area == Approx(M_PI * 1.69).epsilon(0.002));  // 16 samples of some 270 pixels at the rim
}

TEST_CASE("objects are called as in the text, operands by the object that they are part of", "[layers]")
{
    const std::string text = "#declare Pawn = union { sphere { 0, .5 } box { -1, <1,-.5,1> } pigment { rgb x } }\n"
                             "object { Pawn }\n"
                             "object { Pawn translate x }\n"
                             "sphere { <0,0,9>, 9 pigment { rgb 1 } }\n"
                             "light_source { 0, 1 }\n"
                             "#local Wall = plane { y, 0 }\n"
                             "object{Wall texture { pigment { rgb 1 } } }\n";
    const Made m = made(text, "object", false);
    CHECK(m.names[0] == "Pawn");
    CHECK(m.names[1] == "Pawn.2");
    CHECK(m.names[2] == "sphere t.pov:6");
    CHECK(m.names[4] == "Wall");
    // Ball and box of the pawn are one object.
    CHECK(m.at("object.id", kSize / 2, kSize / 2) == 1.0);
    CHECK(m.at("object.id", kSize / 2 - kSize / 8, kSize / 2 + kSize / 6) == 1.0);
}

TEST_CASE("time is measured where it is asked for", "[layers]")
{
    const Made m = made("sphere { 0, 1 pigment { rgb 1 } }\n", "time", false);
    CHECK(m.channels.names == std::vector<std::string>{"time.ns"});
    CHECK(std::all_of(m.channels.values.begin(), m.channels.values.end(), [](float ns) { return ns > 0.0f; }));
}

TEST_CASE("a layer that is none is named", "[layers]")
{
    CHECK(layers::kinds_of("all").size() == 8);
    CHECK(layers::kinds_of("uv,depth,uv") == std::vector{layers::Kind::Uv, layers::Kind::Depth});
    CHECK_THROWS_WITH(layers::kinds_of("depth,colour"), Catch::Contains("'colour' is no layer"));
}

TEST_CASE("the same layers for any number of threads", "[layers]")
{
    const scene::Description description =
        parser::parse_text(kHead + "sphere { 0, 1 pigment { granite } normal { bumps } }\n", "t.pov", {}).scene;
    plan::Options options;
    options.width = options.height = kSize;
    const auto compiled = plan::compile(description, options);
    trace::RenderOptions one, three;
    one.threads = 1;
    three.threads = 3;
    const std::vector kinds{layers::Kind::Normal, layers::Kind::Albedo};
    CHECK(layers::make_layers(compiled, kinds, {}, one, true, {0, compiled.options.height})->values ==
          layers::make_layers(compiled, kinds, {}, three, true, {0, compiled.options.height})->values);
}
