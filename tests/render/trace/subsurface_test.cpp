// Light below surfaces: the dipole against its own sum over a plane, and a half-space against known numbers.
#include "render/kernel/subsurface/scattering.h"
#include "tests/render/trace/indirect_support.h"

#include <catch2/catch.hpp>

#include <cstring>

namespace {

/// All light that a half-space sends back of what goes in at one point.
double summed(const trace::Scattering& matter, int c)
{
    // Rings whose widths grow with their distance.
    double sum = 0.0, from = 0.0;
    const double scale = matter.depth[c];
    for (int i = 0; i < 200000; ++i) {
        const double to = scale * 1e-4 * (std::exp(i * 1e-4) - 1.0 + i * 1e-2);
        const double middle = 0.5 * (from + to);
        sum += matter.dipole(c, middle * middle) * 2.0 * std::numbers::pi * middle * (to - from);
        from = to;
        if (matter.effective[c] * from > 40.0) break;
    }
    return sum;
}

}  // namespace

TEST_CASE("the dipole sends back over a plane what its albedo was chosen for", "[subsurface]")
{
    for (const double eta : {1.0, 1.3, 1.5})
        for (const float reflectance : {0.2f, 0.5f, 0.8f}) {
            const plan::AlbedoTable table(plan::internal_reflection(eta));
            const trace::Scattering matter(glm::vec3(reflectance), glm::vec3(1.0f, 0.5f, 3.0f), eta, table);
            INFO("eta " << eta << " reflectance " << reflectance);
            for (int c = 0; c < 3; ++c)
                CHECK(summed(matter, c) == Approx(static_cast<double>(reflectance)).epsilon(2e-3));
        }
}

TEST_CASE("the table of albedos is the inverse of what they send back", "[subsurface]")
{
    for (const double eta : {0.8, 1.0, 1.33, 2.0}) {
        const double a = plan::internal_reflection(eta);
        const plan::AlbedoTable table(a);
        for (int i = 1; i < 100; ++i)
            CHECK(plan::diffuse_reflectance(table(i / 100.0), a) == Approx(i / 100.0).epsilon(1e-5));
        CHECK(table(0.0) == 0.0);
        CHECK(table(1.0) == 1.0);
        CHECK(table(7.0) == 1.0);
    }
}

TEST_CASE("an interface bends light by Snell's law", "[subsurface]")
{
    CHECK(trace::bent_cosine(1.0, 1.5) == Approx(1.0));
    CHECK(trace::bent_cosine(0.0, 1.5) == Approx(std::sqrt(1.0 - 1.0 / 2.25)));
}

TEST_CASE("what comes out of a material has the same bits in lanes", "[subsurface]")
{
    using numbers::lanes::Double;
    constexpr std::size_t kLanes = numbers::lanes::kDoubles;
    alignas(64) std::array<double, kLanes> cosines, ways, dipole, once;
    for (const double eta : {0.7, 1.0, 1.5}) {
        const plan::AlbedoTable table(plan::internal_reflection(eta));
        const trace::Scattering matter(glm::vec3(0.9f, 0.5f, 0.01f), glm::vec3(5.0f, 1.0f, 0.01f), eta, table);
        for (std::size_t i = 0; i < 300; ++i) {
            for (std::size_t k = 0; k < kLanes; ++k) {
                cosines[k] = static_cast<double>((7 * i + 11 * k) % 101) / 100.0;
                ways[k] = std::pow(1.1, static_cast<double>(i) - 150.0) * static_cast<double>(k + 1);
            }
            const Double cosine = Double::load_aligned(cosines.data()), way = Double::load_aligned(ways.data());
            for (int c = 0; c < 3; ++c) {
                matter.dipole(c, way).store_aligned(dipole.data());
                const auto one = trace::ScatteredOnce<double>::of(matter, c, 0.6, 0.9, 0.5);
                const trace::ScatteredOnce<Double> many{Double(one.eta), Double(one.extinction), Double(one.outer),
                                                        Double(one.scale)};
                many.share(cosine, way).store_aligned(once.data());
                for (std::size_t k = 0; k < kLanes; ++k) {
                    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
                    CHECK(same(dipole[k], matter.dipole(c, ways[k])));
                    CHECK(same(once[k], one.share(cosines[k], ways[k])));
                }
            }
        }
    }
}

TEST_CASE("what is left of light is its exponential", "[subsurface]")
{
    for (const double depth : {0.0, 1e-9, 0.3, 1.0, 20.0, 650.0})
        CHECK(trace::left_at(depth) == Approx(std::exp(-depth)).epsilon(1e-14));
    CHECK(trace::left_at(1e9) < 1e-300);
    CHECK(trace::left_at(numbers::kInfinity) < 1e-300);
}

namespace {

struct Probe {
    const char* settings;
    const char* light;  ///< place of a parallel light
    const char* pigment;
    double diffuse;
    const char* translucency;
    double ior;
    glm::vec3 known;  ///< what POV-Ray shows with 4000 samples of each kind
};

glm::vec3 half_space(const Probe& probe)
{
    const std::string text =
        std::string("global_settings { assumed_gamma 1 ") + probe.settings + " }\n" + "light_source { " + probe.light +
        " rgb 1 parallel point_at 0 }\n" + "box { <-100,-100,0>, <100,100,10> pigment { rgb " + probe.pigment +
        " } interior { ior " + std::to_string(probe.ior) + " } finish { ambient 0 diffuse " +
        std::to_string(probe.diffuse) + " subsurface { translucency " + probe.translucency + " } } }\n";
    const indirect_test::Made made = indirect_test::made(
        "camera { orthographic location <0,0,-5> direction z right x*0.4 up y*0.4 }\n" + text, 8, 8);
    glm::vec3 sum(0);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (int c = 0; c < 3; ++c) sum[c] += made.picture.at(x, y)[c] / 64.0f;
    return sum;
}

}  // namespace

TEST_CASE("a half-space is as bright as POV-Ray's", "[subsurface]")
{
    const Probe probes[] = {
        {"mm_per_unit 10 subsurface { samples 20, 20 }",
         "<0,0,-1000>",
         "0.5",
         1.0,
         "1",
         1.3,
         {0.5208f, 0.5213f, 0.5221f}},
        {"mm_per_unit 10 subsurface { samples 20, 20 }",
         "<642.79,0,-766.04>",
         "<.5,.8,.2>",
         0.7,
         "<1,.5,2>",
         1.3,
         {0.2820f, 0.4391f, 0.1213f}},
        {"mm_per_unit 1 subsurface { samples 50, 50 }",
         "<642.79,0,-766.04>",
         "<.5,.8,.2>",
         0.7,
         "<1,.5,2>",
         1.5,
         {0.2692f, 0.4188f, 0.1161f}},
    };
    for (const Probe& probe : probes) {
        const glm::vec3 seen = half_space(probe);
        INFO(probe.settings << ": " << seen.x << ' ' << seen.y << ' ' << seen.z);
        for (int c = 0; c < 3; ++c) CHECK(seen[c] == Approx(probe.known[c]).margin(0.006));
    }
}

TEST_CASE("without translucency or with a channel of 0 no diffuse light comes from below", "[subsurface]")
{
    const char* settings = "subsurface { samples 10, 10 }";
    CHECK(half_space({settings, "<0,0,-1000>", "0.5", 1.0, "0", 1.3, {}}) == glm::vec3(0));
    const glm::vec3 red = half_space({settings, "<0,0,-1000>", "<.5,0,0>", 1.0, "1", 1.3, {}});
    CHECK((red.x > 0.02f && red.x < 0.07f));  // POV-Ray: 0.0432
    CHECK((red.y == 0.0f && red.z == 0.0f));
    // Without the block in global_settings it is an ordinary finish.
    CHECK(half_space({"", "<0,0,-1000>", "0.5", 1.0, "1", 1.3, {}}).x == Approx(0.5));
}

TEST_CASE("light from below has the same bytes for any number of threads", "[subsurface]")
{
    const std::string text = R"(
global_settings { assumed_gamma 1 mm_per_unit 10 subsurface { samples 8, 6 } }
camera { location <0,2,-4> look_at 0 }
light_source { <3,5,-4> rgb 1 }
light_source { <-3,5,0> rgb .5 area_light x, z, 3, 3 }
plane { y, -1 pigment { rgb .5 } finish { reflection .3 } }
sphere { 0, 1 pigment { rgb <.9,.7,.6> } interior { ior 1.4 } finish { specular .3 subsurface { translucency <2,1,1> } } }
box { <1,-1,-.1>, <1.6,1,.1> pigment { rgb .9 } interior { ior 1.3 } finish { subsurface { translucency 4 } } }
)";
    const indirect_test::Made one = indirect_test::made(text, 40, 30, 1, trace::kernels_there().front());
    for (const int threads : {1, 2, 3}) {
        const indirect_test::Made other = indirect_test::made(text, 40, 30, threads);
        CHECK(std::memcmp(one.picture.pixels.data(), other.picture.pixels.data(),
                          one.picture.pixels.size() * sizeof(float)) == 0);
    }
}
