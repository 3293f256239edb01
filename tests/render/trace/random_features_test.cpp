#include "render/picture/render.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

// What is drawn at random cannot be compared pixel by pixel with POV-Ray; its distribution follows from the definition.

namespace {

scene::Object with_color(scene::Shape shape, float diffuse, float crand)
{
    scene::Layer layer;
    layer.pigment.kind = scene::Color{1, 1, 1, 0, 0};
    layer.finish.edit().ambient = glm::vec3(0);
    layer.finish.edit().diffuse = diffuse;
    layer.finish.edit().crand = crand;
    auto texture = std::make_shared<scene::Texture>();
    texture->kind = std::vector<scene::Layer>{layer};
    scene::Object made;
    made.shape = std::move(shape);
    made.texture = texture;
    return made;
}

/// A wall at z = 0 seen from z = -10 in 4 by 3 units, and a light.
scene::Description wall(const scene::Light& light, float crand)
{
    scene::Description d;
    d.camera.location = {0, 0, -10};
    d.camera.direction = {0, 0, 10};
    d.camera.right = {4, 0, 0};
    d.camera.up = {0, 3, 0};
    d.objects.push_back(with_color(scene::Plane{{0, 0, -1}, 0}, 0.8f, crand));
    scene::Object lamp;
    lamp.shape = light;
    d.objects.push_back(lamp);
    return d;
}

image::Image picture_of(const scene::Description& description)
{
    plan::Options options;
    options.width = 80;
    options.height = 60;
    image::Image out;
    trace::render(plan::compile(description, options), trace::RenderOptions{}, out);
    return out;
}

double red(const image::Image& picture, int x, int y)
{
    return static_cast<double>(picture.pixels[4 * static_cast<std::size_t>(y * picture.width + x)]);
}

}  // namespace

TEST_CASE("a rainbow's jitter moves each pixel by an equally distributed share of its width", "[trace][random]")
{
    scene::Description d;
    d.camera.direction = {0, 0, 1};
    d.camera.right = {1.6, 0, 0};
    d.camera.up = {0, 1.2, 0};
    scene::Rainbow bow;
    bow.direction = {0, 0, 1};
    bow.angle_deg = 20;
    bow.width_deg = 10;
    bow.jitter = 0.3;
    bow.colors = {{0.0, scene::Color{1, 1, 1, 0, 0}}, {1.0, scene::Color{1, 1, 1, 0, 0}}};
    d.rainbows.push_back(bow);
    const image::Image picture = picture_of(d);
    double expected = 0, variance = 0, seen = 0;
    int inside = 0, missing = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const double u = ((x + 0.5) / 80 - 0.5) * 1.6, v = (0.5 - (y + 0.5) / 60) * 1.2;
            const double place = (glm::degrees(std::atan(std::hypot(u, v))) - 15) / 10;
            // The share of [place - 0.3, place + 0.3] that lies between the edges.
            const double share = std::max(0.0, std::min(1.0, place + 0.3) - std::max(0.0, place - 0.3)) / 0.6;
            const bool here = red(picture, x, y) > 0.5;
            expected += share;
            variance += share * (1 - share);
            seen += here ? 1 : 0;
            if (place > 0.31 && place < 0.69) {
                ++inside;
                missing += here ? 0 : 1;
            }
        }
    CHECK(inside > 200);
    CHECK(missing == 0);
    CHECK(variance > 100);
    CHECK(std::abs(seen - expected) < 4 * std::sqrt(variance));
}

TEST_CASE("crand takes off an equally distributed share of itself", "[trace][random]")
{
    scene::Light light;
    light.location = {0, 0, -10};
    light.parallel = true;
    const image::Image picture = picture_of(wall(light, 0.4f));
    double sum = 0, squares = 0, least = 1, most = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) {
            const double value = red(picture, x, y);
            sum += value;
            squares += value * value;
            least = std::min(least, value);
            most = std::max(most, value);
        }
    const double mean = sum / 4800, deviation = std::sqrt(squares / 4800 - mean * mean);
    // 0.8 less 0.4 times a number of [0, 1): the mean of 4800 has the standard error 0.0017.
    CHECK(mean == Approx(0.6).margin(0.007));
    CHECK(deviation == Approx(0.4 / std::sqrt(12.0)).margin(0.005));
    CHECK(least >= 0.4 - 1e-6);
    CHECK(least < 0.402);
    CHECK(most <= 0.8 + 1e-6);
    CHECK(most > 0.798);
}

TEST_CASE("jitter moves the points of an area light by half a step at most", "[trace][random]")
{
    // Two points at x = -1 and 1; a screen half way covers x > 0: the wall at x sees the lamp left of -x. Points that
    // move by up to a whole unit fill -2 to 2 evenly, so the share that is seen falls as a straight line.
    scene::Light light;
    light.location = {0, 0, -4};
    light.parallel = false;
    light.area = true;
    light.axis1 = {2, 0, 0};
    light.axis2 = {0, 1, 0};
    light.size1 = 2;
    light.size2 = 1;
    for (const bool jitter : {false, true}) {
        light.jitter = jitter;
        scene::Description open = wall(light, 0);
        scene::Description covered = open;
        covered.objects.push_back(with_color(scene::Box{{0, -50, -2.001}, {50, 50, -2}}, 0, 0));
        covered.objects.back().flags.no_image = true;
        const image::Image bright = picture_of(open), shaded = picture_of(covered);
        for (int column = 2; column < 78; ++column) {
            const double x = 4.0 * ((column + 0.5) / 80 - 0.5);
            double seen = 0;
            for (int row = 0; row < 60; ++row) seen += red(shaded, column, row) / red(bright, column, row) / 60;
            INFO("jitter " << jitter << " x " << x);
            if (jitter)
                CHECK(seen ==
                      Approx((2.0 - x) / 4.0)
                          .margin(0.13));  // 4 standard errors of 60 throws for a half: 4 * 0.5 * 0.5 / sqrt(60)
            else
                CHECK(seen == Approx(x < -1  ? 1.0
                                     : x > 1 ? 0.0
                                             : 0.5)
                                  .margin(std::abs(std::abs(x) - 1) < 0.06 ? 0.51 : 0.01));
        }
    }
}
