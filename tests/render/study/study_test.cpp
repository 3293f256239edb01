// Error against run time: docs/error_and_time.md.
#include "render/image/compare/flip.h"
#include "render/study/kinds.h"
#include "render/study/page.h"
#include "render/study/plot.h"
#include "tests/parser/grammar_support.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace {

const std::string kHead = "#version 3.7; global_settings { assumed_gamma 1 }\n"
                          "camera { location <0,1,-4> look_at 0 }\n";
constexpr int kWidth = 32, kHeight = 24;

std::vector<float> plain(std::size_t pixels, float r, float g, float b)
{
    std::vector<float> out;
    for (std::size_t i = 0; i < pixels; ++i) out.insert(out.end(), {r, g, b});
    return out;
}

study::Study study_of(const scene::Description& scene)
{
    plan::Options options;
    options.width = kWidth;
    options.height = kHeight;
    return {scene, options, trace::RenderOptions{}, {image::TransferCurve::linear(), image::TransferCurve::srgb()}};
}

std::set<std::string> families(const std::string& text)
{
    const scene::Description scene = parser::parse_text(kHead + text, "t.pov", {}).scene;
    std::set<std::string> out;
    const study::Study study = study_of(scene);
    for (const study::Setting& setting : study.settings()) out.insert(setting.family);
    return out;
}

bool any_with(const std::set<std::string>& names, const std::string& part)
{
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& n) { return n.find(part) != std::string::npos; });
}

}  // namespace

TEST_CASE("FLIP of plain pictures is that of its formula", "[study]")
{
    // Black beside white: |L| = 100 and no hue, redistributed beyond the knee at 0.4 of green beside blue.
    const auto black = plain(20 * 20, 0, 0, 0), white = plain(20 * 20, 1, 1, 1), grey = plain(20 * 20, .5f, .5f, .5f);
    const double most = std::pow(203.3, 0.7), knee = 0.4 * most;
    const double expected = 0.95 + (std::pow(100.0, 0.7) - knee) / (most - knee) * 0.05;
    CHECK(image::mean_flip(black, white, 20, 20) == Approx(expected).margin(1e-3));
    CHECK(image::mean_flip(white, black, 20, 20) == Approx(expected).margin(1e-3));
    CHECK(image::mean_flip(grey, grey, 20, 20) == 0.0);
    // L of sRGB 0.5 is 53.389.
    const double lightness = std::pow(53.389, 0.7);
    CHECK(image::mean_flip(black, grey, 20, 20) ==
          Approx(lightness < knee ? 0.95 * lightness / knee : 0.95 + 0.05 * (lightness - knee) / (most - knee))
              .margin(1e-3));
}

TEST_CASE("FLIP: edges weigh more than what is plain, single pixels blur", "[study]")
{
    constexpr int kSide = 40;
    auto flat = plain(kSide * kSide, .5f, .5f, .5f), edge = flat, dots = flat;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto at = static_cast<std::size_t>(3 * (y * kSide + x) + c);
                edge[at] = x < kSide / 2 ? .4f : .6f;
                dots[at] = (x + y) % 2 == 0 ? .4f : .6f;  // eyes do not resolve these at 67 pixels a degree
            }
    const auto at_edge = image::flip(flat, edge, kSide, kSide), at_dots = image::flip(flat, dots, kSide, kSide);
    const auto of = [&](const std::vector<float>& v, int x, int y) {
        return v[static_cast<std::size_t>(y * kSide + x)];
    };
    CHECK(of(at_edge, kSide / 2, 20) > of(at_edge, 2, 20));
    CHECK(of(at_dots, 20, 20) < 0.25f * of(at_edge, 2, 20));
    for (const float v : at_edge) {
        CHECK(v >= 0.0f);
        CHECK(v <= 1.0f);
    }
}

TEST_CASE("a scene is asked about what it has and nothing else", "[study]")
{
    const auto plain_scene = families("light_source { 5*y rgb 1 } sphere { 0, 1 pigment { rgb 1 } }");
    CHECK(plain_scene == std::set<std::string>{"antialiasing", "antialiasing, method 1", "antialiasing, method 2",
                                               "antialiasing, method 3", "samples", "samples in a time",
                                               "samples where needed"});
    const auto rich = families("light_source { 5*y rgb 1 area_light x, z, 3, 3 }\n"
                               "sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } }\n"
                               "plane { y, -1 pigment { rgb .5 } }");
    CHECK(any_with(rich, "area lights"));
    CHECK(any_with(rich, "reflection"));
    CHECK(!any_with(rich, "lens"));
    CHECK(!any_with(rich, "radiosity"));
    CHECK(!any_with(rich, "media"));
    CHECK(any_with(families("media { emission .1 } sphere { 0, 1 }"), "media"));
}

TEST_CASE("errors are those of their definition", "[study]")
{
    study::Shown truth{2, 1, {0, 0, 0, .5f, .5f, .5f}}, other{2, 1, {0, 0, 0, .5f, .5f, .6f}};
    const study::Error error = study::error_of(truth, other, image::TransferCurve::linear());
    CHECK(error.levels == Approx(25.5 / std::sqrt(6.0)).epsilon(1e-5));
    CHECK(error.linear == Approx(0.1 / std::sqrt(6.0)).epsilon(1e-5));
    CHECK(error.beyond == 0.5);
    CHECK(study::error_of(truth, truth, image::TransferCurve::srgb()).levels == 0.0);
}

TEST_CASE("the front holds what nothing beats, and the cheapest is on it", "[study]")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0.01, 1.0);
    for (int round = 0; round < 50; ++round) {
        std::vector<study::Result> results(30);
        for (study::Result& r : results) {
            r.seconds = any(random);
            r.error.levels = any(random);
            r.povray = any(random) < 0.2;
        }
        const auto front = study::pareto_front(results);
        for (const study::Result& r : results) {
            if (r.povray) continue;
            const bool beaten = std::any_of(results.begin(), results.end(), [&](const study::Result& o) {
                return !o.povray && o.seconds < r.seconds && o.error.levels < r.error.levels;
            });
            CHECK(beaten == (std::find(front.begin(), front.end(), &r) == front.end()));
        }
        const double wanted = any(random);
        const study::Result* best = study::cheapest(results, wanted);
        for (const study::Result& r : results)
            if (!r.povray && r.error.levels <= wanted) {
                REQUIRE(best != nullptr);
                CHECK(best->seconds <= r.seconds);
            }
    }
}

TEST_CASE("more samples are nearer to the truth, and a page tells it", "[study]")
{
    const scene::Description scene =
        parser::parse_text(
            kHead + "light_source { <3,5,-3> rgb 1 area_light x, z, 3, 3 }\n"
                    "plane { y,-1 pigment { checker rgb 1 rgb .2 } } sphere { 0, 1 pigment { rgb <1,.5,.2> } }\n",
            "<t>.pov", {})
            .scene;
    study::Study study = study_of(scene);
    study::Section section;
    section.scene = "<t>.pov";
    section.width = kWidth;
    section.height = kHeight;
    section.truth = study.find_truth(0.3, 20.0);
    CHECK(section.truth.expected_error <= 0.3);
    double before = 1e9;
    for (const study::Setting& setting : study.settings()) {
        if (setting.family != "samples" || setting.name == "--samples=256") continue;
        const auto result = study.run(setting);
        REQUIRE(result);
        CHECK(result->error.levels < before);
        before = result->error.levels;
        section.results.push_back(*result);
    }
    CHECK(section.results.size() == 4);
    study::Circumstances about;
    about.wanted = 2.0 * before;
    const std::string page = study::page({section}, about, [](const study::Shown&) { return std::string("png"); });
    CHECK(page.find("&lt;t&gt;.pov") != std::string::npos);
    CHECK(page.find("<t>.pov") == std::string::npos);
    CHECK(page.find("<svg") != std::string::npos);
    CHECK(page.find("cG5n") != std::string::npos);  // "png" in base 64
    CHECK(page.find("The fastest setting with at most") != std::string::npos);
    const std::string csv = study::csv({section});
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 5);
}

TEST_CASE("a page counts how often an asked error was kept", "[study]")
{
    const auto result = [](double asked, double found) {
        study::Result r;
        r.family = "samples where needed";
        r.name = fmt::format("--error={:g}", asked);
        r.asked_error = asked;
        r.error.levels = found;
        r.seconds = 1.0;
        return r;
    };
    study::Section a, b;
    a.scene = "a.pov", b.scene = "b.pov";
    a.results = {result(1.0, 0.9), result(0.5, 0.51)};
    b.results = {result(1.0, 0.8)};
    const std::string page = study::page({a, b}, {}, [](const study::Shown&) { return std::string(); });
    CHECK(page.find("<td>2 of 2</td><td>0 of 1</td>") != std::string::npos);
}

TEST_CASE("a page counts how often a time was kept", "[study]")
{
    const auto result = [](double asked, double took) {
        study::Result r;
        r.family = "samples in a time";
        r.name = fmt::format("--time={:g}", asked);
        r.asked_seconds = asked;
        r.seconds = took;
        r.error.levels = 1.0;
        return r;
    };
    study::Section a, b;
    a.scene = "x/a.pov", b.scene = "y/a.pov";
    a.results = {result(1.0, 1.09), result(2.0, 0.3)};
    b.results = {result(1.0, 1.2)};
    const std::string page = study::page({a, b}, {}, [](const study::Shown&) { return std::string(); });
    CHECK(page.find("<td>1 of 2</td><td>1 of 1</td>") != std::string::npos);
    // Links end with the name of the scene's file.
    CHECK(page.find("<h2 id='a'>x/a.pov</h2>") != std::string::npos);
    CHECK(page.find("<h2 id='a_2'>y/a.pov</h2>") != std::string::npos);
    CHECK(page.find("href='#a_2'") != std::string::npos);
}

TEST_CASE("what stands in for light between surfaces has a plot and equal times of its own", "[study]")
{
    const auto result = [](const char* family, double seconds, double levels) {
        study::Result r;
        r.family = r.name = family;
        r.seconds = seconds;
        r.error.levels = levels;
        return r;
    };
    study::Section section;
    section.scene = "a.pov";
    section.results = {
        result("radiosity alone", 0.4, 15), result("radiosity alone", 3, 14), result("photons alone", 0.1, 40),
        result("paths", 0.15, 20),          result("paths", 1.5, 7),          result("samples", 0.3, 41)};
    const std::string page = study::page({section}, {}, [](const study::Shown&) { return std::string(); });
    const auto has = [&](const std::string& row) { return page.find(row) != std::string::npos; };
    CHECK(has("<th>seconds</th><th>radiosity alone</th><th>photons alone</th><th>paths</th></tr>"));
    CHECK(has("<tr><td>0.1</td><td></td><td>40.00</td><td></td></tr>"));
    CHECK(has("<tr><td>0.5</td><td>15.00</td><td>40.00</td><td>20.00</td></tr>"));
    CHECK(has("<tr><td>5</td><td>14.00</td><td>40.00</td><td>7.00</td></tr>"));
    CHECK_FALSE(has("<tr><td>10</td>"));
    section.results = {result("samples", 0.3, 41)};
    CHECK(study::page({section}, {}, [](const study::Shown&) { return std::string(); }).find("equal time") ==
          std::string::npos);
}

TEST_CASE("no two kinds of one plot look alike", "[study]")
{
    const scene::Description scene =
        parser::parse_text(kHead + "global_settings { radiosity {} photons { spacing .1 } }\n"
                                   "light_source { 5*y rgb 1 area_light x, z, 3, 3 }\n"
                                   "media { emission .1 }\n"
                                   "isosurface { function { y } contained_by { box { -1, 1 } } }\n"
                                   "sphere { 0, 1 pigment { rgb 1 } finish { reflection .5 } photons { target } }\n",
                           "t.pov", {})
            .scene;
    plan::Options options;
    options.width = kWidth, options.height = kHeight;
    const plan::CompiledScene compiled = plan::compile(scene, options);
    trace::RayCounts rays;
    rays.reflected = 1;
    std::map<std::string, std::string> seen;  // which kind has a look
    std::set<std::string> kinds;
    for (const study::Setting& setting : study::ladder(scene, compiled, rays, true)) {
        if (!kinds.insert(setting.family).second) continue;
        const study::Look look = study::look_of(setting.family);
        const std::string key = fmt::format("{} {}", look.color, static_cast<int>(look.mark));
        INFO(setting.family << " and " << seen[key]);
        CHECK(seen[key].empty());
        seen[key] = setting.family;
    }
    CHECK(kinds.count("radiosity alone") + kinds.count("photons alone") + kinds.count("radiosity and photons") == 3);
    CHECK(kinds.size() >= 20);
}

TEST_CASE("the laboratory's table becomes plots of error against nanoseconds", "[study]")
{
    const support::TemporaryFolder folder;
    support::write_text(folder / "t.csv", "sweep,value,solid,hits,missed,false,worst,median,ns\n"
                                          "scale,1e-06,sphere,2,0,0,4e-17,4e-17,180\n"
                                          "scale,1,torus,2,1,0,2e-14,1e-15,410\n");
    const std::vector<study::SolverRow> rows = study::read_solvers(folder / "t.csv");
    REQUIRE(rows.size() == 2);
    CHECK(rows[1].solid == "torus");
    CHECK(rows[1].missed == 1);
    CHECK(rows[0].value == 1e-6);
    const std::string plots = study::solver_plots(rows);
    CHECK(plots.find("<h3>Quadrics</h3>") != std::string::npos);
    CHECK(plots.find("torus scale 1: 410 ns, 2e-14") != std::string::npos);
    CHECK(plots.find("Iterated") == std::string::npos);  // none was asked
    support::write_text(folder / "other.csv", "a,b\n1,2\n");
    CHECK_THROWS_WITH(study::read_solvers(folder / "other.csv"), Catch::Contains("no table of numerics_lab"));
    CHECK_THROWS_WITH(study::read_solvers(folder / "none.csv"), Catch::Contains("cannot read"));
}
