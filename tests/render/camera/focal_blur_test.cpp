#include "render/kernel/camera/focal_blur.h"

#include <catch2/catch.hpp>

using trace::FocalBlur;

namespace {

scene::Camera lens(int samples, double variance = 1.0 / 128.0)
{
    scene::Camera camera;
    camera.aperture = 2.0;
    camera.focal_distance = 6.0;
    camera.blur_samples = samples;
    camera.variance = variance;
    return camera;
}

FocalBlur blur_of(const scene::Camera& camera) { return {camera, texture::TextureSet{}, texture::kNone}; }

}  // namespace

TEST_CASE("focal blur takes its samples in POV-Ray's batches", "[camera][blur]")
{
    const auto batches = [](int samples) {
        const FocalBlur blur = blur_of(lens(samples));
        std::vector<int> sizes;
        for (int taken = 0; taken < samples; taken += sizes.back()) {
            REQUIRE(blur.batch(taken) > 0);
            sizes.push_back(blur.batch(taken));
        }
        CHECK(blur.batch(samples) == 0);
        return sizes;
    };
    CHECK(batches(1) == std::vector{1});
    CHECK(batches(5) == std::vector{4, 1});
    CHECK(batches(10) == std::vector{7, 3});
    CHECK(batches(25) == std::vector{7, 6, 6, 4, 2});
    CHECK(batches(37) == std::vector{7, 6, 6, 4, 4, 4, 4, 2});
}

TEST_CASE("rays of focal blur meet on the focal plane and leave a lens of half the aperture", "[camera][blur]")
{
    const scene::Camera camera = lens(60);
    const FocalBlur blur = blur_of(camera);
    const trace::CameraRays rays(camera, 40, 30);
    double farthest = 0.0;
    for (int n = 0; n < 60; ++n) {
        csg::Ray ray;
        REQUIRE(blur.ray(rays, {20, 15}, n, ray));
        CHECK(glm::length(ray.direction) == Approx(1.0));
        CHECK(ray.origin.z == Approx(0.0).margin(1e-12));
        farthest = std::max(farthest, glm::length(ray.origin));
        // Within a pixel of where the sample's own ray meets the plane z = 6.
        const glm::dvec3 met = ray.at(6.0 / ray.direction.z);
        CHECK(std::abs(met.x - 6.0 * (20.5 / 40 - 0.5) * 4.0 / 3.0) <= 6.0 * 4.0 / 3.0 / 40);
        CHECK(std::abs(met.y - 6.0 * (14.5 / 30 - 0.5)) <= 6.0 / 30);
    }
    CHECK(farthest > 0.3);
    CHECK(farthest < 0.65);  // a quarter of the aperture and the jitter
}

TEST_CASE("rays of focal blur are the same in lanes and alone", "[camera][blur]")
{
    scene::Camera camera = lens(60);
    camera.location = {1.5, -2.25, 0.3};
    camera.direction = glm::dvec3(0.1, -0.2, 1.3);
    const FocalBlur blur = blur_of(camera);
    const trace::CameraRays rays(camera, 320, 240);
    for (const int count : {64, 13, 1}) {
        FocalBlur::Waiting waiting;
        waiting.count = count;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            waiting.x[i] = 17.0 * static_cast<double>(i) - 0.37;
            waiting.y[i] = 3.0 * static_cast<double>(i) + 0.125;
            waiting.n[i] = static_cast<int>(7 * i % 60);
        }
        csg::RayTile tile;
        REQUIRE(blur.rays(rays, waiting, tile));
        REQUIRE(tile.count == count);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            INFO("ray " << i << " of " << count);
            csg::Ray alone;
            REQUIRE(blur.ray(rays, {waiting.x[i], waiting.y[i]}, waiting.n[i], alone));
            CHECK(alone.origin == glm::dvec3(tile.ox[i], tile.oy[i], tile.oz[i]));
            CHECK(alone.direction == glm::dvec3(tile.dx[i], tile.dy[i], tile.dz[i]));
        }
    }
    camera.kind = scene::Camera::Kind::Fisheye;
    csg::RayTile tile;
    CHECK_FALSE(blur.rays(trace::CameraRays(camera, 320, 240), {}, tile));
}

TEST_CASE("focal blur is certain of what does not change, and of nothing at variance 0", "[camera][blur]")
{
    FocalBlur::Sums same, mixed;
    for (int n = 0; n < 7; ++n) {
        same.add({0.5f, 0.5f, 0.5f, 0, 0}, true);
        mixed.add({n % 2 == 0 ? 1.0f : 0.0f, 0, 0, 0, 0}, true);
    }
    CHECK(blur_of(lens(37)).converged(same));
    CHECK_FALSE(blur_of(lens(37)).converged(mixed));
    CHECK_FALSE(blur_of(lens(37, 0.0)).converged(same));
    scene::Camera patient = lens(37);
    patient.blur_fewest = 20;
    CHECK_FALSE(blur_of(patient).converged(same));
    CHECK(mixed.mean().red == Approx(4.0 / 7.0));
}

// Where the one ray of `blur_samples 1` meets the plane z = 2, focused on z = 1: read from both programs' pictures
// of 12x8 pixels of 16 bits (spec 7d, 6).
TEST_CASE("rays of focal blur leave the lens where 3.7's or 3.8's do", "[camera][blur]")
{
    struct Met {
        glm::dvec2 pixel, old, now;
    };
    for (const Met& met :
         {Met{{0, 0}, {-0.8043, 1.0333}, {-0.8492, 0.9816}}, Met{{3, 2}, {-0.2896, 0.5276}, {-0.2915, 0.7473}},
          Met{{7, 5}, {0.1989, -0.4020}, {0.2038, -0.3775}}, Met{{11, 7}, {0.9670, -0.5427}, {0.8683, -1.0036}}})
        for (const auto povray : {scene::PovRay::V37, scene::PovRay::V38}) {
            scene::Camera camera = lens(1, 0.0);
            camera.aperture = camera.focal_distance = 1.0;
            camera.right = {1, 0, 0};
            camera.povray = povray;
            csg::Ray ray;
            REQUIRE(blur_of(camera).ray(trace::CameraRays(camera, 12, 8), met.pixel, 0, ray));
            const glm::dvec3 at = ray.at((2.0 - ray.origin.z) / ray.direction.z);
            const glm::dvec2 expected = povray == scene::PovRay::V37 ? met.old : met.now;
            INFO("pixel " << met.pixel.x << ", " << met.pixel.y);
            CHECK(at.x == Approx(expected.x).margin(1e-4));
            CHECK(at.y == Approx(expected.y).margin(1e-4));
        }
}
