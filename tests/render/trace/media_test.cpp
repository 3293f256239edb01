// Media against their integrals, and against what POV-Ray was seen to make of small scenes (spec 6, 1.2 and 2).
#include "render/kernel/extinction/media_exp.h"
#include "render/picture/render.h"
#include "tests/parser/grammar_support.h"
#include "tests/support/csv_table.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <string>

namespace {

image::Image picture_of(const scene::Description& description, int width, int height, int threads = 0, int block = 32)
{
    plan::Options options;
    options.width = width;
    options.height = height;
    options.block_size = block;
    image::Image out;
    trace::RenderOptions how;
    how.threads = threads;
    trace::render(plan::compile(description, options), how, out);
    return out;
}

const std::string kStage =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { orthographic location <0, 0, -5> look_at 0 right x*.1 up y*.1 }\n"
    "#default { finish { ambient 0 diffuse 0 } }\n#declare Clear = texture { pigment { rgbt 1 } }\n";

/// The only pixel of a scene on kStage: it looks along z at the origin.
glm::vec3 seen(const std::string& text)
{
    const image::Image picture = picture_of(grammar_test::parsed(kStage + text), 1, 1);
    return {picture.pixels[0], picture.pixels[1], picture.pixels[2]};
}

/// A clear box from z = 0 to 1 that holds this.
std::string filled(const std::string& media, const std::string& more = "hollow")
{
    return "box { <-3, -3, 0>, <3, 3, 1> texture { Clear } interior { " + media + " } " + more + " }\n";
}

Approx near(double value, double margin = 2e-5) { return Approx(value).margin(margin).epsilon(0); }

}  // namespace

TEST_CASE("powers of e for media are the library's within 4e-13", "[media]")
{
    double worst = 0.0;
    for (double v = -700.0; v <= 700.0; v += 0.000731)
        worst = std::max(worst, std::abs(trace::media_exp(v) / std::exp(v) - 1.0));
    CHECK(worst < 4e-13);
    CHECK(trace::media_exp(0.0) == 1.0);
    CHECK(trace::media_exp(-1e9) == trace::media_exp(-700.0));
    CHECK(std::isnan(trace::media_exp(std::numeric_limits<double>::quiet_NaN())));
    const glm::vec3 v(-0.25f, -3.5f, 1.75f), e = trace::media_exp(v);
    for (int c = 0; c < 3; ++c)
        CHECK(e[c] == static_cast<float>(trace::media_exp(static_cast<double>(v[c]))));  // side by side or alone
}

TEST_CASE("absorbing media dim by Beer's law", "[trace][media]")
{
    for (const double length : {0.25, 1.0, 3.0})
        for (const std::string way : {"method 3", "method 3 intervals 7 samples 3", "method 2 samples 5 intervals 3",
                                      "method 1 samples 4 intervals 2", "method 3 density { rgb 1 } intervals 4"}) {
            INFO(length << ' ' << way);
            const glm::vec3 c =
                seen("background { rgb <1, .5, .25> }\nbox { <-3, -3, 0>, <3, 3, " + std::to_string(length) +
                     "> texture { Clear } hollow interior { media { absorption <.4, .9, 1.7> " + way + " } } }");
            CHECK(c.x == near(std::exp(-0.4 * length), 1e-6));
            CHECK(c.y == near(0.5 * std::exp(-0.9 * length), 1e-6));
            CHECK(c.z == near(0.25 * std::exp(-1.7 * length), 1e-6));
        }
    CHECK(seen("background { rgb .25 }" + filled("media { absorption -1 }")).x == near(0.25 * std::exp(1.0), 1e-6));
}

TEST_CASE("a column that scatters light once has its integral", "[trace][media]")
{
    // Light comes from above, a way of 0.5 through the box, which dims it as the column dims what it sends.
    const double s = 0.8, x = 1.2;
    const glm::vec3 c =
        seen("light_source { y*100, rgb 1 parallel point_at 0 }\n"
             "box { <-3, -3, 0>, <3, .5, 1> texture { Clear } hollow interior { media { scattering { 1, .8 "
             "extinction 1.5 } method 2 samples 400 } } }");
    CHECK(c.x == near(s * std::exp(-x * 0.5) * (1.0 - std::exp(-x)) / x, 2e-6));
    // Samples of the adaptive method reach it as they become more; the last of its gaps is never looked at.
    const double bias = 201.0;  // gaps of 400 samples
    const glm::vec3 adaptive =
        seen("light_source { y*100, rgb 1 parallel point_at 0 }\n"
             "box { <-3, -3, 0>, <3, .5, 1> texture { Clear } hollow interior { media { scattering { 1, "
             ".8 extinction 1.5 } samples 400 } } }");
    CHECK(adaptive.x == near(static_cast<double>(c.x), 1.0 / bias));
}

TEST_CASE("emission of densities that rise evenly, by samples and intervals", "[trace][media]")
{
    const auto graded = [](const std::string& how) {
        return static_cast<double>(seen(filled("media { emission .5 density { gradient z } " + how + " }")).x);
    };
    CHECK(graded("samples 1") == near(0.16667));
    CHECK(graded("samples 4") == near(0.18750));
    CHECK(graded("samples 10") == near(0.21428));
    CHECK(graded("samples 100") == near(0.24520));
    CHECK(graded("intervals 4 samples 10") == near(0.24108));
    const auto even = [](const std::string& how) {
        return static_cast<double>(seen(filled("media { emission .5 absorption 2 " + how + " }")).x);
    };
    CHECK(even("samples 1") == near(0.34197));
    CHECK(even("samples 10") == near(0.25418));
    CHECK(even("samples 100") == near(0.22043));
    CHECK(even("method 2 samples 1") == near(0.18393));
    CHECK(even("method 2 samples 4") == near(0.21393));
}

TEST_CASE("method 3 halves gaps by threshold and level", "[trace][media]")
{
    const auto stepped = [](const std::string& how) {
        return static_cast<double>(
            seen("background { rgb .3 }" + filled("media { emission .7 absorption 1.3 density { gradient z color_map { "
                                                  "[0 rgb 0] [.37 rgb 0] [.37 rgb "
                                                  ".37] [1 rgb 1] } } " +
                                                  how + " }"))
                .x);
    };
    CHECK(stepped("") == near(0.40023));
    CHECK(stepped("samples 20") == near(0.40208));
    CHECK(stepped("samples 4 aa_level 5") == near(0.39249));
    CHECK(stepped("samples 5 aa_level 1") == near(0.39823));
    CHECK(stepped("samples 8 aa_threshold 0.001 aa_level 6") == near(0.39892));
}

TEST_CASE("ways that only some media take lead where the others do", "[trace][media]")
{
    const std::string grain =
        "density { wrinkles scale .3 color_map { [0 rgb <1, .5, 0>] [.45 rgb <.1, .8, 1>] [.6 rgb "
        "0] } } density { spherical scale 3 } ";
    const auto lit = [&](const std::string& how) {
        return seen("light_source { <3, 20, -4>, rgb 1 }\n" +
                    filled("media { scattering { 1, <.8, .5, .3> extinction 1.5 } " + grain + how + " }"));
    };
    const auto glowing = [&](const std::string& how) {
        return seen(filled("media { emission <1, .9, .8> " + grain + how + " }"));
    };
    const auto same = [](const glm::vec3& a, const glm::vec3& b) {
        for (int c = 0; c < 3; ++c) CHECK(a[c] == near(static_cast<double>(b[c])));
        CHECK(a.x + a.y + a.z > 0.05f);
    };
    for (const std::string how :
         {"", "samples 3", "samples 9 aa_level 5 aa_threshold 0.01", "intervals 3 aa_level 1"}) {
        INFO(how);
        same(lit(how), lit(how + " jitter 1e-9"));  // shadow rays look again at the density where they start
        same(glowing(how), glowing(how + " absorption 1e-9"));  // depths are summed up
    }
}

TEST_CASE("what is inside of what", "[trace][media]")
{
    const auto box = [](double from, double to, const std::string& more) {
        return "box { <-3, -3, " + std::to_string(from) + ">, <3, 3, " + std::to_string(to) + "> texture { Clear } " +
               more + " }";
    };
    const std::string tenth = "interior { media { emission .1 } }";
    CHECK(seen(filled("media { emission .5 }")).x == near(0.5));
    CHECK(seen(filled("media { emission .5 }", "")).x == 0.0f);
    CHECK(seen("union { " + box(0, 2, "") + box(1, 3, "") + tenth + " hollow }").x == near(0.2));
    CHECK(seen("merge { " + box(0, 2, "") + box(1, 3, "") + tenth + " hollow }").x == near(0.3));
    CHECK(seen("union { " + box(0, 2, tenth) + box(1, 3, tenth) + " hollow }").x == near(0.4));
    const std::string air = "media { emission .02 } plane { -z, -5 pigment { rgb 0 } }";
    CHECK(seen(air + box(0, 3, "hollow")).x == near(0.2));
    CHECK(seen(air + box(0, 3, "")).x == near(0.14));
    CHECK(seen("plane { y, 2 texture { Clear } hollow interior { media { emission .5 } } }").x == 0.0f);
    CHECK(seen("media { emission 1e-11 }").x == near(0.2));
    CHECK(seen("media { emission .02 } fog { distance 10 rgb 1 } plane { -z, -5 pigment { rgb 0 } }").x ==
          near(0.70570));
}

TEST_CASE("densities stand in the space of what holds them", "[trace][media]")
{
    const std::string ramp = "interior { media { emission 1 method 2 samples 200 density { gradient z } } }";
    const auto cube = [&](const std::string& more) {
        return "box { <-3, -3, 0>, <3, 3, 1> texture { Clear } " + more + " }";
    };
    CHECK(seen(cube(ramp + " hollow")).x == near(0.5));
    CHECK(seen(cube(ramp + " hollow scale <1, 1, 2>")).x == near(1.0));
    CHECK(seen(cube("scale <1, 1, .5> hollow " + ramp)).x == near(0.125));
    CHECK(seen("union { " + cube(ramp) + " hollow scale <1, 1, 2> }").x == near(1.0));
    CHECK(seen("intersection { " + cube(ramp) + "box { -4, 4 texture { Clear } } hollow scale <1, 1, 2> }").x ==
          near(1.0));
}

TEST_CASE("one medium says how all are sampled", "[trace][media]")
{
    const std::string rising = "media { emission 1 density { function { pow(z, 4) } } ",
                      constant = "media { emission 0 absorption 0 ";
    // The constant one has the most intervals and no density: one interval; else four.
    CHECK(seen(filled(rising + "} " + constant + "intervals 4 method 2 samples 1 }")).x == near(0.0625));
    CHECK(seen(filled(rising + "intervals 4 method 2 samples 1 } " + constant + "}")).x == near(0.18970, 1e-4));
}

TEST_CASE("lit stretches get their share of the intervals", "[trace][media]")
{
    // Midpoint sums over three pieces, of which a cylinder of light makes the middle one: so many parts each.
    const auto sum = [](int before, int lit, int after) {
        double total = 0, from = 0;
        for (const auto& [length, parts] : {std::pair(0.25, before), std::pair(0.5, lit), std::pair(0.25, after)}) {
            for (int i = 0; i < parts; ++i) total += std::pow(from + length * (i + 0.5) / parts, 4) * length / parts;
            from += length;
        }
        return total;
    };
    const auto by = [](const std::string& how) {
        return static_cast<double>(
            seen("light_source { <0, 4, .5>, rgb 1 cylinder radius .25 falloff .25 point_at <0, 0, .5> }" +
                 filled("media { emission 1 density { function { pow(z, 4) } } method 2 samples 1 " + how + " }"))
                .x);
    };
    CHECK(by("intervals 10 ratio .9") == near(sum(1, 8, 1)));
    CHECK(by("intervals 10 ratio .5") == near(sum(4, 4, 2)));
    CHECK(by("intervals 10 ratio .1") == near(sum(5, 1, 4)));
    CHECK(by("intervals 20 ratio .9") == near(sum(2, 17, 1)));
}

TEST_CASE("kinds of scattering", "[trace][media]")
{
    // Light from straight ahead, from the side, from behind the eye; nothing is lost.
    const auto turned = [](const std::string& kind, const std::string& from) {
        return static_cast<double>(seen("light_source { " + from + "*100, rgb 1 parallel point_at 0 }" +
                                        filled("media { scattering { " + kind + ", .1 extinction 0 } }"))
                                       .x) /
               0.1;
    };
    const auto kind = [&](const std::string& name, const std::array<double, 3>& expected) {
        INFO(name);
        CHECK(turned(name, "z") == near(expected[0], 1e-4 * expected[0]));
        CHECK(turned(name, "y") == near(expected[1], 1e-4));
        CHECK(turned(name, "-z") == near(expected[2], 1e-4));
    };
    kind("1", {1, 1, 1});
    kind("2", {5.7666, 0.59693, 0.57666});
    kind("3", {25.281, 0.49571, 0.49571});
    kind("4", {1.59874, 0.79937, 1.59874});
    const auto spread = [](const std::string& from) {
        return static_cast<double>(seen("light_source { " + from + "*100, rgb 1 parallel point_at 0 }" +
                                        filled("media { scattering { 5, .1 eccentricity .5 extinction 0 } }"))
                                       .x) /
               0.1;
    };
    CHECK(spread("z") == near(6, 1e-3));
    CHECK(spread("y") == near(0.53666, 1e-4));
    CHECK(spread("-z") == near(0.22222, 1e-4));
    CHECK(seen("light_source { y*100, rgb 1 parallel point_at 0 }" +
               filled("media { scattering { 2, .3 extinction 0 } } media { emission 1e-9 }"))
              .x == near(0.3 * (0.59693 + 1) / 2, 1e-5));
    CHECK(seen("light_source { y*100, rgb 1 shadowless }" + filled("media { scattering { 1, .3 } }")).x == 0.0f);
    CHECK(seen("light_source { y*100, rgb 1 media_interaction off }" + filled("media { scattering { 1, .3 } }")).x ==
          0.0f);
}

TEST_CASE("what fills the scene dims area lights", "[trace][media]")
{
    const auto floor = [](const std::string& samples, const std::string& more) {
        return static_cast<double>(
                   seen("media { absorption .1 }\nlight_source { <0, 0, -8>, rgb .5 area_light x*2, y*.01, " + samples +
                        " media_attenuation on }\nplane { -z, 0 pigment { rgb 1 } finish { diffuse 1 } }\n" + more)
                       .x) *
               std::exp(0.5);
    };
    const auto holder = [](double left, double right) {
        return "box { <" + std::to_string(left) + ", -1, -3>, <" + std::to_string(right) +
               ", 1, -1> texture { Clear } hollow no_image }";
    };
    const double open = std::exp(0.001);  // POV-Ray was seen from 0.01 away
    CHECK(floor("2, 1", holder(-3, -0.001)) == near(0.19395 * open, 1e-4));
    CHECK(floor("2, 1", holder(0.001, 3)) == near(0.26241 * open, 1e-4));
    CHECK(floor("2, 1", holder(-3, 3)) == near(0.22305 * open, 1e-4));
    CHECK(floor("2, 1", "plane { -z, 20 texture { Clear } }") == near(0.5 * std::exp(0.5), 1e-4));
    CHECK(floor("3, 3", "") == near(0.10084 * open, 1e-4));
    CHECK(floor("3, 4", "") == near(0.22281, 5e-3));
}

TEST_CASE("light that comes through media", "[trace][media]")
{
    // A wall lit from beside the eye, through a holder between lamp and wall that is not looked through.
    const auto wall = [](const std::string& light, const std::string& holder) {
        return static_cast<double>(seen("light_source { <-10, 0, -10>, rgb .5 parallel point_at 0 " + light +
                                        " }\nplane { -z, 0 pigment { rgb 1 } finish { diffuse 1 } }\n" + holder)
                                       .x) /
               (0.5 * std::sqrt(0.5));
    };
    const auto slab = [](const std::string& more) {
        return "box { <-1, -1, 2>, <1, 1, 4> texture { Clear } interior { media { absorption 1 } } " + more +
               " rotate y*-135 }";
    };
    for (const std::string flags :
         {"", "media_attenuation on", "media_interaction off", "media_attenuation on media_interaction off"})
        CHECK(wall(flags, slab("hollow")) == near(std::exp(-2.0), 1e-5));
    CHECK(wall("", slab("")) == near(1.0, 1e-5));
    CHECK(wall("", "") == near(1.0, 1e-5));
}

TEST_CASE("pictures of sampled media match POV-Ray's tile by tile", "[trace][media]")
{
    struct Tile {
        int x, y;
        std::array<double, 3> mean;
        double spread;
    };
    std::map<std::string, std::vector<Tile>> scenes;
    for (const auto& row : test_support::csv_table(WHITTLE_SPEC_DATA "/06-global-scenes-tiles.csv")) {
        const std::string& name = row.at(0);
        if (!name.starts_with("media_")) continue;
        scenes[name].push_back({std::stoi(row.at(1)),
                                std::stoi(row.at(2)),
                                {std::stod(row.at(6)), std::stod(row.at(7)), std::stod(row.at(8))},
                                std::stod(row.at(9))});
    }
    CHECK(scenes.size() == 5);
    for (const auto& [name, tiles] : scenes) {
        const scene::Description d =
            parser::parse_file(std::string(WHITTLE_SPEC_DATA "/global-scenes/") + name + ".pov", {}).scene;
        const image::Image picture = picture_of(d, 160, 120);
        CHECK(tiles.size() == 48);
        for (const Tile& tile : tiles) {
            std::array<double, 3> sum{};
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 20; ++x)
                    for (std::size_t c = 0; c < 3; ++c) {
                        const float* p =
                            &picture.pixels[4 * static_cast<std::size_t>((20 * tile.y + y) * 160 + 20 * tile.x + x)];
                        const double v = std::clamp(static_cast<double>(p[c]), 0.0, 1.0);
                        sum[c] +=
                            std::round(255.0 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055));
                    }
            for (std::size_t c = 0; c < 3; ++c) {
                INFO(name << ' ' << tile.x << ' ' << tile.y << ' ' << c);
                CHECK(sum[c] / 400.0 == near(tile.mean[c], std::max(1.0, 1.5 * tile.spread)));
            }
        }
    }
}

TEST_CASE("random media are the same for any threads and blocks", "[trace][media]")
{
    const scene::Description d = grammar_test::parsed(
        "#version 3.7; global_settings { assumed_gamma 1 }\ncamera { location <0, .5, -5> look_at 0 }\n"
        "light_source { <4, 5, -3>, 1 }\nmedia { scattering { 2, .03 } method 2 samples 2, 9 jitter .8 intervals 3 "
        "variance 1e-5 }\n"
        "plane { y, -1 pigment { checker rgb 1 rgb .3 } }\nsphere { 0, 1 pigment { rgbf .9 } hollow interior { ior 1.2 "
        "media { emission 1 "
        "absorption 2 method 1 samples 3 intervals 4 density { bozo scale .3 } } } finish { reflection .3 } }");
    const image::Image one = picture_of(d, 64, 48, 1, 64);
    for (const auto& [threads, block] : {std::pair(2, 32), std::pair(1, 10), std::pair(2, 5)}) {
        const image::Image other = picture_of(d, 64, 48, threads, block);
        CHECK(std::memcmp(one.pixels.data(), other.pixels.data(), one.pixels.size() * sizeof(float)) == 0);
    }
}

TEST_CASE("samples at random have the mean of their density", "[trace][media]")
{
    const auto mean = [](const std::string& how) {
        const image::Image picture = picture_of(
            grammar_test::parsed(kStage + filled("media { emission .5 density { gradient z } " + how + " }")), 64, 64);
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < 64 * 64; ++i) {
            const auto v = static_cast<double>(picture.pixels[4 * i]);
            sum += v;
            squares += v * v;
        }
        sum /= 4096;
        return std::pair(sum, squares / 4096 - sum * sum);
    };
    // A sample is equally distributed in [0, 0.5]: its variance is 1/48.
    const auto [one, spread] = mean("method 1 samples 1");
    CHECK(one == near(0.25, 0.01));
    CHECK(spread == near(1.0 / 48, 0.002));
    const auto [four, less] = mean("method 1 samples 4");
    CHECK(four == near(0.25, 0.005));
    CHECK(less == near(1.0 / 192, 0.0006));
    CHECK(mean("method 1 samples 1, 50").second == near(1.0 / 48, 0.002));  // one sample never asks for more
    CHECK(mean("method 1 samples 2, 50 variance 1e-6").second == near(1.0 / 48 / 51, 0.00006));
}
