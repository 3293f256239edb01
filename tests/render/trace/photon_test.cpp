// Photons: POV-Ray's random numbers and records, the tree, the search against a dumber one, and light whose amount is
// known.
#include "render/picture/passes/photon_file.h"
#include "render/kernel/gather/photon_search.h"
#include "tests/render/trace/indirect_support.h"
#include "tests/render/trace/photon_support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <fstream>
#include <numbers>
#include <random>

using Catch::Contains;

namespace {

/// POV-Ray's search as spec 6, 3.7 has it: photon by photon, with a heap.
class HeapSearch {
public:
    HeapSearch(const std::vector<trace::Photon>& photons, const glm::dvec3& point, double radius,
               const glm::dvec3* normal, std::size_t most)
        : photons_(photons), point_(point), normal_(normal), most_(most), limit(radius * radius)
    {
        visit(0, static_cast<std::ptrdiff_t>(photons.size()) - 1);
    }

    std::vector<std::pair<double, std::size_t>> heap;

private:
    void visit(std::ptrdiff_t first, std::ptrdiff_t last)
    {
        if (last < first) return;
        const std::ptrdiff_t middle = (first + last) / 2;
        const trace::Photon& photon = photons_[static_cast<std::size_t>(middle)];
        const glm::vec3 place = photon.place();
        const double off = static_cast<double>(place[photon.axis]) - point_[photon.axis];
        const bool within = off * off < limit;
        if (off > 0.0) visit(first, middle - 1);
        else visit(middle + 1, last);
        if (off * off < limit) {
            if (off > 0.0) visit(middle + 1, last);
            else visit(first, middle - 1);
        }
        if (within) take(place, static_cast<std::size_t>(middle));
    }
    void take(const glm::vec3& place, std::size_t number)
    {
        const glm::dvec3 off = glm::dvec3(place) - point_;
        double d2 = glm::dot(off, off);
        if (normal_ != nullptr) d2 *= 1.0 + 16.0 * std::abs(glm::dot(*normal_, off));
        if (!(d2 < limit)) return;
        if (heap.size() == most_) {
            std::pop_heap(heap.begin(), heap.end());
            heap.back() = {d2, number};
            std::push_heap(heap.begin(), heap.end());
            limit = heap.front().first;
        } else {
            heap.push_back({d2, number});
            std::push_heap(heap.begin(), heap.end());
        }
    }
    const std::vector<trace::Photon>& photons_;
    const glm::dvec3 point_;
    const glm::dvec3* normal_;
    const std::size_t most_;

public:
    double limit;
};

}  // namespace

TEST_CASE("random numbers of photons are POV-Ray's", "[photons]")
{
    trace::JitterStream jitter;
    for (const double known : {0.135477004, 0.905791934, 0.835008590, 0.126986812})
        CHECK(jitter.draw() == Approx(known));
    trace::JitterStream skipped;
    skipped.skip(4 + 32768);
    CHECK(skipped.draw() == jitter.draw());
    trace::LibraryRandom library;
    for (const std::uint32_t known : {1804289383u, 846930886u, 1681692777u}) CHECK(library.draw() == known);
}

TEST_CASE("a photon's record keeps flux to a 128th of its largest channel and the way back to 2 degrees", "[photons]")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> axis(0.0, 1.0);
    for (int i = 0; i < 5000; ++i) {
        const glm::vec3 flux(std::ldexp(static_cast<float>(share(random)), i % 25 - 20));
        const glm::vec3 tinted = flux * glm::vec3(1.0f, static_cast<float>(share(random)), 0.5f);
        const glm::dvec3 back = glm::normalize(glm::dvec3(axis(random), axis(random), axis(random)));
        const trace::Photon photon = trace::make_photon({1, 2, 3}, tinted, back);
        const glm::vec3 kept = trace::flux_of(photon);
        for (int c = 0; c < 3; ++c) {
            CHECK(kept[c] <= tinted[c]);
            CHECK(kept[c] >= tinted[c] - tinted.x / 127.0f);
        }
        CHECK(glm::dot(glm::dvec3(trace::back_of(photon)), back) > std::cos(2.0 * std::numbers::pi / 127.0));
    }
    CHECK(trace::flux_of(trace::make_photon({}, glm::vec3(0), {0, 1, 0})) == glm::vec3(0));
    CHECK(trace::back_of(trace::make_photon({}, glm::vec3(1), {0, 1, 0})).y > 0.999f);  // no azimuth there
}

TEST_CASE("every node of a map divides its photons along its axis", "[photons]")
{
    std::mt19937 random(3);
    for (const std::size_t count : {0u, 1u, 2u, 3u, 4u, 17u, 1000u}) {
        trace::PhotonMap map;
        map.build(random_photons(random, count, 1.0f));
        const std::vector<trace::Photon>& photons = map.photons();
        REQUIRE(photons.size() == count);
        std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> ranges{{0, static_cast<std::ptrdiff_t>(count) - 1}};
        while (!ranges.empty()) {
            const auto [first, last] = ranges.back();
            ranges.pop_back();
            if (last - first < 2) continue;  // two may stand the other way round
            const std::ptrdiff_t middle = (first + last) / 2;
            const trace::Photon& node = photons[static_cast<std::size_t>(middle)];
            int wrong = 0;  // of the last two that it chooses between POV-Ray may take the other one
            for (std::ptrdiff_t i = first; i <= last; ++i) {
                const float here = photons[static_cast<std::size_t>(i)].place()[node.axis];
                wrong += (i < middle ? here > node.place()[node.axis] : here < node.place()[node.axis]) ? 1 : 0;
            }
            CHECK(wrong <= 1);
            ranges.push_back({first, middle - 1});
            ranges.push_back({middle + 1, last});
        }
    }
}

TEST_CASE("the search finds what POV-Ray's heap is left with", "[photons]")
{
    std::mt19937 random(11);
    std::normal_distribution<double> off(0.0, 1.0);
    std::size_t same = 0, asked = 0;
    for (const float flat : {0.0f, 0.3f, 1.0f}) {
        trace::PhotonMap map;
        map.build(random_photons(random, 3000, flat));
        trace::PhotonPlaces places;
        places.take(map.photons());
        trace::PhotonBoxes boxes;
        boxes.take(places);
        const trace::PhotonReach everywhere(boxes);
        trace::NearPhotons found;
        for (int i = 0; i < 600; ++i) {
            if (i % 8 == 0) found.forget();
            const glm::dvec3 point(off(random), off(random) * static_cast<double>(flat), off(random));
            const glm::dvec3 up = glm::normalize(glm::dvec3(0.2 * off(random), 1, 0));
            const glm::dvec3* normal = i % 2 == 0 ? &up : nullptr;
            const double radius = 0.05 * (1 + i % 23);
            const int most = 5 + i % 90;
            if (normal != nullptr)
                trace::PhotonSearch<true>(places, boxes, point, up, most).find(radius, everywhere, found);
            else trace::PhotonSearch<false>(places, boxes, point, up, most).find(radius, everywhere, found);
            const HeapSearch known(map.photons(), point, radius, normal, static_cast<std::size_t>(most));
            std::vector<std::size_t> a, b;
            for (const trace::NearPhotons::Near& near : found.found) a.push_back(near.photon);
            for (const auto& near : known.heap) b.push_back(near.second);
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            ++asked;
            same += a == b && found.radius2 == Approx(known.limit).epsilon(1e-12) ? 1 : 0;
            CHECK(found.found.size() == known.heap.size());
            if (normal != nullptr)
                trace::PhotonSearch<true>(places, boxes, point, up, most).find_in_order(radius, found);
            else trace::PhotonSearch<false>(places, boxes, point, up, most).find_in_order(radius, found);
            CHECK(found.found.size() == known.heap.size());
            CHECK(found.radius2 == Approx(known.limit).epsilon(1e-6));
        }
    }
    INFO(same << " of " << asked);
    CHECK(same > asked * 93 / 100);  // photons on the wrong side of a node
}

TEST_CASE("photons of a file that are nowhere are not found", "[photons]")
{
    std::mt19937 random(17);
    for (const std::size_t count : {1u, 7u, 8u, 9u, 64u, 65u, 600u}) {
        std::vector<trace::Photon> photons = random_photons(random, count, 1.0f);
        std::size_t somewhere = count;
        for (std::size_t i = 0; i < count; i += 3, --somewhere)
            (i % 2 == 0 ? photons[i].x : photons[i].z) = i % 4 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                                                    : std::numeric_limits<float>::infinity();
        trace::PhotonMap map;
        map.take(photons);
        map.gather_most = 1000;
        trace::NearPhotons found;
        map.find(glm::dvec3(0), 1e6, nullptr, found);
        CHECK(found.found.size() <= somewhere);
        CHECK(2 * found.found.size() >= somewhere);  // nodes that are nowhere hide some, as from POV-Ray
        for (const trace::NearPhotons::Near& near : found.found) CHECK(std::isfinite(near.distance2));
    }
}

TEST_CASE("a map comes back from its file as it was", "[photons]")
{
    std::mt19937 random(5);
    const std::vector<trace::Photon> surface = random_photons(random, 321, 0.0f),
                                     media = random_photons(random, 45, 1.0f);
    const std::string path = (std::filesystem::temp_directory_path() / "photon_test.ph").string();
    trace::write_photon_file(path, surface, media);
    CHECK(std::filesystem::file_size(path) == 8 + 20 * (321 + 45));
    const trace::PhotonFile read = trace::read_photon_file(path);
    REQUIRE((read.surface.size() == surface.size() && read.media.size() == media.size()));
    CHECK(std::memcmp(read.surface.data(), surface.data(), 20 * surface.size()) == 0);
    CHECK(std::memcmp(read.media.data(), media.data(), 20 * media.size()) == 0);
    std::filesystem::remove(path);
    CHECK_THROWS_WITH(trace::read_photon_file(path), Contains("cannot read the photon map"));
    CHECK_THROWS_WITH(trace::write_photon_file("/nowhere/map.ph", surface, media),
                      Contains("cannot write the photon map"));
}

TEST_CASE("a file that is no photon map is refused", "[photons]")
{
    const auto of = [](std::initializer_list<int> bytes) { return std::vector<char>(bytes.begin(), bytes.end()); };
    CHECK_THROWS_WITH(trace::decode_photons(of({}), "m"), Contains("ends too early"));
    CHECK_THROWS_WITH(trace::decode_photons(of({0, 0, 0, 0}), "m"), Contains("ends too early"));  // no photons of media
    CHECK_THROWS_WITH(trace::decode_photons(of({1, 0, 0, 0, 9}), "m"), Contains("too short"));
    CHECK_THROWS_WITH(trace::decode_photons(of({-1, -1, -1, -1}), "m"), Contains("too short"));
    std::vector<char> axis(28, 0);
    axis[0] = 1;
    axis[20] = 7;
    CHECK_THROWS_WITH(trace::decode_photons(axis, "m"), Contains("no axis 7"));
    CHECK(trace::decode_photons(of({0, 0, 0, 0, 0, 0, 0, 0}), "m").surface.empty());
}

namespace {

/// A floor under a slab of glass, on or below its lower face, and a light straight above.
std::string under_glass(const std::string& light, double ior, double bottom)
{
    char slab[300];
    std::snprintf(slab, sizeof slab,
                  "box { <-2,%g,-2>, <2,5,2> pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior %g }\n"
                  "  photons { target refraction on collect off } }\n",
                  bottom, ior);
    return "global_settings { assumed_gamma 1 photons { spacing 0.02 jitter 1 radius 0.9 gather 20, 20000 } }\n" +
           light + slab + "plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }\n";
}

}  // namespace

TEST_CASE("photons below a slab of glass bring the light that its faces spread", "[photons]")
{
    // Straight down at height h above a slab of thickness d, its lower face at height b, a cone of light is as wide as
    // if the way were h + d / n + b long; POV-Ray's lights do not fade, so without glass the floor would see 1.
    const auto floor = [](const std::string& light, double ior, double bottom) {
        // Seen from just above the floor, below the glass.
        return static_cast<double>(indirect_test::seen(under_glass(light, ior, bottom), "<0,0.5,0>", "-y").x);
    };
    const std::string lamp = "light_source { <0,15,0> rgb 1 }\n";
    for (const double ior : {1.2, 1.5, 2.0}) {
        const double way = 10.0 + 4.0 / ior + 1.0;
        CHECK(floor(lamp, ior, 1.0) == Approx(15.0 * 15.0 / (way * way)).epsilon(0.02));
    }
    // A parallel light stays as it is.
    const std::string sun = "light_source { <0,15,0> rgb 1 parallel point_at 0 }\n";
    CHECK(floor(sun, 1.5, 1.0) == Approx(1.0).epsilon(0.02));
    CHECK(floor("light_source { <0,15,0> rgb <0.5,0.2,0.1> parallel point_at 0 }\n", 1.5, 1.0) ==
          Approx(0.5).epsilon(0.02));
}

TEST_CASE("the map is the same for any number of threads and instruction set", "[photons]")
{
    const std::string text = R"(
global_settings { assumed_gamma 1 max_trace_level 6 photons { spacing 0.15 media 20 } }
camera { location <0,3,-6> look_at 0 }
light_source { <3,8,2> rgb 1 photons { refraction on reflection on } }
light_source { <-4,7,0> rgb <.5,.6,.7> area_light x, z, 2, 2 photons { refraction on area_light } }
plane { y, 0 pigment { rgb .8 } }
sphere { <0,1.6,0>, 1 pigment { rgbf .9 } finish { reflection .2 } interior { ior 1.5 dispersion 1.05 } photons { target } }
box { -1, 1 scale .4 rotate 30 translate <1.6,.6,0> pigment { rgb .7 } finish { reflection .6 } photons { target 1.4 reflection on } }
box { <-2,.05,-2>, <2,.5,2> hollow pigment { rgbt 1 } interior { media { scattering { 1, .2 } } } photons { refraction on pass_through collect off } }
)";
    const std::vector<trace::Isa> kernels = trace::kernels_there();
    const indirect_test::Made one = indirect_test::made(text, 32, 24, 1, kernels.front());
    REQUIRE(one.light);
    CHECK(one.light->photons.size() > 500);
    CHECK(one.light->media_photons.size() > 500);
    for (const trace::Isa isa : {kernels.front(), kernels.back()})
        for (const int threads : {1, 2, 3}) {
            const indirect_test::Made other = indirect_test::made(text, 32, 24, threads, isa);
            const auto same = [](const trace::PhotonMap& a, const trace::PhotonMap& b) {
                return a.size() == b.size() && std::memcmp(a.photons().data(), b.photons().data(), 20 * a.size()) == 0;
            };
            CHECK(same(one.light->photons, other.light->photons));
            CHECK(same(one.light->media_photons, other.light->media_photons));
            CHECK(one.light->photons.radius() == other.light->photons.radius());
            CHECK(std::memcmp(one.picture.pixels.data(), other.picture.pixels.data(),
                              one.picture.pixels.size() * sizeof(float)) == 0);
        }
}

TEST_CASE("photons that would never end are refused, and those that have nothing to do are none", "[photons]")
{
    const std::string scene = R"(
camera { location <0,3,-6> look_at 0 }
light_source { <0,8,0> rgb 1 }
plane { y, 0 pigment { rgb .8 } }
)";
    const std::string ball =
        "sphere { <0,1.6,0>, 1 pigment { rgbt 1 } interior { ior 1.5 } photons { target refraction on } }\n";
    const auto with = [&](const std::string& settings) {
        return indirect_test::made("global_settings { assumed_gamma 1 photons { " + settings + " } }" + scene + ball, 8,
                                   6);
    };
    CHECK_THROWS_WITH(with("spacing 1e-9"), Contains("these photons would be"));
    CHECK_THROWS_WITH(with("count 1e15"), Contains("these photons would be"));
    CHECK(with("spacing 0").light == nullptr);
    CHECK(with("spacing -1").light == nullptr);
    CHECK(with("spacing 0.2 gather 0, 0").light == nullptr);
    CHECK(with("spacing 5").light->photons.size() < 3);
    // The light within the target, even at its centre, where POV-Ray divides by 0.
    for (const char* place : {"<0,1.6,0>", "<0.3,1.6,0>"}) {
        const std::string inside = std::string("light_source { ") + place + " rgb 1 }";
        const indirect_test::Made made = indirect_test::made(
            "global_settings { assumed_gamma 1 photons { spacing 0.3 } }" + scene + ball + inside, 8, 6);
        CHECK(made.light);
        CHECK(std::all_of(made.picture.pixels.begin(), made.picture.pixels.end(),
                          [](float v) { return std::isfinite(v); }));
    }
}

TEST_CASE("photons off a rough mirror spread as its rays do, and none is lost", "[photons]")
{
    // Parallel light from y = 5 up to a small mirror at y = 10, and down to the floor.
    struct Landed {
        std::size_t count;
        double flux = 0.0, cosine = 0.0;  ///< of all; mean of the angle to the mirrored way
    };
    const auto landed = [](const std::string& gloss) {
        const indirect_test::Made made = indirect_test::made(
            "global_settings { assumed_gamma 1 photons { spacing .005 } }\n"
            "camera { location <0,3,-6> look_at 0 }\n"
            "light_source { 5*y rgb 1 parallel point_at 10*y photons { reflection on } }\n"
            "plane { y, 0 pigment { rgb .5 } }\n"
            "box { <-.1,10,-.1>, <.1,10.1,.1> pigment { rgb 0 } finish { diffuse 0 reflection { 1 " +
                gloss + " } } photons { target reflection on } }",
            8, 6);
        REQUIRE(made.light);
        Landed out{made.light->photons.size()};
        for (const trace::Photon& photon : made.light->photons.photons()) {
            const glm::dvec3 way = glm::dvec3(photon.place()) - glm::dvec3(0, 10, 0);
            out.flux += static_cast<double>(trace::flux_of(photon).x);
            out.cosine += -way.y / glm::length(way) / static_cast<double>(out.count);
        }
        return out;
    };
    const Landed sharp = landed(""), rough = landed("whittle_gloss .01"), rougher = landed("whittle_gloss .1");
    REQUIRE(sharp.count > 1000);
    CHECK(sharp.cosine > 0.9999);
    // The mean of c where it is as dense as c^e: (e + 1) / (e + 2), e being 1 over the roughness.
    CHECK(rough.cosine == Approx(101.0 / 102.0).margin(1e-3));
    CHECK(rougher.cosine == Approx(11.0 / 12.0).margin(0.01));
    CHECK(rough.count == sharp.count);
    CHECK(rough.flux == Approx(sharp.flux).epsilon(1e-3));
}
