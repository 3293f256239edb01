// Finishes and lights beyond POV-Ray's words, by closed forms and laws: docs/extensions.md.
#include "render/texture/finish.h"
#include "render/picture/render.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

namespace {

image::Image extended_picture(const std::string& text, int width = 1, int height = 1, int threads = 1)
{
    plan::Options options;
    options.width = width;
    options.height = height;
    trace::RenderOptions render;
    render.threads = threads;
    image::Image out;
    trace::render(
        plan::compile(
            parser::parse_text("#version 3.7; global_settings { assumed_gamma 1 }\n" + text, "t.pov", {}).scene,
            options),
        render, out);
    return out;
}

/// Red of the only pixel.
double red_of_pixel(const std::string& text) { return static_cast<double>(extended_picture(text).at(0, 0)[0]); }

const std::string kThinView = "camera { orthographic location <0,0,0> direction z right 1e-6*x up 1e-6*y }\n";
const std::string kBlackMirror = "plane { -z, -5 pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { 1 ";

std::string text_of_number(double v) { return std::to_string(v); }

}  // namespace

TEST_CASE("a rough mirror sees a disc by the power of the cosine around the mirrored ray", "[extensions]")
{
    for (const double roughness : {0.1, 0.02, 0.005}) {
        const double alpha = std::acos(std::pow(0.4, 1.0 / (1.0 / roughness + 1.0)));  // share 0.6
        const std::string disc = "disc { <0,0,-10>, z, " + text_of_number(15.0 * std::tan(alpha)) +
                                 " pigment { rgb 1 } finish { ambient 1 diffuse 0 } }\n";
        CHECK(red_of_pixel(kThinView + disc + kBlackMirror + "whittle_gloss " + text_of_number(roughness) +
                           ", 1024 } } }\n") == Approx(0.6).margin(0.01));
    }
}

TEST_CASE("a rough mirror in even light is as bright as a sharp one", "[extensions]")
{
    const std::string sky = "background { rgb 0.25 }\n";
    for (const char* samples : {"1", "3", "16", "100"})
        CHECK(red_of_pixel(kThinView + sky + kBlackMirror + "whittle_gloss 0.3, " + samples + " } } }\n") ==
              Approx(0.25).margin(1e-6));
    CHECK(red_of_pixel(kThinView + sky + kBlackMirror + "whittle_gloss 0 } } }\n") == Approx(0.25).margin(1e-6));
}

TEST_CASE("layers with rough and sharp mirrors add up in even light as sharp ones do", "[extensions]")
{
    const auto layered = [](const std::string& lower, const std::string& middle, const std::string& upper) {
        const auto layer = [](const std::string& pigment, const std::string& mirror) {
            return "texture { pigment { " + pigment + " } finish { ambient 0 diffuse 0 reflection { " + mirror +
                   " } } }\n";
        };
        return red_of_pixel(kThinView + "background { rgb 0.25 }\nplane { -z, -5 " + layer("rgb 0", "0.2 " + lower) +
                            layer("rgbt 1", "0.3 " + middle) + layer("rgbt 1", "0.4 " + upper) + "}\n");
    };
    const double sharp = layered("", "", "");
    CHECK(sharp > 0.1);
    const std::string rough = "whittle_gloss 0.05, 8";
    CHECK(layered(rough, "", "") == Approx(sharp));
    CHECK(layered("", rough, "") == Approx(sharp));
    CHECK(layered("", "", rough) == Approx(sharp));
    CHECK(layered(rough, rough, rough) == Approx(sharp));
}

TEST_CASE("rough mirrors give the same bytes for any number of threads", "[extensions]")
{
    const std::string text =
        "camera { location <0,1,-4> look_at 0 }\nlight_source { <3,5,-4> rgb 1 }\n"
        "plane { y,-1 pigment { checker rgb 1 rgb 0 } finish { reflection { .4 whittle_gloss .01 } } }\n"
        "sphere { 0,1 pigment { rgb .2 } finish { reflection { .8 whittle_gloss .05, 8 } } }\n";
    const image::Image one = extended_picture(text, 64, 48, 1), two = extended_picture(text, 64, 48, 2);
    CHECK(std::memcmp(one.pixels.data(), two.pixels.data(), one.pixels.size() * sizeof(float)) == 0);
}

TEST_CASE("Schlick's approximation meets Fresnel's law head-on and at grazing angles", "[extensions]")
{
    texture::Finish exact;
    exact.fresnel = true;
    exact.reflection_max = glm::vec3(1);
    texture::Finish schlick = exact;
    schlick.schlick = true;
    const auto share = [](const texture::Finish& finish, double eta, double degrees) {
        const double a = degrees * std::numbers::pi / 180.0;
        return static_cast<double>(texture::reflectivity(finish, {}, {std::sin(a), -std::cos(a), 0}, {0, 1, 0}, eta).x);
    };
    // The largest differences over all angles, worked out apart from these formulas to four digits, rounded up.
    for (const auto& [eta, apart] : {std::pair{1.3, 0.0684}, {1.5, 0.0358}, {2.4, 0.0741}}) {
        const double head_on = (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
        CHECK(share(schlick, eta, 0.0) == Approx(head_on));
        CHECK(share(exact, eta, 0.0) == Approx(head_on));
        CHECK(share(schlick, eta, 90.0) == Approx(1.0));
        CHECK(share(schlick, eta, 60.0) == Approx(head_on + (1.0 - head_on) / 32.0));
        for (double degrees = 0.0; degrees <= 90.0; degrees += 5.0)
            CHECK(std::abs(share(schlick, eta, degrees) - share(exact, eta, degrees)) < apart);
    }
}

TEST_CASE("a white polished surface sends on all the light that it gets", "[extensions]")
{
    constexpr int kSteps = 32;
    const auto view = [](double degrees) {
        const double a = degrees * std::numbers::pi / 180.0;
        return "camera { orthographic location <" + text_of_number(10 * std::sin(a)) + "," +
               text_of_number(10 * std::cos(a)) + ",0> right 1e-6*x up 1e-6*y look_at 0 }\n";
    };
    for (const double head_on : {0.04, 0.3})
        for (const double degrees : {5.0, 45.0, 75.0}) {
            const std::string ground = "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 whittle_polished " +
                                       text_of_number(head_on) + " } }\n";
            const double mirrored = red_of_pixel(view(degrees) + "background { rgb 1 }\n" + ground);
            double matte = 0.0;  // over directions of light, evenly in the square of the sine
            for (int i = 0; i < kSteps; ++i) {
                const double sine = std::sqrt((i + 0.5) / kSteps), cosine = std::sqrt(1.0 - sine * sine);
                matte += red_of_pixel(view(degrees) + ground + "light_source { 0 rgb 1 whittle_directional <" +
                                      text_of_number(-sine) + "," + text_of_number(-cosine) + ", 0> }\n") /
                         cosine / kSteps;
            }
            CHECK(mirrored + matte == Approx(1.0).margin(0.01));
            const double away = 1.0 - std::cos(degrees * std::numbers::pi / 180.0);
            CHECK(mirrored == Approx(head_on + (1.0 - head_on) * std::pow(away, 5.0)).margin(1e-4));
        }
}

TEST_CASE("a directional light comes from one direction everywhere", "[extensions]")
{
    const std::string scene = "light_source { 0 rgb 1 whittle_directional <0,-1,1> }\n"
                              "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n";
    for (const double x : {0.0, -3e5, 4e5}) {
        const std::string at = text_of_number(x);
        const std::string camera = "camera { orthographic location <" + at +
                                   ",2,0> direction -y up z*1e-6 right x*1e-6 }\n";
        CHECK(red_of_pixel(camera + scene) == Approx(std::sqrt(0.5)).margin(1e-5));
        CHECK(red_of_pixel(camera + scene + "box { <" + at + "-1, 5, -6>, <" + at +
                           "+1, 5.1, -4> pigment { rgb 1 } }\n") == 0.0);
    }
}

TEST_CASE("tones go from cool to warm as a surface turns to the light, and know no shadow", "[extensions]")
{
    const auto tone = [](const std::string& direction) {
        return extended_picture(kThinView + "light_source { 0 rgb 1 whittle_directional " + direction +
                                " }\n"
                                "plane { -z, -5 pigment { rgb <.4,.2,.8> } finish { ambient 0 "
                                "whittle_cool_warm rgb <0,0,.4>, rgb <.3,.3,0> } }\n");
    };
    const auto check = [](const image::Image& of, double r, double g, double b) {
        CHECK(static_cast<double>(of.at(0, 0)[0]) == Approx(r).margin(1e-4));
        CHECK(static_cast<double>(of.at(0, 0)[1]) == Approx(g).margin(1e-4));
        CHECK(static_cast<double>(of.at(0, 0)[2]) == Approx(b).margin(1e-4));
    };
    check(tone("z"), 0.3 + 0.2, 0.3 + 0.1, 0.4);  // warm and half of the pigment
    check(tone("-z"), 0.1, 0.05, 0.4 + 0.2);      // cool and a quarter: from behind
    check(tone("x"), 0.3, 0.225, 0.5);            // half of each
}

TEST_CASE("ink lines run along silhouettes and creases, and nowhere else", "[extensions]")
{
    const std::string head = "camera { location -10*z look_at 0 right x up y angle 30 }\nbackground { rgb .5 }\n"
                             "light_source { <0,0,-100> rgb 1 shadowless }\n";
    const std::string look = " pigment { rgb 1 } finish { ambient 1 diffuse 0 whittle_ink 0.3, 40 } }\n";
    constexpr int kSize = 101;
    const auto value = [&](const image::Image& of, int x) { return of.at(x, kSize / 2)[0]; };
    const image::Image ball = extended_picture(head + "sphere { 0, 2" + look, kSize, kSize);
    CHECK(value(ball, 50) == Approx(1.0f));
    CHECK(value(ball, 30) == Approx(1.0f));
    CHECK(value(ball, 2) == Approx(0.5f));
    int dark = 0, runs = 0;
    for (int x = 1; x < kSize; ++x) {
        dark += value(ball, x) < 0.1f ? 1 : 0;
        runs += value(ball, x) < 0.1f && value(ball, x - 1) >= 0.1f ? 1 : 0;
    }
    CHECK(runs == 2);  // both sides
    CHECK(dark >= 2);
    CHECK(dark <= 4);  // 0.3 degrees are one pixel of 101 over 30 degrees
    const image::Image edge = extended_picture(head + "box { -1.2, 1.2 rotate 45*y" + look, kSize, kSize);
    CHECK(value(edge, 50) < 0.1f);  // the edge that faces the camera
    CHECK(value(edge, 40) == Approx(1.0f));
    CHECK(value(edge, 60) == Approx(1.0f));
    // Within the lines a surface is lit as any other.
    const auto lit = [&](const std::string& lines) {
        return value(
            extended_picture(head + "sphere { 0, 2 pigment { rgb 1 } finish { ambient 0 diffuse .5" + lines + " } }\n",
                             kSize, kSize),
            kSize / 2);
    };
    CHECK(lit(" whittle_ink 0.3") == Approx(lit("")));
}
