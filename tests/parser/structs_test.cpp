#include "render/scene/textures/image_map.h"
#include "render/scene/solids.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <limits>

// What the grammar writes into the structs of solids, pictures and effects: members, their units, and what is left out.
namespace {

const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 }\n";

scene::Description of(const std::string& text) { return grammar_test::parsed(kHead + text); }

template <class Solid>
Solid solid_of(const std::string& text)
{
    const scene::Description d = of(text);
    REQUIRE(d.objects.size() == 1);
    return std::get<Solid>(d.objects.front().details->written->parameters);
}

scene::Description settings(const std::string& block)
{
    return grammar_test::parsed("#version 3.7; global_settings { assumed_gamma 1 " + block + " } sphere { 0, 1 }");
}

}  // namespace

TEST_CASE("parameters of solids are members", "[parser][structs]")
{
    const auto lathe =
        solid_of<scene::Lathe>("lathe { linear_spline cubic_spline 4, <0, 0>, <1, 0>, <2, 1>, <0, 2> sturm }");
    CHECK(lathe.curve == scene::Curve::Cubic);
    CHECK(lathe.points == std::vector<glm::dvec2>{{0, 0}, {1, 0}, {2, 1}, {0, 2}});
    const auto prism = solid_of<scene::Prism>("prism { conic_sweep 2, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> open }");
    CHECK((prism.conic && prism.open && prism.low == 2 && prism.high == 1 && prism.curve == scene::Curve::Linear));
    const auto surface =
        solid_of<scene::Isosurface>("isosurface { function { x } accuracy 0.01 max_trace 3.9 evaluate 1, 2, 0.5 }");
    CHECK(
        (surface.accuracy == 0.01 && surface.max_trace == 3 && surface.max_gradient == 1.1 && surface.threshold == 0));
    CHECK(surface.container.kind == scene::Container::Kind::Unwritten);
    CHECK(*surface.evaluate == glm::dvec3(1, 2, 0.5));
    const auto julia = solid_of<scene::JuliaFractal>(
        "julia_fractal { <0.1, 0, 0, 0> hypercomplex pwr(2, 3) max_iteration -4 precision 0 }");
    CHECK((julia.hypercomplex && julia.function == scene::JuliaFractal::Function::Pwr &&
           julia.exponent == glm::dvec2(2, 3)));
    CHECK((julia.max_iteration == 1 && julia.precision == 1 && !julia.slice));
    const auto quartic = solid_of<scene::PolynomialSurface>("polynomial { 4, xyz(4, 0, 0): 1, xyz(0, 0, 0): -1 }");
    CHECK((quartic.order == 4 && quartic.coefficients.size() == 35 && quartic.coefficients.front() == 1 &&
           quartic.coefficients.back() == -1));
    const auto blob = solid_of<scene::Blob>("blob { sphere { x, 2, strength -1 translate y } component 3, 4, z "
                                            "cylinder { 0, y, 1, 2 pigment { rgb 1 } } }");
    REQUIRE(blob.components.size() == 3);
    CHECK((blob.threshold == 1 && blob.components[0].strength == -1 &&
           blob.components[0].transform->offset == glm::dvec3(0, 1, 0)));
    CHECK((blob.components[1].kind == scene::Blob::Component::Kind::Plain && blob.components[1].radius == 4 &&
           blob.components[2].texture));
    CHECK(solid_of<scene::SphereSweep>("sphere_sweep { linear_spline 2, 0, 1, x, 2 }").tolerance == 1e-6);
}

TEST_CASE("every keyword of the list of solids is read by its own grammar", "[parser][structs]")
{
    const std::pair<const char*, std::size_t> kRead[] = {{"ovus { 1, 0.5 }", 6},
                                                         {"superellipsoid { <0.5, 1> }", 13},
                                                         {"cubic { <0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> }", 9},
                                                         {"sor { 4, <0, 0> <1, 1> <2, 2> <1, 3> }", 11},
                                                         {"polygon { 4, 0, x, y, 0 }", 8}};
    for (const auto& [text, index] : kRead) {
        INFO(text);
        const scene::Description d = of(text);
        REQUIRE(d.objects.size() == 1);
        CHECK(d.objects.front().details->written->parameters.index() == index);
        CHECK(std::string(text).starts_with(d.objects.front().details->written->keyword));
        CHECK(d.line_of(d.objects.front().details->written->source).line == 2);
    }
    CHECK(of("julia_fractal { 0 inverse }").objects.front().inverse == false);
    CHECK(of("sor { 4, <0, 0> <1, 1> <2, 2> <1, 3> inverse }").objects.front().inverse == true);
    CHECK(grammar_test::error_of("superellipsoid { <1, 1> sturm }") ==
          "1:25: error: 'sturm' means nothing for this object");
    CHECK(grammar_test::error_of("lathe { 2, <0, 0> <1, 1> rotate x hierarchy }") ==
          "1:35: error: 'hierarchy' means nothing for this object");
}

TEST_CASE("settings of pictures are members", "[parser][structs]")
{
    const scene::Description d = of("plane { y, 0 pigment { image_map { function 3, 2 { x } map_type 5 interpolate 4 "
                                    "once filter all 0.5 gamma srgb repeat <2, 3> } } }");
    const auto& layers = std::get<std::vector<scene::Layer>>(d.objects.front().texture->kind);
    const auto& pattern = std::get<scene::Shared<scene::PatternedPigment>>(layers.front().pigment.kind)->pattern;
    const auto& image = *std::get<std::shared_ptr<const scene::ImageMap>>(pattern.data);
    CHECK((image.source.made() && image.source.picture->width == 3 && image.source.picture->height == 2 &&
           image.source.gamma->kind == scene::GammaCurve::Kind::Srgb));
    CHECK(image.projection == scene::ImageMap::Projection::Torus);
    CHECK(image.interpolation == scene::ImageMap::Interpolation::NormalizedDistance);
    CHECK((image.once && image.repeat == glm::dvec2(2, 3) && image.offset == glm::dvec2(0) && !image.premultiplied));
    REQUIRE(image.clarities.size() == 1);
    const scene::Description twice = of("plane { y, 0 pigment { image_map { function 3, 2 { x } map_type 1 map_type 0 "
                                        "} } }");  // the last counts, as in POV-Ray
    const auto& again = std::get<std::vector<scene::Layer>>(twice.objects.front().texture->kind).front().pigment;
    const auto& data = std::get<scene::Shared<scene::PatternedPigment>>(again.kind)->pattern.data;
    CHECK(std::get<std::shared_ptr<const scene::ImageMap>>(data)->projection == scene::ImageMap::Projection::Planar);
    CHECK((image.clarities[0].filter && !image.clarities[0].place && image.clarities[0].amount == 0.5f));
}

TEST_CASE("media have the defaults of their version, and what was declared keeps its own", "[parser][structs]")
{
    const scene::Media now = of("sphere { 0, 1 } media { emission 0.5 }").media.front();
    CHECK((now.method == scene::Media::Method::Adaptive && now.intervals == 1 && now.samples_least == 10 &&
           now.samples_most == 10));
    CHECK((now.aa_level == 3 && now.aa_threshold == 0.1 && now.ratio == 0.9 && now.confidence == 0.9 &&
           now.variance == 1.0 / 128.0));
    CHECK((now.emission == glm::vec3(0.5f) && now.absorption == glm::vec3(0) && now.collect && now.densities.empty()));
    const std::string old = "#version 3.1; #declare M = media { samples 3, 7 }\n";
    const scene::Description both =
        of(old + "#version 3.7; sphere { 0, 1 } media { M scattering { 5, rgb 1 eccentricity 0.5 } }");
    const scene::Media& then = both.media.front();
    CHECK((then.method == scene::Media::Method::Random && then.intervals == 10 && then.samples_least == 3 &&
           then.samples_most == 7));
    CHECK((then.scattering.phase == scene::Media::Phase::HenyeyGreenstein && then.scattering.eccentricity == 0.5 &&
           then.scattering.extinction == 1));
    CHECK(both.line_of(then.source).line == 3);
    CHECK(of("sphere { 0, 1 } media { samples 4 }").media.front().samples_most == 4);
}

TEST_CASE("a transformation moves the densities that stand before it", "[parser][structs]")
{
    const auto first_warp = [](const scene::Pigment& density) {
        const auto& warps = std::get<scene::Shared<scene::PatternedPigment>>(density.kind)->pattern.warps;
        return warps.empty() ? glm::dvec3(0) : std::get<csg::Transform>(warps.back()).offset;
    };
    const scene::Media media =
        of("sphere { 0, 1 } media { density { spherical } translate x density { spherical } translate y }")
            .media.front();
    REQUIRE(media.densities.size() == 2);
    CHECK(first_warp(media.densities[0]) == glm::dvec3(1, 1, 0));
    CHECK(first_warp(media.densities[1]) == glm::dvec3(0, 1, 0));
    const scene::Description d = of("#declare B = sphere { 0, 1 hollow interior { media { density { spherical } } "
                                    "translate z } }\nobject { B translate x } object { B }");
    CHECK(first_warp(d.objects[0].details->interior->media[0]->densities[0]) == glm::dvec3(1, 0, 1));
    CHECK(first_warp(d.objects[1].details->interior->media[0]->densities[0]) == glm::dvec3(0, 0, 1));
}

TEST_CASE("settings of light that is not direct", "[parser][structs]")
{
    const scene::RadiositySettings usual = *settings("radiosity { }").global.radiosity;
    CHECK((usual.count == 35 && usual.pool_size() == 1600 && usual.nearest_count == 5 && usual.recursion_limit == 2 &&
           usual.error_bound == 1.8));
    CHECK((usual.pretrace_start == 0.08 && usual.pretrace_end == 0.04 && usual.max_sample == -1 && !usual.normal &&
           !usual.media));
    const scene::RadiositySettings given =
        *settings("radiosity { count 2000 nearest_count 8, 3 normal on always_sample 1 }").global.radiosity;
    CHECK((given.count == 2000 && given.pool_size() == 2000 && given.nearest_count == 8 && given.adaptive_count == 3 &&
           given.normal && given.always_sample));
    const scene::PhotonSettings photons =
        *settings("photons { radius 0.1, 2, 0.3 gather 5, 6 } photons { count 10 }").global.photons;
    CHECK((photons.count == 10 && photons.gather_least == 20 && photons.gather_most == 100 && photons.radius == 0 &&
           photons.media_radius == 0.3));
    CHECK((photons.expand_increase == 0.2 && photons.expand_least == 35 && photons.jitter == 0.4 &&
           photons.spacing == 1 && !photons.max_trace_level));
    const scene::SubsurfaceSettings below = *settings("subsurface { radiosity on }").global.subsurface;
    CHECK((below.diffuse_samples == 50 && below.single_samples == 50 && below.radiosity));
    const scene::Description d = of("sphere { 0, 1 photons { target reflection off } radiosity { importance 0.5 } } "
                                    "light_source { y, 1 photons { area_light refraction on } }");
    const scene::PhotonFlags& object = *d.objects[0].details->photons;
    CHECK((object.target == 1.0 && object.reflection == false && !object.refraction && object.collect &&
           !object.pass_through));
    CHECK(d.objects[0].details->radiosity_importance == 0.5);
    CHECK((d.objects[1].details->photons->of_light && d.objects[1].details->photons->area_light &&
           d.objects[1].details->photons->refraction == true));
}

TEST_CASE("a limit of reuse that is left out follows the other", "[parser][structs]")
{
    const auto reuse = [](const std::string& items) {
        const auto s = *settings("radiosity { " + items + " }").global.radiosity;
        return glm::dvec2(s.minimum_reuse, s.maximum_reuse);
    };
    CHECK(reuse("") == glm::dvec2(0.015, 0.2));
    CHECK(reuse("maximum_reuse 0.01") == glm::dvec2(0.005, 0.01));  // POV-Ray warns and goes on
    CHECK(reuse("minimum_reuse 0.3") == glm::dvec2(0.3, 0.6));
    CHECK(reuse("minimum_reuse 0.15 maximum_reuse 0.2") == glm::dvec2(0.15, 0.2));
    CHECK(grammar_test::error_of("global_settings { radiosity { minimum_reuse 0.3 maximum_reuse 0.2 } }") ==
          "1:63: error: 'maximum_reuse' must be above 'minimum_reuse'");
}

TEST_CASE("rainbows", "[parser][structs]")
{
    const std::string head =
        "sphere { 0, 1 } rainbow { direction z angle 42 width 5 color_map { [0 rgb 0] [1 rgb 1] } ";
    const scene::Rainbow whole = of(head + "}").rainbows.front();
    CHECK((whole.distance == 1e7 && whole.jitter == 0 && whole.up == glm::dvec3(0, 1, 0) && whole.arc() == 180 &&
           whole.falloff() == 180));
    const scene::Rainbow arc = of(head + "arc_angle 90 }").rainbows.front();
    CHECK(arc.arc() == Approx(0.7853981633974483));
    CHECK(arc.falloff() == arc.arc());
    CHECK(of(head + "falloff_angle 90 }").rainbows.front().arc() == 180);
}

TEST_CASE("subsurface colours may be colours", "[parser][structs]")
{
    const scene::Description d =
        of("sphere { 0, 1 finish { subsurface { translucency <1, 2, 3> anisotropy rgb 0.5 } } }");
    const scene::Finish& finish = *std::get<std::vector<scene::Layer>>(d.objects[0].texture->kind).front().finish;
    CHECK(finish.subsurface->translucency == glm::vec3(1, 2, 3));
    CHECK(finish.subsurface->anisotropy == glm::vec3(0.5f));
}

TEST_CASE("the first transformation of an object is its product with none, to the last bit", "[parser][scene]")
{
    const double values[] = {0.0, -0.0, 1.0, -2.5, 1e-320, 1e300, std::numeric_limits<double>::infinity()};
    std::uint32_t state = 1;
    const auto next = [&] { return values[(state = state * 1664525u + 1013904223u) / 613566757u]; };
    for (int i = 0; i < 2000; ++i) {
        csg::Transform t;
        for (int k = 0; k < 3; ++k) {
            t.offset[k] = next();
            t.inverse_offset[k] = next();
            for (int j = 0; j < 3; ++j) {
                if (i % 2 != 0) t.linear[k][j] = next();
                if (i % 3 != 0) t.inverse_linear[k][j] = next();
            }
        }
        scene::Object object;
        object.transform_by(t);
        const csg::Transform product = t * csg::Transform{};
        const auto same = [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b); };
        for (int k = 0; k < 3; ++k) {
            REQUIRE(same(object.transform->offset[k], product.offset[k]));
            REQUIRE(same(object.transform->inverse_offset[k], product.inverse_offset[k]));
            for (int j = 0; j < 3; ++j) {
                REQUIRE(same(object.transform->linear[k][j], product.linear[k][j]));
                REQUIRE(same(object.transform->inverse_linear[k][j], product.inverse_linear[k][j]));
            }
        }
    }
}
