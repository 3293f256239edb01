// Light that surfaces hand on to each other (spec 6, section 4): closed forms, POV-Ray's tables, the promise of bytes.
#include "render/kernel/gather/indirect_light.h"
#include "render/picture/passes/passes.h"
#include "render/kernel/radiosity/lookup.h"
#include "render/picture/passes/pass_rays.h"
#include "render/picture/passes/sample_file.h"
#include "render/picture/render.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <sstream>

namespace {

image::Image picture_of(const std::string& text, plan::Options options, int threads = 0, std::uint64_t seed = 0)
{
    const plan::CompiledScene scene = plan::compile(grammar_test::parsed(text), options);
    trace::RenderOptions how;
    how.threads = threads;
    how.radiosity_seed = seed;
    const auto light = trace::run_passes(scene, how);
    how.indirect = light.get();
    image::Image out;
    trace::render(scene, how, out);
    return out;
}

plan::Options sized(int width, int height)
{
    plan::Options options;
    options.width = width;
    options.height = height;
    return options;
}

float middle_red(const std::string& text)
{
    image::Image out = picture_of(text, sized(16, 12));
    return out.at(8, 6)[0];
}

std::string globals(const std::string& items, const std::string& version = "3.7")
{
    return "#version " + version + "; global_settings { assumed_gamma 1 radiosity { " + items + " } }\n";
}

const std::string kAbove = "camera { orthographic location <0,5,0> look_at 0 right 4*x up 3*z }\n";

}  // namespace

TEST_CASE("a closed white box is as bright as its series of bounces", "[trace][radiosity]")
{
    for (const double albedo : {0.3, 0.7}) {
        double sum = 0.1, share = 0.1;
        for (int limit = 1; limit <= 6; ++limit) {
            sum += share *= albedo;
            const std::string text = globals("recursion_limit " + std::to_string(limit) + " adc_bailout 0.0001") +
                                     "camera { location <0.1,0.2,-0.7> look_at <0.5,0,1> }\n"
                                     "box { -1, 1 hollow pigment { rgb 1 } finish { emission 0.1 diffuse " +
                                     std::to_string(albedo) + " } }\n";
            image::Image out = picture_of(text, sized(24, 18));
            INFO("albedo " << albedo << ", recursion_limit " << limit);
            for (int x = 0; x < 24; ++x)
                for (int y = 0; y < 18; ++y) CHECK(static_cast<double>(out.at(x, y)[0]) == Approx(sum).epsilon(2e-4));
        }
    }
}

TEST_CASE("ambient gives way to radiosity since version 3.7", "[trace][radiosity]")
{
    const auto plane = [](const std::string& version, const std::string& finish) {
        return globals("recursion_limit 1", version) + kAbove + "background { rgb 0.2 }\n" +
               "plane { y, 0 pigment { rgb 0.5 } finish { " + finish + " diffuse 0.5 } }\n";
    };
    CHECK(middle_red(plane("3.7", "ambient 0.3")) == Approx(0.05f));
    CHECK(middle_red(plane("3.7", "ambient 0 emission 0.3")) == Approx(0.2f));
    for (const char* version : {"3.1", "3.5", "3.6"}) CHECK(middle_red(plane(version, "ambient 0.3")) == Approx(0.2f));
    plan::Options rough = sized(16, 12);
    rough.quality = plan::Quality::of(8);  // without radiosity
    image::Image out = picture_of(plane("3.7", "ambient 0.3"), rough);
    CHECK(out.at(8, 6)[0] == Approx(0.15f));
}

TEST_CASE("brightness, gray_threshold and albedo as POV-Ray has them", "[trace][radiosity]")
{
    const std::string plane = kAbove + "background { rgb <0.6,0,0> } plane { y, 0 pigment { rgb 0.5 } finish { ";
    CHECK(middle_red(globals("brightness 2 gray_threshold 1 recursion_limit 1") + plane + "diffuse 0.5 } }") ==
          Approx(0.0891f));
    CHECK(middle_red(globals("recursion_limit 1") + plane + "diffuse albedo 0.5 brilliance 3 } }") == Approx(0.15f));
    CHECK(middle_red(globals("recursion_limit 1 max_sample 0.3") + plane + "diffuse 0.5 } }") == Approx(0.075f));
}

TEST_CASE("light from behind comes through", "[trace][radiosity]")
{
    const std::string sheet = globals("recursion_limit 1") + kAbove +
                              "sky_sphere { pigment { planar color_map { [0 rgb 0.4] [1 rgb 0.4] } } }\n"
                              "disc { 0, y, 50 pigment { rgb 0.5 } finish { diffuse 0.5, 0.25 } }\n";
    CHECK(middle_red(sheet) == Approx(0.4f * 0.5f * 0.75f));
}

TEST_CASE("importance thins rays out and leaves their mean", "[trace][radiosity]")
{
    const auto halves = [](const std::string& a, const std::string& b, const std::string& more = "") {
        return globals("count 400 recursion_limit 1 error_bound 0.5") + kAbove +
               "#default { finish { ambient 0 } }\nbackground { rgb 0 }\n"
               "plane { x, -1000 hollow pigment { rgb 1 } finish { emission 0.8 diffuse 0 } radiosity { importance " +
               a + " } " + more + " }\n" +
               "plane { -x, -1000 hollow pigment { rgb 1 } finish { emission 0.1 diffuse 0 } radiosity { importance " +
               b + " } }\n" + "plane { y, 0 pigment { rgb 1 } finish { diffuse 1 } }\n";
    };
    const auto mean = [](const std::string& text) {
        image::Image out = picture_of(text, sized(16, 12));
        double sum = 0;
        for (int x = 2; x < 14; ++x)
            for (int y = 2; y < 10; ++y) sum += static_cast<double>(out.at(x, y)[0]);
        return sum / 96.0;
    };
    const double plain = mean(halves("1", "1"));
    CHECK(plain == Approx(0.45).margin(0.03));
    CHECK(mean(halves("0.3", "1")) == Approx(plain).margin(0.04));
    CHECK(mean(halves("0.3", "0.5")) == Approx(plain).margin(0.04));
    CHECK(mean(halves("1", "1", "no_radiosity")) < plain - 0.2);
}

TEST_CASE("rays, weights and reaches by bounce", "[trace][radiosity]")
{
    using trace::radiosity::BounceRules;
    scene::RadiositySettings settings;
    CHECK(BounceRules::of(settings, 0).rays == 35);
    CHECK(BounceRules::of(settings, 1).rays == 17);
    CHECK(BounceRules::of(settings, 3).rays == 5);
    CHECK(BounceRules::of(settings, 0).required == 5);
    CHECK(BounceRules::of(settings, 1).required == 2);
    CHECK(BounceRules::of(settings, 2).required == 1);
    CHECK(BounceRules::of(settings, 1).most_reach == Approx(0.4));
    CHECK(BounceRules::of(settings, 0).level == 1);
    CHECK(BounceRules::of(settings, 1).level == 3);
    CHECK(BounceRules::of(settings, 2).level == 4);
    settings.count = 3;
    CHECK(BounceRules::of(settings, 0).rays == 5);
}

TEST_CASE("passes of a pretrace", "[trace][radiosity]")
{
    const auto passes = trace::radiosity::passes(0.08, 0.04, 160, 120, scene::PovRay::V37);
    REQUIRE(passes.size() == 3);
    CHECK(passes[0].step == Approx(12.8));
    CHECK(passes[1].step == Approx(6.4));
    CHECK((!passes[2].pretrace && passes[2].step == 1.0));
    CHECK(trace::radiosity::passes(1, 1, 160, 120, scene::PovRay::V37).size() == 2);
    // Every pixel once in the last.
    const trace::radiosity::Parts parts{160, 120};
    std::map<std::pair<int, int>, int> seen;
    for (int part = 0; part < parts.count(); ++part)
        for (const glm::dvec2& p : rays_of(passes[2], parts, part))
            ++seen[{static_cast<int>(p.x), static_cast<int>(p.y)}];
    CHECK(seen.size() == 160 * 120);
}

TEST_CASE("rays of a pretrace lie half a pixel further back in 3.8", "[trace][radiosity]")
{
    // What +RFO wrote of a plane seen by an orthographic camera, 64x48 (spec 7d, 8).
    struct Row {
        scene::PovRay povray;
        double x[3], y[3];
    };
    for (const Row& row : {Row{scene::PovRay::V37, {4.43539, 11.9517, 20.4622}, {4.4298, 2.8152, 4.4412}},
                           Row{scene::PovRay::V38, {3.93539, 11.4517, 19.9622}, {3.9298, 2.3152, 3.9412}}}) {
        const auto first = trace::radiosity::passes(0.125, 0.03125, 64, 48, row.povray)[0];
        const auto rays = rays_of(first, trace::radiosity::Parts{64, 48}, 0);
        REQUIRE(rays.size() >= 3);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(rays[i].x == Approx(row.x[i]).margin(1e-4));
            CHECK(rays[i].y == Approx(row.y[i]).margin(1e-4));
        }
    }
}

TEST_CASE("a point finds what loose cells give it, with weights by the formula", "[trace][radiosity]")
{
    using namespace trace::radiosity;
    std::mt19937 random(6);
    const auto number = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 32>(random);
    };
    const auto way = [&] { return glm::normalize(glm::dvec3(number(-1, 1), number(0.2, 1), number(-1, 1))); };
    for (int round = 0; round < 20; ++round) {
        SampleGrid grid;
        std::vector<std::pair<Sample, CellPlace>> all;
        const double shift = round % 3 == 0 ? 0.0 : number(-5000, 5000);
        for (int i = 0; i < 400; ++i) {
            Sample s;
            s.point = glm::dvec3(number(-3, 3), number(-0.2, 0.2), number(-3, 3)) + shift;
            s.normal = glm::vec3(way());
            s.color = glm::vec3(number(0, 1), number(0, 1), number(0, 1));
            s.reach = static_cast<float>(number(0.05, 2));
            s.nearest = static_cast<float>(number(0.01, 0.5)) * s.reach;
            s.nearest_way = glm::vec3(way());
            s.quality = static_cast<float>(number(0.3, 1));
            const double radius = static_cast<double>(s.reach) * 0.3;
            grid.add(s, radius);
            all.emplace_back(s, CellPlace::of_ball(s.point, radius));
        }
        for (const bool smooth : {false, true}) {
            LookupGroup group(smooth);
            std::vector<std::pair<glm::dvec3, glm::dvec3>> asked;
            for (std::size_t k = 0; k < LookupGroup::kLanes; ++k) {
                asked.emplace_back(glm::dvec3(number(-3, 3), number(-0.2, 0.2), number(-3, 3)) + shift, way());
                group.add(asked.back().first, asked.back().second, 1.5);
            }
            group.ask(grid);
            for (std::size_t k = 0; k < asked.size(); ++k) {
                double weight = 0, red = 0;
                for (const auto& [s, cell] : all) {
                    if (!cell.holds(asked[k].first)) continue;
                    const glm::dvec3 v = asked[k].first - s.point, n(s.normal);
                    const double d = glm::length(v), h = s.reach, toward = glm::dot(glm::dvec3(s.nearest_way), v) / d;
                    const double r = toward > 0 ? toward * s.nearest + (1 - toward) * h : h;
                    const glm::dvec3 m = asked[k].second + n;
                    const double front = glm::dot(v, m) / d / glm::length(m);
                    const double x = (d / r + 2 * std::sqrt(std::abs(1 - glm::dot(asked[k].second, n)))) / 1.5;
                    if (!(d < 1.5 * h && d < 1.5 * r && x < 1 && front > -0.05)) continue;
                    double w = !smooth ? 1 - x : x < 0.5 ? 1 - 2 * x * x : 2 * (1 - x) * (1 - x);
                    if (front <= 0) w *= 1 + 20 * front;
                    if (w <= 0.001) continue;
                    weight += w * s.quality;
                    red += w * s.quality * s.color.x;
                }
                Lookup found;
                group.add_to(k, found);
                CHECK(found.weight == Approx(weight).epsilon(1e-3).margin(3e-3));
                CHECK(found.sum.x == Approx(red).epsilon(1e-3).margin(3e-3));
            }
            // Whoever asks only whether there is enough is told the same.
            for (const double quarters : {0.0, 1.0, 5.0}) {
                LookupGroup brief(smooth);
                brief.stop_at(quarters);
                for (const auto& [point, normal] : asked) brief.add(point, normal, 1.5);
                brief.ask(grid);
                for (std::size_t k = 0; k < asked.size(); ++k) {
                    Lookup whole, part;
                    group.add_to(k, whole);
                    brief.add_to(k, part);
                    const auto enough = [&](const Lookup& found) {
                        return found.weight > 0.0 && 4.0 * found.weight >= quarters;
                    };
                    CHECK(enough(part) == enough(whole));
                    CHECK(part.weight <= whole.weight);
                    if (!enough(whole)) CHECK((part.weight == whole.weight && part.sum == whole.sum));
                }
            }
        }
    }
}

TEST_CASE("files of samples are POV-Ray's", "[trace][radiosity]")
{
    using namespace trace::radiosity;
    const std::string line =
        "C1\t1.71185\t-4.44089e-16\t-2.20607\t7ffe7f\t0.1731\t0.1731\t0.1731\t1.1956\t3.31683\t789ffa";
    const auto found = sample_of(line);
    REQUIRE(found);
    CHECK(found->bounce == 0);
    CHECK(glm::distance(found->sample.point, {1.71185, 0, -2.20607}) < 1e-9);
    CHECK(glm::distance(found->sample.normal, {0, 1, 0}) < 1e-6f);
    CHECK(found->sample.reach == Approx(1.1956f));
    CHECK(found->sample.nearest == Approx(3.31683f));
    CHECK(line_of(*found) == line + "\n");
    for (const char* other : {"", "B 1 2", "P", "C1 1 2 3", "C0\t0\t0\t0\t7ffe7f\t0\t0\t0\t1\t1\t7ffe7f",
                              "C1\tnan\t0\t0\t7ffe7f\t0\t0\t0\t1\t1\t7ffe7f"})
        CHECK(!sample_of(other));
    CHECK_THROWS_WITH(read_samples("/nowhere/x.rca"), "cannot read the radiosity samples of '/nowhere/x.rca'");
}

TEST_CASE("samples from a file are used again", "[trace][radiosity]")
{
    const std::string path = SOURCE_ROOT "/docs/povray/data/global-scenes/rad_corner.pov", file = "radiosity_test.rca";
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    const plan::CompiledScene scene = plan::compile(grammar_test::parsed(text.str()), sized(80, 60));
    trace::RenderOptions how;
    how.radiosity_to = file;
    const auto first = trace::run_passes(scene, how);
    how.radiosity_to.clear();
    how.radiosity_from = file;
    const auto second = trace::run_passes(scene, how);
    std::remove(file.c_str());
    const auto count = [](const trace::IndirectLight& light) {
        std::size_t sum = 0;
        for (const auto& grid : light.radiosity->samples) sum += grid.size();
        return sum;
    };
    REQUIRE(count(*first) > 100);
    CHECK(count(*second) >= count(*first));
    CHECK(count(*second) < count(*first) + count(*first) / 10);
}

TEST_CASE("the same picture for any number of threads and any blocks", "[trace][radiosity]")
{
    const std::string text = globals("count 20 nearest_count 3 pretrace_end 0.02 always_sample on recursion_limit 3") +
                             "camera { location <0,2,-4> look_at <0,0.6,0> } background { rgb <0.4,0.5,0.7> }\n"
                             "light_source { <-5,8,-6> rgb 0.7 area_light x, y, 3, 3 jitter }\n"
                             "plane { y, 0 pigment { checker rgb 0.3 rgb 0.8 } finish { reflection 0.2 } }\n"
                             "sphere { <-0.8,0.7,0>, 0.7 pigment { rgb 0.9 } }\n"
                             "box { <0.4,0,0>, <1.2,1,0.7> pigment { rgbf <1,0.6,0.3,0.5> } interior { ior 1.3 } }\n";
    plan::Options options = sized(76, 52);
    options.antialiasing.method = 1;
    options.block_size = 8;
    const image::Image reference = picture_of(text, options, 1);
    for (const int blocks : {8, 64})
        for (const int threads : {1, 2, 3}) {
            options.block_size = blocks;
            options.antialiasing.method = 0;
            const image::Image other = picture_of(text, options, threads);
            options.block_size = 8;
            const image::Image same = picture_of(text, options, 1);
            INFO(blocks << " " << threads);
            CHECK(other.pixels == same.pixels);
        }
    options.antialiasing.method = 1;
    CHECK(picture_of(text, options, 2).pixels == reference.pixels);
}

namespace {

/// What is shown of a colour, 0 to 255.
double shown(float color)
{
    const double v = std::clamp(static_cast<double>(color), 0.0, 1.0);
    return std::round(255.0 * (v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055));
}

/// Means of several pictures of a scene, each from other samples.
std::vector<std::array<double, 3>> mean_picture(const std::string& text)
{
    constexpr int kPictures = 4;
    std::vector<std::array<double, 3>> mean(160 * 120);
    for (std::uint64_t seed = 0; seed < kPictures; ++seed) {
        const image::Image made = picture_of(text, sized(160, 120), 0, seed);
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    mean[static_cast<std::size_t>(160 * y + x)][c] += shown(made.at(x, y)[c]) / kPictures;
    }
    return mean;
}

}  // namespace

TEST_CASE("means of tiles are POV-Ray's within its own spread", "[trace][radiosity]")
{
    const std::string folder = SOURCE_ROOT "/docs/povray/data/";
    std::ifstream table(folder + "06-global-scenes-tiles.csv");
    std::map<std::string, std::vector<std::array<double, 3>>> pictures;
    std::map<std::string, int> tiles;
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream in(line);
        std::string name;
        int tile_x = 0, tile_y = 0;
        double first[3], mean[3], spread = 0;
        in >> name >> tile_x >> tile_y >> first[0] >> first[1] >> first[2] >> mean[0] >> mean[1] >> mean[2] >> spread;
        if (name.rfind("rad_", 0) != 0) continue;
        if (pictures.count(name) == 0) {
            std::ifstream scene(folder + "global-scenes/" + name + ".pov");
            std::stringstream text;
            text << scene.rdbuf();
            pictures[name] = mean_picture(text.str());
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            double sum = 0;
            for (int y = 20 * tile_y; y < 20 * tile_y + 20; ++y)
                for (int x = 20 * tile_x; x < 20 * tile_x + 20; ++x)
                    sum += pictures[name][static_cast<std::size_t>(160 * y + x)][channel];
            INFO(name << " tile " << tile_x << ", " << tile_y << ", channel " << channel);
            CHECK(sum / 400.0 == Approx(mean[channel]).margin(std::max(1.0, 1.5 * spread)));
        }
        ++tiles[name];
    }
    CHECK(tiles.size() == 5);
    for (const auto& [name, count] : tiles) CHECK(count == 48);
}
