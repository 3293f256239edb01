#include "csg/items/last_bits.h"

#include <catch2/catch.hpp>

using namespace csg;

namespace {

struct LastBits {
    glm::dvec3 point, normal;
};

/// The nearest crossing of a ray, to the last bit by that program's numbers.
LastBits last_bits_of(const auto& solid, const glm::dvec3& from, const glm::dvec3& along, Roundings by)
{
    const Ray ray{from, unit(along, by)};
    Interval met;
    REQUIRE(solid.interval(ray, met));
    const glm::dvec3 point = ray.at(povray_depth(solid, ray, met.entry, met.entry_face, by));
    return {point, povray_normal(solid, point, met.entry_face, by)};
}

}  // namespace

// spec 7d, 9: the table.
TEST_CASE("points and normals of hits end in the bits that each POV-Ray gives them", "[csg][last_bits]")
{
    const Sphere ball{{0.1, 0.2, 0.05}, 0.9};
    const glm::dvec3 from{-2.0, 3.0, -3.0};
    const LastBits ball37 = last_bits_of(ball, from, {2.0, -2.75, 3.0}, Roundings::V37);
    CHECK(ball37.point == glm::dvec3(-0.34868808317255806, 0.72944611436226747, -0.5230321247588372));
    CHECK(ball37.normal == glm::dvec3(-0.4985423146361756, 0.58827346040251949, -0.63670236084315257));
    const LastBits ball38 = last_bits_of(ball, from, {2.0, -2.75, 3.0}, Roundings::V38);
    CHECK(ball38.point == glm::dvec3(-0.34868808317255806, 0.72944611436226747, -0.52303212475883676));
    CHECK(ball38.normal == glm::dvec3(-0.4985423146361756, 0.58827346040251949, -0.63670236084315202));

    const auto tube = [](Roundings by) {
        return Cylinder::make({0.25, 0.5, 1.0}, {1.0, 2.0, -1.0}, 0.5, false, {}, by);
    };
    const LastBits tube37 = last_bits_of(tube(Roundings::V37), from, {2.5, -1.75, 3.0}, Roundings::V37);
    CHECK(tube37.point == glm::dvec3(0.22070280076282378, 1.4455080394660234, -0.33515663908461146));
    CHECK(tube37.normal == glm::dvec3(-0.95399310040617691, 0.10021867506839488, -0.28258340635102014));
    const LastBits tube38 = last_bits_of(tube(Roundings::V38), from, {2.5, -1.75, 3.0}, Roundings::V38);
    CHECK(tube38.point == glm::dvec3(0.22070280076282245, 1.4455080394660245, -0.33515663908461324));
    CHECK(tube38.normal == glm::dvec3(-0.95399310040617669, 0.10021867506839467, -0.28258340635102031));

    // Along y: sine and cosine of a right angle are not quite 1 and 0.
    const Cylinder post = Cylinder::make(glm::dvec3(0.0), {0.0, 2.0, 0.0}, 0.2, false, {}, Roundings::V38);
    const LastBits post38 = last_bits_of(post, {-2.0, 1.5, -3.0}, {2.0625, -0.75, 3.0}, Roundings::V38);
    CHECK(post38.point == glm::dvec3(-0.067044187497204089, 0.79710697727171054, -0.18842790908684215));
    CHECK(post38.normal == glm::dvec3(-0.33522093748602239, -5.7689408933307796e-17, -0.94213954543421663));
}
