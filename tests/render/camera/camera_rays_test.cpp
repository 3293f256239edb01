#include "parser/parse.h"
#include "render/kernel/camera/camera_rays.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace {

constexpr int kWidth = 8, kHeight = 6;

/// A ray of POV-Ray 3.7.0.10, read from a picture of a sky whose colour is the direction.
struct Measured {
    double px, py;
    bool found;
    glm::dvec3 direction;
};

/// data/camera_directions.csv: camera block (quoted), pixel, direction; no direction where the camera has no ray.
std::map<std::string, std::vector<Measured>> measurements()
{
    std::ifstream in(CAMERA_TEST_DATA "/camera_directions.csv");
    std::map<std::string, std::vector<Measured>> cameras;
    std::string line;
    std::getline(in, line);  // the names of the columns
    while (std::getline(in, line)) {
        std::size_t at = 0;
        std::string block;
        if (line[0] == '"') {
            at = line.find('"', 1);
            block = line.substr(1, at - 1);
            ++at;
        } else {
            at = line.find(',');
            block = line.substr(0, at);
        }
        std::vector<std::string> fields;
        while (at != std::string::npos) {
            const std::size_t next = line.find(',', at + 1);
            fields.push_back(line.substr(at + 1, next == std::string::npos ? next : next - at - 1));
            at = next;
        }
        REQUIRE(fields.size() == 5);
        Measured ray{
            std::stod(fields[0]), std::stod(fields[1]), fields[2].find_first_of("0123456789") != std::string::npos, {}};
        if (ray.found) ray.direction = {std::stod(fields[2]), std::stod(fields[3]), std::stod(fields[4])};
        cameras[block].push_back(ray);
    }
    return cameras;
}

trace::CameraRays camera_of(const std::string& block)
{
    parser::Options options;
    options.image_width = kWidth;
    options.image_height = kHeight;
    const auto result = parser::parse_text(
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { " + block + " }\n", "camera.pov", options);
    return {result.scene.camera, kWidth, kHeight};
}

}  // namespace

TEST_CASE("every kind of camera sends its rays where POV-Ray's goes", "[trace][camera]")
{
    // The measured picture has 16 bits over 3 units, and the list four decimals.
    constexpr double kMeasured = 1e-4;
    const auto cameras = measurements();
    REQUIRE(cameras.size() == 27);
    for (const auto& [block, rays] : cameras) {
        INFO("camera { " << block << " }");
        REQUIRE(rays.size() == kWidth * kHeight);
        const trace::CameraRays camera = camera_of(block);
        for (const Measured& measured : rays) {
            INFO("pixel " << measured.px << ", " << measured.py);
            csg::Ray ray;
            const bool found = camera.ray(measured.px, measured.py, ray);
            CHECK(found == measured.found);
            if (!found || !measured.found) continue;
            CHECK(glm::length(ray.direction) == Approx(1.0).epsilon(1e-14));
            CHECK(glm::length(ray.direction - measured.direction) < kMeasured);
        }
    }
}

TEST_CASE("rays have the last bits of 3.8's", "[trace][camera]")
{
    // On which side of y = 0 hits on plane { y, 0 } came to lie, as 3.8 showed it (spec 7d, 6).
    constexpr int kColumns = 24, kRows = 11;
    const char* const seen[kRows] = {"00000-00000++00000-00000", "0-0000000-0000-0000000-0", "0000+0000000000000000000",
                                     "+00000000000000000++000+", "00000000-0+00-0-00000000", "000-00+0+------0-+00-000",
                                     "-00-0000000000000000000-", "0-+000000000000000000+00", "00000000000--00000000000",
                                     "0000000000+0000000000000", "000000000000000000000000"};
    scene::Camera camera =
        parser::parse_text("#version 3.8; camera { location <50,55,-75> right 2*x up y look_at <-10,18,0> }", "c.pov",
                           {})
            .scene.camera;
    camera.povray = scene::PovRay::V38;
    const trace::CameraRays rays(camera, kColumns, kRows + 1);
    for (int row = 0; row < kRows; ++row) {
        std::string ours, in_lanes;
        csg::RayTile tile;
        tile.count = kColumns;
        alignas(64) double px[kColumns], py[kColumns];
        for (int x = 0; x < kColumns; ++x) {
            px[x] = x;
            py[x] = row + 1;
        }
        REQUIRE(rays.perspective(px, py, tile));
        const auto side = [](double origin, double way) {
            const double y = origin + -origin / way * way;
            return y < 0.0 ? '-' : y > 0.0 ? '+' : '0';
        };
        for (int x = 0; x < kColumns; ++x) {
            csg::Ray ray;
            REQUIRE(rays.ray(x, row + 1, ray));
            ours += side(ray.origin.y, ray.direction.y);
            in_lanes += side(ray.origin.y, tile.dy[static_cast<std::size_t>(x)]);
        }
        CHECK(ours == seen[row]);
        CHECK(in_lanes == seen[row]);
    }
}

TEST_CASE("rays of a camera with one eye start there", "[trace][camera]")
{
    for (const char* block : {"", "fisheye angle 360 right x up y", "ultra_wide_angle angle 140", "omnimax",
                              "panoramic", "cylinder 1", "cylinder 2", "spherical"}) {
        INFO("camera { " << block << " }");
        const trace::CameraRays camera = camera_of(std::string(block) + " translate <1, 2, 3>");
        CHECK(camera.common_origin());
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                if (csg::Ray ray; camera.ray(x, y, ray)) CHECK(ray.origin == glm::dvec3(1, 2, 3));
    }
    for (const char* block : {"orthographic", "cylinder 3", "cylinder 4"})
        CHECK_FALSE(camera_of(block).common_origin());
}

TEST_CASE("orthographic rays are parallel and start in the picture's plane", "[trace][camera]")
{
    const trace::CameraRays camera = camera_of("orthographic location <0, 0, -5> right 8*x up 6*y direction z");
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            csg::Ray ray;
            REQUIRE(camera.ray(x, y, ray));
            CHECK(ray.direction == glm::dvec3(0, 0, 1));
            CHECK(glm::length(ray.origin - glm::dvec3(x - 3.5, 2.5 - y, -5)) < 1e-12);
        }
}

TEST_CASE("rays of an orthographic camera are the same in lanes as alone", "[camera]")
{
    for (const char* block : {"orthographic location <1, 2, -7> look_at <.3, .1, 0> angle 33",
                              "orthographic location 10*y direction -3*y up 2.2*z right 3*x"}) {
        const trace::CameraRays camera = camera_of(block);
        REQUIRE(camera.is_parallel());
        csg::RayTile rays;
        alignas(64) std::array<double, csg::kTileRays> px{}, py{};
        for (std::size_t k = 0; k < 45; ++k) {
            px[k] = static_cast<double>(k % 8) + 0.1 * static_cast<double>(k % 3);
            py[k] = static_cast<double>(k / 8) - 0.3;
        }
        rays.count = 45;
        REQUIRE(camera.parallel(px.data(), py.data(), rays));
        for (int k = 0; k < rays.count; ++k) {
            csg::Ray alone;
            REQUIRE(camera.ray(px[static_cast<std::size_t>(k)], py[static_cast<std::size_t>(k)], alone));
            CHECK(rays.ray(k).origin == alone.origin);
            CHECK(rays.ray(k).direction == alone.direction);
        }
    }
}
