// Lamps and emitters that paths meet or aim at, against closed forms: docs/path_tracing.md.
#include "render/texture/fresnel.h"
#include "tests/render/trace/path_support.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>

using namespace path_tests;

namespace {

/// A white floor seen from above beside the middle, and what lights it.
std::string floor_lit_by(const std::string& text)
{
    return "camera { orthographic location 4*y right .2*x up .2*z direction -y sky z }\n"
           "#default { finish { ambient 0 diffuse 0 } }\n"
           "plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } }\n" +
           text;
}

/// An area light of 1 by 1.5 at x = `side`, turned so that its mirror picture at x = 0 is another place of it.
std::string lamp_at(const std::string& kind, double side)
{
    return "light_source { <" + std::to_string(side) + ",2,.5> rgb .8 area_light 1*y, <0,.3,1.5>, 5, 7 " + kind +
           " }\n";
}

}  // namespace

TEST_CASE("lamps that a mirror shows light a floor as the lamp behind the mirror would", "[path][caustics]")
{
    // The first is found by rays that meet the lamp's face by chance, the other by shadow rays.
    for (const std::string kind :
         {"", "fade_distance 1 fade_power 2", "fade_distance .5 fade_power 1", "circular",
          "area_illumination on fade_distance 1 fade_power 2", "spotlight point_at <1,0,0> radius 60 falloff 80"}) {
        INFO(kind);
        // A wall keeps the lamp's own light from the floor that is seen, and if it is high that of the mirror.
        const Paths closed =
            traced(floor_lit_by(lamp_at(kind, -1.5) + "plane { -x, -1 pigment { rgb 1 } finish { reflection 1 } }\n"
                                                      "box { <-.3,-1,-9>, <-.2,4.2,9> pigment { rgb 0 } }"),
                   4);
        CHECK(closed.mean() == 0.0);
        const Paths mirrored =
            traced(floor_lit_by(lamp_at(kind, -1.5) + "plane { -x, -1 pigment { rgb 1 } finish { reflection 1 } }\n"
                                                      "box { <-.3,-1,-9>, <-.2,.75,9> pigment { rgb 0 } }"),
                   1024);
        const Paths direct = traced(floor_lit_by("#declare Lamp = " + lamp_at(kind, -1.5) +
                                                 "light_source { Lamp scale <-1,1,1> translate 2*x }\n"),
                                    64);
        CHECK(direct.mean() > 0.01);
        CHECK(mirrored.mean() == Approx(direct.mean()).epsilon(0.02));
    }
}

namespace {

/// What a white floor at the origin gives off under <.5,3,.2>, 1 by 1, of colour .8, fading from 1 on, past a slab of
/// glass from y = 1 to 1.5: the sum over directions of what they bring (docs/path_tracing.md).
double through_slab(double ior)
{
    constexpr int kSteps = 1000;
    constexpr double kThick = 0.5;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            // Even in the tangents of a direction as it leaves the slab, over all that may meet the lamp.
            const double p = -0.2 + 0.8 * (i + 0.5) / kSteps, q = -0.3 + 0.8 * (j + 0.5) / kSteps;
            const double length2 = 1.0 + p * p + q * q, cosine = 1.0 / std::sqrt(length2),
                         sine2 = 1.0 - cosine * cosine, within = std::sqrt(1.0 - sine2 / (ior * ior));
            // Within, the way across is shorter by the ratio of the tangents.
            const double across = 3.0 - kThick + kThick * cosine / (ior * within);
            if (std::abs(p * across - 0.5) > 0.5 || std::abs(q * across - 0.2) > 0.5) continue;
            const double way = (3.0 - kThick) / cosine + kThick / within, once = texture::fresnel_share(ior, cosine);
            const double radiance = M_PI * 0.8 * 2.0 / (1.0 + way * way) * way * way / cosine;
            const double passed = (1.0 - once) / (1.0 + once);  // with what goes to and fro within
            sum += passed * radiance * cosine * std::pow(cosine, 3) * 0.8 * 0.8 / (kSteps * kSteps);
        }
    return sum / M_PI;
}

}  // namespace

TEST_CASE("light of a lamp through a body that bends it comes along the bent way and no other", "[path][caustics]")
{
    const std::string lamp = "light_source { <.5,3,.2> rgb .8 area_light x, z, 5, 5 fade_distance 1 fade_power 2 }\n";
    const auto slab = [&](const std::string& ior) {
        return traced(
            floor_lit_by(lamp + "box { <-9,1,-9>, <9,1.5,9> pigment { rgbt 1 } interior { ior " + ior + " } }"), 512);
    };
    const Paths clear = traced(floor_lit_by(lamp), 64), straight = slab("1"), thin = slab("1.0001");
    CHECK(straight.mean() == Approx(clear.mean()).epsilon(0.01));
    CHECK(thin.mean() == Approx(clear.mean()).epsilon(0.03));
    // A floor so dark that nothing does, seen from below the glass.
    const Paths dark = traced("camera { orthographic location .5*y right .2*x up .2*z direction -y sky z }\n" + lamp +
                                  "plane { y, 0 pigment { rgb .01 } finish { ambient 0 diffuse 1 } }\n"
                                  "box { <-9,1,-9>, <9,1.5,9> pigment { rgbt 1 } finish { diffuse 0 } interior { ior "
                                  "1.5 } }",
                              1024);
    CHECK(100.0 * dark.mean() == Approx(through_slab(1.5)).epsilon(0.01));
}

TEST_CASE("flat and round lamps light a wall as their form factors say", "[path]")
{
    const auto lit = [](const std::string& body) {
        return traced("camera { orthographic location 4*z right .02*x up .02*y direction -z sky y }\n"
                      "plane { z, 0 pigment { rgb 1 } finish { diffuse 1 } }\n" +
                          body + " no_image pigment { rgb 1 } finish { diffuse 0 emission 1 } }",
                      64);
    };
    // A disc of radius r at the height h seen from below its middle (Howell, B-11): r^2 / (r^2 + h^2).
    const Paths disc = lit("disc { 2*z, z, 1"), ring = lit("disc { 2*z, z, 1, .5"),
                tube = lit("cylinder { 2*z, 3*z, 1"), face = lit("triangle { <0,0,1>, <1,0,1>, <1,1,1>"),
                mesh = lit("mesh { triangle { <0,0,1>, <1,0,1>, <1,1,1> } triangle { <0,0,1>, <1,1,1>, <0,1,1> }");
    CHECK(disc.mean() == Approx(0.2).epsilon(0.005));
    CHECK(ring.mean() == Approx(0.2 - 0.25 / 4.25).epsilon(0.005));
    CHECK(tube.mean() == Approx(0.2).epsilon(0.005));
    // A square of side 1 above its corner at distance 1, and half of it (Howell, B-4).
    const double a = 1.0 / std::sqrt(2.0), square = a * std::atan(a) / M_PI;
    CHECK(mesh.mean() == Approx(square).epsilon(0.01));
    CHECK(face.mean() == Approx(square / 2.0).epsilon(0.01));
    for (const Paths* found : {&disc, &ring, &tube, &face, &mesh}) CHECK(found->statistics.error < 4.0);
}

TEST_CASE("the bright texel of an HDR sky lights a floor as its solid angle says", "[path]")
{
    // 64 x 32 texels, all black but one, of radiance L = 200 * 2^(135 - 136): from 61.875 to 67.5 degrees above the
    // horizon, a 64th of the circle wide. The floor, white, shows 1/pi times the integral of L sin h cos h
    // over 2 pi / 64 and the heights: L (sin^2 b - sin^2 a) / 64.
    const support::TemporaryFolder folder;
    constexpr int kColumns = 64, kRows = 32, kRow = 4;
    const auto lit = [&](int column) {
        std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
        for (int i = 0; i < kColumns * kRows; ++i)
            file += i == kRow * kColumns + column ? std::string("\xc8\xc8\xc8\x87") : std::string(4, '\0');
        std::ofstream(folder / "sky.hdr", std::ios::binary) << file;
        return traced("camera { orthographic location 4*y right x up z direction -y sky z }\n"
                      "sky_sphere { pigment { image_map { hdr \"" +
                          (folder / "sky.hdr") +
                          "\" map_type 1 } } }\nplane { y, 0 pigment { rgb 1 } finish { diffuse 1 } }",
                      256);
    };
    const auto height = [](double row) { return std::pow(std::sin(M_PI * (0.5 - row / kRows)), 2); };
    const double expected = 100.0 * (height(kRow) - height(kRow + 1)) / kColumns;
    for (const int column : {5, 40}) {
        const Paths found = lit(column);
        CHECK(found.mean() == Approx(expected).epsilon(0.01));
        CHECK(found.statistics.error < 3.0);  // one direction in two thousand: by chance nearly all would be black
    }
}
