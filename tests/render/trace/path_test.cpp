// The path tracer against closed forms and the Whitted picture: docs/path_tracing.md.
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"
#include "render/picture/sampling/denoise.h"
#include "render/texture/fresnel.h"
#include "tests/render/trace/path_support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace path_tests;

TEST_CASE("in a white furnace a surface that absorbs nothing cannot be seen", "[path]")
{
    const std::string sky = kCamera + "background { rgb 1 }\n";
    for (const std::string finish :
         {"diffuse 1", "diffuse 1 brilliance 3", "diffuse albedo 1 brilliance 3", "diffuse 0 reflection 1",
          "diffuse .5, .5", "diffuse .7 reflection .3", "diffuse 0 phong albedo 1 phong_size 3"}) {
        const Paths found = traced(sky + "sphere { 0, 1 pigment { rgb 1 } finish { " + finish + " } }", 64);
        INFO(finish);
        // brilliance without albedo returns 2 / (b + 1); highlights that end below the surface lose that part.
        if (finish == "diffuse 1 brilliance 3") CHECK(found.mean() < 0.8);
        else if (finish.find("phong") != std::string::npos) CHECK(found.mean() < 1.0);
        else CHECK(found.mean() == Approx(1.0).margin(1e-3));
    }
    const Paths glass =
        traced(sky + "sphere { 0, 1 pigment { rgbt 1 } finish { diffuse 0 } interior { ior 1.5 } }", 64);
    CHECK(glass.mean() == Approx(1.0).margin(0.02));
    const Paths too_much = traced(sky + "sphere { 0, 1 pigment { rgb 1 } finish { diffuse 1 reflection .8 } }", 64);
    CHECK(too_much.mean() == Approx(1.0).margin(1e-3));
}

TEST_CASE("in a closed box of diffuse walls that glow light is the sum of the geometric series", "[path]")
{
    for (const double albedo : {0.2, 0.5, 0.8}) {
        const Paths found = traced("camera { location <.2,.1,-.7> look_at .3*y angle 90 }\n"
                                   "box { -1, 1 pigment { rgb " +
                                       std::to_string(albedo) + " } finish { diffuse 1 emission " +
                                       std::to_string(0.1 / albedo) + " } }",
                                   256);
        INFO(albedo);
        CHECK(found.mean() == Approx(0.1 / (1.0 - albedo)).epsilon(0.01));
    }
}

TEST_CASE("direct light of lamps is that of the Whitted picture", "[path]")
{
    // A single surface that sees nothing but lamps: no path brings more.
    const std::string lamps[] = {
        "light_source { <3,5,-4> rgb .7 }",
        "light_source { <3,5,-4> rgb .7 fade_distance 2 fade_power 2 }",
        "light_source { <1,3,-4> rgb .7 spotlight radius 8 falloff 20 tightness 3 point_at 0 }",
        "light_source { <1,3,-4> rgb .7 cylinder radius .5 falloff 1 point_at 0 }",
        "light_source { <1,3,-4> rgb .7 parallel point_at 0 }",
        "light_source { <1,3,-4> rgb .7 shadowless } light_source { <-3,0,-4> rgb .2 }",
        "light_source { <1,2,-2> rgb .7 area_light x, y, 5, 5 area_illumination on }"};
    const std::string finishes[] = {"diffuse .6", "diffuse .6 brilliance 2 phong .7 phong_size 10",
                                    "diffuse .4 specular .6 roughness .05 metallic"};
    for (const std::string& lamp : lamps)
        for (const std::string& finish : finishes) {
            const std::string text = kCamera + lamp +
                                     "sphere { 0, 1 pigment { rgb <.9,.6,.3> } normal { bumps .2 scale .3 } " +
                                     "finish { ambient 0 " + finish + " } }";
            const Paths path = traced(text, 64), whitted = traced(text, 64, false);
            INFO(lamp << " " << finish);
            // The Whitted picture lights bent normals from behind the surface itself too: a pixel or two, by less.
            const double margin = lamp.find("area") != std::string::npos      ? 0.02
                                  : lamp.find("} light") != std::string::npos ? 0.05
                                                                              : 1e-3;
            for (int y = 0; y < kSide; ++y)
                for (int x = 0; x < kSide; ++x)
                    for (std::size_t c = 0; c < 3; ++c) {
                        const double truth = whitted.picture.at(x, y).mean(c);
                        CHECK(path.picture.at(x, y).mean(c) == Approx(truth).margin(margin));
                    }
        }
}

TEST_CASE("the same paths for any number of threads", "[path]")
{
    const std::string text =
        "camera { location <0,1,-4> look_at 0 }\n"
        "light_source { <3,5,-3> rgb 1 area_light x, z, 5, 5 }\n"
        "plane { y,-1 pigment { checker rgb 1 rgb .2 } }\n"
        "sphere { 0, 1 no_reflection pigment { rgb <.8,.3,.2> } finish { reflection .3 phong .5 } }\n"
        "sphere { <1,0,-1>, .5 pigment { rgbf .9 } interior { ior 1.5 dispersion 1.05 } }\n";
    const Paths one = traced(text, 32, true, 1), four = traced(text, 32, true, 4);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) CHECK(one.picture.at(x, y).sum == four.picture.at(x, y).sum);
    CHECK(one.statistics.error == four.statistics.error);
}

TEST_CASE("Fresnel's share at a boundary", "[path]")
{
    CHECK(texture::fresnel_share(1.5, 1.0) == Approx(0.04));
    CHECK(texture::fresnel_share(1.0 / 1.5, 1.0) == Approx(0.04));
    CHECK(texture::fresnel_share(1.5, 0.0) == Approx(1.0));
    CHECK(texture::fresnel_share(1.0 / 1.5, 0.5) == 1.0);                  // beyond the critical angle
    CHECK(texture::fresnel_share(1.0, 0.3) == Approx(0.0).margin(1e-15));  // no boundary
    // Polarised light along the plane of incidence is not mirrored at Brewster's angle: half of the other is left.
    const double brewster = std::cos(std::atan(1.5)), s = (1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0);
    CHECK(texture::fresnel_share(1.5, brewster) == Approx(0.5 * s * s));
}

TEST_CASE("a body absorbs light by Beer and Lambert", "[path]")
{
    const auto through = [](double thickness) {
        return traced(
            kCamera + "background { rgb 1 }\nbox { <-9,-9,0>, <9,9," + std::to_string(thickness) +
                "> pigment { rgbt 1 } finish { diffuse 0 } interior { fade_distance 2 fade_power 1 fade_color "
                "rgb <.2,0,1> } }",
            1);
    };
    for (const double d : {0.5, 2.0, 7.0}) {
        const Paths found = through(d);
        CHECK(found.mean(0) == Approx(std::pow(0.6, d / 2.0)).epsilon(1e-4));
        CHECK(found.mean(1) == Approx(std::pow(0.5, d / 2.0)).epsilon(1e-4));
        CHECK(found.mean(2) == Approx(1.0));
    }
}

TEST_CASE("a sphere that glows lights a plane as the closed form says", "[path]")
{
    // Below its middle a plane sees a sphere of radiance L under the irradiance pi L (r / h)^2.
    const Paths found = traced("camera { orthographic location 4*z right .02*x up .02*y direction -z sky y }\n"
                               "plane { z, 0 pigment { rgb 1 } finish { diffuse 1 } }\n"
                               "sphere { 2*z, 1 no_image pigment { rgb 1 } finish { diffuse 0 emission 2 } }",
                               64);
    CHECK(found.mean() == Approx(2.0 * 0.25).epsilon(0.01));
}

TEST_CASE("glowing bodies of any shape are found by aim and by chance, and counted once", "[path]")
{
    // Seen from inside of a white box that is closed but for them, light adds up to what the furnace has.
    for (const std::string body : {"sphere { <.2,.3,.1>, .4", "box { <-.5,.9,-.5>, <.5,.95,.5>",
                                   "box { -.2, .2 rotate <20,30,40> translate .4*y", "cylinder { -.3*y, .3*y, .2",
                                   "cylinder { -.3*y, .3*y, .2 scale <1,1.5,1> rotate <20,30,40>",
                                   "disc { <0,.5,0>, <.2,1,.3>, .6, .2", "triangle { -.5*x, .5*x+.2*z, .4*z+.3*y",
                                   "mesh { triangle { -.5*x, .5*x+.2*z, .4*z+.3*y } triangle { 0, .5*y, .6*z }"
                                   " triangle { -.2*x, .4*y-.3*x, .5*z }",
                                   "difference { sphere { 0, .4 } box { 0, 1 }"}) {
        const std::string text = "camera { location <.7,-.5,-.8> look_at <-.2,-1,.4> angle 60 }\n"
                                 "box { -1, 1 hollow pigment { rgb .5 } finish { diffuse 1 emission .5 } }\n" +
                                 body + " pigment { rgb 1 } finish { diffuse 0 emission .5 } }";
        const Paths found = traced(text, 128);
        INFO(body);
        CHECK(found.mean() == Approx(0.5).epsilon(0.02));  // walls and bodies are of the same radiance
    }
}

TEST_CASE("a lamp that is a glowing box lights a wall as its form factor says", "[path]")
{
    // Point below the middle of a square of half side 1 at distance 1 (Howell, B-4): 4 times that of its corner.
    const double a = 1.0 / std::sqrt(2.0), factor = 4.0 / (2.0 * M_PI) * 2.0 * a * std::atan(a);
    const Paths found =
        traced("camera { orthographic location 4*z right .02*x up .02*y direction -z sky y }\n"
               "plane { z, 0 pigment { rgb 1 } finish { diffuse 1 } }\n"
               "box { <-1,-1,1>, <1,1,1.2> no_image pigment { rgb 1 } finish { diffuse 0 emission 1 } }",
               64);
    CHECK(found.mean() == Approx(factor).epsilon(0.005));
}

TEST_CASE("a small sun in the sky is aimed at", "[path]")
{
    // A disc of radiance 100 and of the angular radius a: the irradiance pi L sin^2 a.
    const double radius = 3.0 * M_PI / 180.0;
    const std::string sky =
        "sky_sphere { pigment { function { select(" + std::to_string(std::cos(radius)) +
        " - y / sqrt(x*x+y*y+z*z), 1, 0) } color_map { [0 rgb 0] [.5 rgb 0] [.5 rgb 100] [1 rgb 100] } } }\n";
    const Paths found = traced("camera { orthographic location 4*y right x up z direction -y sky z }\n" + sky +
                                   "plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } }",
                               256);
    CHECK(found.mean() == Approx(100.0 * std::pow(std::sin(radius), 2)).epsilon(0.01));
    CHECK(found.statistics.error < 3.0);  // by chance alone it would be ten times that
}

namespace {

/// Root mean square over pixels and colours, in linear light as far as it is shown: up to white.
double apart(const image::Image& a, const image::Image& b)
{
    const auto shown = [](float light) { return std::clamp(static_cast<double>(light), 0.0, 1.0); };
    double sum = 0.0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int k = 0; k < 3; ++k) sum += std::pow(shown(a.at(x, y)[k]) - shown(b.at(x, y)[k]), 2);
    return std::sqrt(sum / (3.0 * a.width * a.height));
}

struct Filtered {
    image::Image plain, filtered;
};

constexpr int kWide = 64;

Filtered filtered(const std::string& text, std::uint32_t samples, std::uint32_t seed, int threads = 0)
{
    plan::Options options;
    options.width = options.height = kWide;
    options.free_sampling = options.paths = true;
    trace::RenderOptions render;
    render.threads = threads;
    trace::SamplingGoal goal;
    goal.samples = samples;
    goal.seed = seed;
    trace::SampledPicture picture(kWide, kWide);
    trace::PathFeatures features(kWide, kWide);
    trace::render_sampled(plan::compile(parser::parse_text(kHead + text, "t.pov", {}).scene, options), render, goal,
                          kLinear, picture, {}, &features);
    Filtered out;
    picture.show(out.plain);
    trace::denoise(picture, features, 2, out.filtered);
    return out;
}

const std::string kBox =
    "camera { location <0,1,-3.4> look_at <0,1,0> angle 40 right x up y }\n"
    "#default { finish { ambient 0 diffuse 1 } } #declare W = pigment { rgb .75 }\n"
    "plane { y, 0 pigment { checker rgb .75 rgb .3 scale .25 } } plane { -y, -2 pigment { W } } plane { -z, -1 pigment "
    "{ W } }\n"
    "plane { x, -1 pigment { rgb <.75,.25,.25> } } plane { -x, -1 pigment { rgb <.25,.25,.75> } }\n"
    "box { <-.5,1.95,-.5>, <.5,1.99,.5> pigment { rgb 1 } finish { diffuse 0 emission 3 } }\n"
    "box { <-.6,0,.1>, <-.1,1.1,.6> pigment { W } rotate 15*y } sphere { <.4,.35,-.2>, .35 pigment { W } }\n";

}  // namespace

TEST_CASE("the filter brings a picture of few paths nearer to what many converge to", "[path]")
{
    const Filtered truth = filtered(kBox, 512, 1);
    double before = 1e9;
    for (const std::uint32_t samples : {1u, 4u, 16u, 64u}) {
        const Filtered found = filtered(kBox, samples, 0);
        const double plain = apart(found.plain, truth.plain), smooth = apart(found.filtered, truth.plain);
        INFO(samples << " samples: " << plain << ", filtered " << smooth);
        CHECK(smooth < (samples > 16 ? 0.9 : 0.7) * plain);
        CHECK(smooth < before);  // and it converges
        before = smooth;
    }
    CHECK(apart(truth.filtered, truth.plain) < 0.02);
    CHECK(apart(filtered(kBox, 8, 0, 1).filtered, filtered(kBox, 8, 0, 4).filtered) == 0.0);
}

TEST_CASE("the filter leaves a picture without noise as it is", "[path]")
{
    const Filtered found = filtered("camera { location -3*z look_at 0 }\nbackground { rgb <.2,.4,.6> }\n", 8, 0);
    CHECK(apart(found.plain, found.filtered) < 1e-6);
}

TEST_CASE("a Cornell box by paths is that of radiosity within what radiosity is off by", "[path]")
{
    const auto box = [](const std::string& radiosity) {
        return "#version 3.7; global_settings { assumed_gamma 1 " + radiosity + " }\n" + kBox;
    };
    plan::Options options;
    options.width = options.height = kSide;
    options.free_sampling = true;
    const plan::CompiledScene scene = plan::compile(
        parser::parse_text(box("radiosity { recursion_limit 8 count 300 error_bound .5 nearest_count 6 }"), "t.pov", {})
            .scene,
        options);
    trace::RenderOptions render;
    const auto indirect = trace::run_passes(scene, render);
    render.indirect = indirect.get();
    trace::SamplingGoal goal;
    goal.samples = 8;
    Paths gathered, paths = traced(kBox, 256);
    gathered.statistics = trace::render_sampled(scene, render, goal, kLinear, gathered.picture);
    for (std::size_t c = 0; c < 3; ++c) CHECK(gathered.mean(c) == Approx(paths.mean(c)).epsilon(0.08));
}
