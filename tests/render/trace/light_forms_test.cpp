// Rows of light go through the lights in vector lanes or by themselves: one formula, the same picture.
#include "render/light/illuminate.h"
#include "render/kernel/light/tile_attenuation.h"
#include "render/picture/render.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace {

image::Image picture_of(const scene::Description& description, bool scalar)
{
    plan::Options options;
    options.width = 64;
    options.height = 48;
    options.scalar_light = scalar;
    image::Image out;
    trace::render(plan::compile(description, options), trace::RenderOptions{}, out);
    return out;
}

/// A scene whose finishes, layers and lights are drawn at random.
class RandomScene {
public:
    explicit RandomScene(std::mt19937& random) : random_(random) {}

    std::string text()
    {
        std::string out = "#version " + one_of({"3.7", "3.8"}) +
                          "; global_settings { assumed_gamma 1 max_trace_level 4 }\n"
                          "camera { location <0,2,-6> look_at 0 }\n";
        out +=
            "light_source { <-5,6,-5> rgb <1,.9,.6> " +
            one_of({"", "spotlight radius 20 falloff 30 point_at 0", "fade_power 2 fade_distance 9",
                    "area_light x, z, 3, 3 adaptive 0", "area_light x, y, 3, 3 area_illumination on",
                    "spotlight radius 20 falloff 30 tightness 3 point_at 0 area_light x, z, 2, 3 area_illumination on",
                    "fade_power 1.5 fade_distance 4 area_light x, y, 4, 3 circular orient area_illumination on"}) +
            " }\n";
        out += "light_source { <4,5,-2> rgb .6 " +
               one_of({"", "shadowless", "parallel point_at 0", "cylinder radius 3 falloff 4 point_at 0"}) + " }\n";
        out += "plane { y,-1 " + texture() + "}\n";
        for (int i = 0; i < 3; ++i) {
            const std::string solid =
                                  one_of({"sphere { 0,.9 ", "box { -.8,.8 ", "torus { .7,.25 ", "cone { -y,.9,y,.2 "}),
                              first = texture();
            const bool mapped = first.find("texture_map") != std::string::npos;  // nothing lies on top of it
            out += solid + first +
                   one_of({"", "interior { ior 1.2 caustics 1.7 } ",
                           "interior { ior 1.6 fade_distance .8 fade_power 2 } "});
            if (!mapped)
                out +=
                    one_of({"", "texture { pigment { agate color_map { [0 rgbt <.3,1,.6,.7>] [1 rgbt <1,1,1,.2>] } } " +
                                    finish() + "} "});
            out += "translate <" + number(-2, 2) + "," + number(-.5, .5) + "," + number(-2, 2) + "> }\n";
        }
        return out;
    }

private:
    std::string number(double low, double high)
    {
        return std::to_string(low + (high - low) * std::generate_canonical<double, 32>(random_)) + " ";
    }
    std::string one_of(std::vector<std::string> of) { return of[random_() % of.size()]; }
    std::string finish()
    {
        return "finish { ambient " + number(0, .2) + "diffuse " + number(0, 1) + "brilliance " +
               one_of({"1 ", "2.5 ", ".7 "}) + "phong " + one_of({"0 ", "1.2 ", ".4 "}) + "phong_size " +
               number(3, 90) + "specular " + one_of({"0 ", ".8 "}) + "roughness " + number(.003, .1) + "metallic " +
               one_of({"0 ", "1 ", ".5 "}) + "reflection " +
               one_of({"0 ", "0 ", ".3 ", "{ .1, .7 } ", "{ 0, .9 fresnel } conserve_energy ", "{ .6 metallic } ",
                       "{ .1, .5 falloff 2 } "}) +
               "crand " + one_of({"0 ", "0 ", ".2 "}) + "} ";
    }
    /// One of layers, or a map of such, or a map of maps.
    std::string texture(int depth = 2)
    {
        if (depth != 0 && random_() % 3 == 0)
            return "texture { " +
                   one_of({"leopard", "gradient x scallop_wave", "bozo scale .4", "wood turbulence .3", "crackle solid",
                           "slope y"}) +
                   " texture_map { [0 " + texture(depth - 1) + "] [.4 " + texture(depth - 1) + "] [.6 " +
                   texture(depth - 1) + "] [1 " + texture(depth - 1) + "] } " +
                   one_of({"", "no_bump_scale ", "rotate 20*x scale <.6,.9,1.2> "}) + "} ";
        return "texture { pigment { " +
               one_of({"bozo", "checker", "gradient x", "agate", "rgb <1,.5,.2>", "rgbf <.9,.5,.7,.6>", "slope y",
                       "aoi"}) +
               " } " +
               one_of({"", "normal { bumps .6 scale .2 } ", "normal { wrinkles .8 } ",
                       "normal { ripples .4 scale .3 } ", "normal { waves .4 scale .3 } "}) +
               finish() + "} ";
    }

    std::mt19937& random_;
};

/// Nests of maps and averages of layers that mirror nothing; some let light through at some places. bent: they bend
/// normals, which go through the space of each map.
class RandomMaps {
public:
    explicit RandomMaps(std::mt19937& random, bool bent = false) : random_(random), bent_(bent) {}

    std::string text()
    {
        return "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,2,-6> look_at 0 }\n"
               "background { rgb <.2,.4,.8> } light_source { <-5,6,-5> rgb <1,.9,.6> } light_source { <4,5,-2> rgb .6 "
               "}\n"
               "plane { y,-1 texture { " +
               maps(4) + "} } sphere { 0,1.2 texture { " + maps(3) + "} } torus { 1.6,.3 texture { " + maps(2) +
               "} rotate 30*x }\n";
    }

private:
    std::string number(double low, double high)
    {
        return std::to_string(low + (high - low) * std::generate_canonical<double, 32>(random_)) + " ";
    }
    std::string color(const std::string& kind)
    {
        return kind + " <" + number(0, 1) + "," + number(0, 1) + "," + number(0, 1);
    }
    std::string pigment()
    {
        const char* const clear = random_() % 8 == 0 ? ",.4" : ",0";
        if (random_() % 2 == 0) return "pigment { " + color("rgb") + "> } ";
        return "pigment { bozo scale .3 color_map { [0 " + color("rgbt") + ",0>] [1 " + color("rgbt") + clear +
               ">] } } ";
    }
    std::string finish()
    {
        return "finish { phong " + number(0, 1) + (random_() % 2 == 0 ? "brilliance 2 metallic } " : "specular .4 } ");
    }
    std::string normal()
    {
        if (!bent_ || random_() % 4 == 0) return "";
        const char* const kinds[] = {"bumps .6 scale .2 ", "wrinkles .8 rotate 40*y ", "dents .7 ", "granite .4 "};
        return std::string("normal { ") + kinds[random_() % 4] + "} ";
    }
    /// Of a map.
    std::string placed()
    {
        if (!bent_) return "";
        const char* const ways[] = {"", "rotate 20*x scale <.6,.9,1.2> ", "scale <2,.7,1> ",
                                    "no_bump_scale scale 1.5 "};
        return ways[random_() % 8 == 0 ? 3 : random_() % 3];
    }
    std::string maps(int depth)
    {
        if (depth == 0 || random_() % 6 == 0) return pigment() + normal() + finish();
        if (random_() % 4 == 0) {
            std::string out = "average texture_map { ";
            for (int i = 0; i < 3; ++i) out += "[" + number(.2, 2) + maps(depth - 1) + "] ";
            return out + "} " + placed();
        }
        // What looks at normals may not be bent for all hits at once.
        const char* const patterns[] = {"bozo scale .4", "gradient x", "slope y"};
        return std::string(patterns[random_() % 3]) + " texture_map { [.3 " + maps(depth - 1) + "] [.6 " +
               maps(depth - 1) + "] [.7 " + maps(depth - 1) + "] } " + placed();
    }

    std::mt19937& random_;
    bool bent_;
};

}  // namespace

TEST_CASE("rows of light in lanes and by themselves give one picture", "[trace][light]")
{
    std::mt19937 random(18);
    double farthest = 0;
    for (int i = 0; i < 40; ++i) {
        const std::string text = RandomScene(random).text();
        INFO(text);
        const scene::Description description = grammar_test::parsed(text);
        const image::Image lanes = picture_of(description, false), scalar = picture_of(description, true);
        REQUIRE(lanes.pixels.size() == scalar.pixels.size());
        for (std::size_t k = 0; k < lanes.pixels.size(); ++k) {
            const double off = std::abs(static_cast<double>(lanes.pixels[k]) - static_cast<double>(scalar.pixels[k]));
            farthest = std::max(farthest, off);
        }
    }
    CHECK(farthest < 1e-5);
}

TEST_CASE("maps of opaque layers are mixed in lanes as hit by hit", "[trace][light]")
{
    std::mt19937 random(21);
    double farthest = 0, brightest = 0;
    for (int i = 0; i < 40; ++i) {
        const std::string text = RandomMaps(random, i % 2 == 1).text();
        INFO(text);
        const scene::Description description = grammar_test::parsed(text);
        const image::Image lanes = picture_of(description, false), scalar = picture_of(description, true);
        for (std::size_t k = 0; k < lanes.pixels.size(); ++k) {
            const double off = std::abs(static_cast<double>(lanes.pixels[k]) - static_cast<double>(scalar.pixels[k]));
            farthest = std::max(farthest, off);
            brightest = std::max(brightest, static_cast<double>(scalar.pixels[k]));
        }
    }
    CHECK(farthest < 1e-5);
    CHECK(brightest > 0.5);
}

TEST_CASE("an area light of four by four nodes casts the shadows of sixteen lights", "[trace][light]")
{
    // With sides of a power of two and no node left out the division in four gives the plain mean. brilliance 0: the
    // lamp's direction, which is its centre's for the whole area light, does not matter.
    const std::string things =
        "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,5,-9> look_at <0,-1,0> }\n"
        "plane { y,-1 pigment { rgb 1 } finish { ambient 0 diffuse 1 brilliance 0 } }\n"
        "sphere { <-1.5,1,0>,.8 no_image } box { <.4,.2,-.5>,<1.4,1.6,.6> rotate 20*y no_image }\n"
        "sphere { <.2,2,1>,.6 pigment { rgbf <1,.4,.2,.9> } no_image }\n"
        "difference { torus { .9,.3 } plane { x,0 } translate <-.5,2.5,-1.5> pigment { rgbt <1,1,1,.5> } no_image }\n";
    const std::string area = things + "light_source { <0.3,8,0.1> rgb 1 area_light 4*x, 3*z, 4, 4 adaptive 9 }\n";
    std::string points = things;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            points += "light_source { <" + std::to_string(0.3 + 4 * (i / 3.0 - 0.5)) + ",8," +
                      std::to_string(0.1 + 3 * (j / 3.0 - 0.5)) + "> rgb 1/16 }\n";
    const image::Image one = picture_of(grammar_test::parsed(area), false),
                       many = picture_of(grammar_test::parsed(points), false);
    double farthest = 0, least = 1, most = 0;
    int off = 0;
    for (std::size_t k = 0; k < one.pixels.size(); k += 4) {  // red
        const double a = static_cast<double>(one.pixels[k]), b = static_cast<double>(many.pixels[k]);
        farthest = std::max(farthest, std::abs(a - b));
        off += std::abs(a - b) > 1e-5 ? 1 : 0;
        least = std::min(least, a);
        most = std::max(most, a);
    }
    CHECK(off <= 3);  // to_string rounds the places of the sixteen: an edge may fall on a pixel
    CHECK(farthest < 0.1);
    CHECK((least < 0.3 && most > 0.99));
}

TEST_CASE("cones and distance dim a light in lanes as they do point by point", "[trace][light]")
{
    std::mt19937 random(7);
    const auto number = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) * 0x1p-32);
    };
    const auto point = [&](double size) {
        return glm::dvec3(number(-size, size), number(-size, size), number(-size, size));
    };
    const double powers[] = {0.0, 1.0, 2.0, 2.7};
    using Kind = light::Light::Kind;
    const Kind kinds[] = {Kind::Point, Kind::Spot, Kind::Cylinder, Kind::Spot};
    int dark = 0, dimmed = 0;
    for (int round = 0; round < 400; ++round) {
        INFO("round " << round);
        light::Light light;
        light.kind = kinds[round % 4];
        light.parallel = round % 3 == 0;
        light.color = {0.9f, 0.5f, 0.2f};
        light.location = point(5.0);
        light.axis = glm::normalize(point(1.0));
        light.cos_radius = number(-0.2, 0.95);
        light.cos_falloff = light.cos_radius - number(0.01, 0.5);
        light.tightness = powers[random() % 4];
        light.fade_power = powers[random() % 4];
        light.fade_distance = round % 9 == 0 ? 0.0 : number(0.5, 8.0);
        light.point_at = light.location + number(1.0, 3.0) * light.axis;
        light.falloff = number(0.5, 8.0);
        light.radius = round % 5 == 0 ? 0.0 : number(0.0, light.falloff);
        trace::TileHits hits{};
        for (std::size_t k = 0; k < csg::kTileRays; ++k) {
            const glm::dvec3 at = point(10.0);
            hits.x[k] = at.x, hits.y[k] = at.y, hits.z[k] = at.z;
        }
        trace::TileLight seen;
        trace::toward_lamp(light, hits, csg::kTileRays, seen);
        const trace::HitMask asked = static_cast<trace::HitMask>(random()) << 32 | random();
        alignas(64) trace::TileLanes share;
        trace::attenuate(light, asked, hits, seen, share);
        for (std::size_t k = 0; k < csg::kTileRays; ++k) {
            if ((asked >> k & 1) == 0) continue;
            const light::Illumination alone = light::illuminate(light, hits.point(k));
            REQUIRE(seen.direction(k) == alone.direction);
            REQUIRE(seen.distance[k] == alone.distance);
            const glm::vec3 expected = alone.color;
            const glm::vec3 found = light.color * static_cast<float>(share[k]);
            // Behind a light whose rays are parallel distances are negative, and most powers of those are no numbers.
            REQUIRE((found == expected || (std::isnan(found.x) && std::isnan(expected.x))));
            (expected == glm::vec3(0) ? dark : dimmed) += expected == light.color ? 0 : 1;
        }
    }
    CHECK(dark > 2000);
    CHECK(dimmed > 2000);
}
