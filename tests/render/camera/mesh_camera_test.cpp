#include "render/kernel/camera/mesh_camera_ray.h"

#include <catch2/catch.hpp>

// A plane of unit squares' halves as a mesh camera: which face a pixel shows, and from where its ray starts (spec 2,
// section 5).
namespace {

using plan::MeshCamera;

/// `count` triangles in a row along x, facing -z; face k has its centroid at x = k + 1/3.
scene::MeshCamera::Member row_of(int count, double at_y)
{
    auto data = std::make_shared<scene::MeshData>();
    constexpr std::uint32_t kNone = scene::MeshData::kNone;
    for (int k = 0; k < count; ++k) {
        const auto first = static_cast<std::uint32_t>(data->vertices.size());
        for (const glm::dvec2& corner : {glm::dvec2(0, 0), glm::dvec2(0, 1), glm::dvec2(1, 0)}) {
            data->vertices.push_back({k + corner.x, at_y + corner.y, 0.0});
            data->uvs.push_back({(k + corner.x) / count, corner.y});
        }
        data->faces.push_back({{first, first + 1, first + 2},
                               {kNone, kNone, kNone},
                               {first, first + 1, first + 2},
                               {kNone, kNone, kNone}});
    }
    scene::Object object;
    object.shape = scene::Mesh{data};
    return {std::make_shared<const scene::Object>(object), "mesh"};
}

std::shared_ptr<const MeshCamera> camera_of(int rays, int method, std::vector<scene::MeshCamera::Member> meshes,
                                            double location_z = 0.0, double direction_z = 1.0,
                                            scene::PovRay povray = scene::PovRay::V37)
{
    auto written = std::make_shared<scene::MeshCamera>();
    written->rays_per_pixel = rays;
    written->distribution = static_cast<scene::MeshCamera::Distribution>(method);
    written->meshes = std::move(meshes);
    scene::Camera camera;
    camera.kind = scene::Camera::Kind::Mesh;
    camera.location = {0, 0, location_z};
    camera.direction = {0, 0, direction_z};
    camera.mesh = written;
    camera.povray = povray;
    return plan::compile_mesh_camera(camera);
}

/// The face that a pixel shows by its centroid, -1: none.
int face_at(const MeshCamera& camera, double px, double py, int width, int height)
{
    csg::Ray ray;
    return trace::mesh_camera_ray(camera, px, py, width, height, 0, ray)
               ? static_cast<int>(std::floor(ray.origin.x) + 100 * std::floor(ray.origin.y))
               : -1;
}

}  // namespace

TEST_CASE("a mesh camera's rays leave the faces along their normals", "[camera][mesh]")
{
    for (const double direction : {1.0, -1.0}) {
        const auto camera = camera_of(1, 0, {row_of(4, 0)}, -0.25, direction);
        csg::Ray ray;
        REQUIRE(trace::mesh_camera_ray(*camera, 2, 0, 4, 1, 0, ray));
        const glm::dvec3 normal = direction * ray.direction;
        CHECK(glm::length(normal) == Approx(1.0));
        CHECK(std::abs(normal.z) == Approx(1.0));
        CHECK(glm::length(ray.origin - (glm::dvec3(2 + 1.0 / 3, 1.0 / 3, 0) - 0.25 * normal)) < 1e-12);
    }
}

TEST_CASE("the first two rows show the same faces, the last row is never shown", "[camera][mesh]")
{
    const auto camera = camera_of(1, 0, {row_of(12, 0)});  // 4 x 3
    for (int x = 0; x < 4; ++x) {
        CHECK(face_at(*camera, x, 0, 4, 3) == x);
        CHECK(face_at(*camera, x, 1, 4, 3) == x);
        CHECK(face_at(*camera, x, 2, 4, 3) == 4 + x);
    }
    const auto few = camera_of(1, 1, {row_of(3, 0)});
    CHECK(face_at(*few, 2, 0, 4, 1) == 2);
    CHECK(face_at(*few, 3, 0, 4, 1) == -1);
}

TEST_CASE("meshes side by side are counted by the column of the whole picture", "[camera][mesh]")
{
    const auto camera =
        camera_of(1, 2, {row_of(4, 0), row_of(4, 1)});  // spec 2, 5: mesh 1 faces 0, 1, then mesh 2 faces 2, 3
    CHECK(face_at(*camera, 0, 0, 4, 1) == 0);
    CHECK(face_at(*camera, 1, 0, 4, 1) == 1);
    CHECK(face_at(*camera, 2, 0, 4, 1) == 102);
    CHECK(face_at(*camera, 3, 0, 4, 1) == 103);
}

TEST_CASE("a mesh camera by uv starts at the point of the surface", "[camera][mesh]")
{
    const auto camera = camera_of(1, 3, {row_of(2, 0)});
    csg::Ray ray;
    REQUIRE(trace::mesh_camera_ray(*camera, 1, 3, 8, 4, 0, ray));  // s = 1/8, t = 1/4
    CHECK(glm::length(ray.origin - glm::dvec3(0.25, 0.25, 0)) < 1e-12);
    CHECK_FALSE(trace::mesh_camera_ray(*camera, 3, 1, 8, 4, 0, ray));  // beyond the first triangle's slope
}

TEST_CASE("a mesh camera of POV-Ray 3.8 shows each row of faces once", "[camera][mesh]")
{
    constexpr auto kNew = scene::PovRay::V38;
    const auto camera = camera_of(1, 0, {row_of(12, 0)}, 0.0, 1.0, kNew);  // 4 x 3
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) {
            CHECK(face_at(*camera, x, y, 4, 3) == 4 * y + x);
            CHECK(face_at(*camera, x + 0.49, y - 0.49, 4, 3) == 4 * y + x);
        }
    CHECK(face_at(*camera, 3.5, 2.5, 4, 3) == 11);  // a corner of the picture
    // Three meshes across eight columns: whole columns are counted, so that column 5 belongs to the second.
    const auto beside = camera_of(1, 2, {row_of(12, 0), row_of(12, 1), row_of(12, 2)}, 0.0, 1.0, kNew);
    CHECK(face_at(*beside, 5, 0, 8, 6) == 105);
    CHECK(face_at(*beside, 5.4, 0, 8, 6) == 105);
    CHECK(face_at(*beside, 6, 0, 8, 6) == 206);
    const auto by_uv = camera_of(1, 3, {row_of(2, 0)}, 0.0, 1.0, kNew);
    csg::Ray ray;
    REQUIRE(trace::mesh_camera_ray(*by_uv, 0, 3, 8, 4, 0, ray));  // the middle of the pixel: s = t = 1/16, 1/8
    CHECK(glm::length(ray.origin - glm::dvec3(0.125, 0.125, 0)) < 1e-12);
}

TEST_CASE("places of one mesh have the rays of as many meshes", "[camera][mesh]")
{
    const auto placed = [](const scene::MeshCamera::Member& of, const csg::Transform& by) {
        scene::Object object = *of.object;
        object.transform.edit() = by;
        return scene::MeshCamera::Member{std::make_shared<const scene::Object>(object), of.keyword};
    };
    const csg::Transform here = csg::Transform::rotate_degrees({0, 20, 0}),
                         there = csg::Transform::translate({3, 10, -1});
    const scene::MeshCamera::Member row = row_of(6, 0.0);
    for (const int method : {0, 1, 2}) {
        INFO("method " << method);
        const auto shared = camera_of(2, method, {placed(row, here), placed(row, there)}, 0.5);
        const auto apart = camera_of(2, method, {placed(row, here), placed(row_of(6, 0.0), there)}, 0.5);
        CHECK(shared->faces.size() == 6);
        CHECK(apart->faces.size() == 12);
        int seen = 0;
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 6; ++x)
                for (int k = 0; k < 2; ++k) {
                    csg::Ray a{}, b{};
                    const bool found = trace::mesh_camera_ray(*shared, x, y, 6, 3, k, a);
                    REQUIRE(found == trace::mesh_camera_ray(*apart, x, y, 6, 3, k, b));
                    if (!found) continue;
                    ++seen;
                    CHECK(a.origin == b.origin);
                    CHECK(a.direction == b.direction);
                }
        CHECK(seen >= 12);
    }
}
