#include "numbers/single_precision.h"
#include "render/plan/textures/pattern_kinds.h"
#include "render/texture/evaluate.h"
#include "render/texture/noise/noise.h"
#include "statement.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace {

struct Measured {
    std::string statement;
    std::vector<double> numbers;
};

/// Lines `statement;numbers` or bare numbers of a data file.
std::vector<Measured> measured(const std::string& name)
{
    std::ifstream in(std::string(SHADE_TEST_DATA) + "/" + name);
    REQUIRE(in);
    std::vector<Measured> out;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t mark = line.find(';');
        Measured m;
        if (mark != std::string::npos) m.statement = line.substr(0, mark);
        std::istringstream rest(mark == std::string::npos ? line : line.substr(mark + 1));
        for (std::string word; rest >> word;) m.numbers.push_back(std::stod(word));
        out.push_back(m);
    }
    REQUIRE(!out.empty());
    return out;
}

glm::dvec3 point(const Measured& m) { return {m.numbers[0], m.numbers[1], m.numbers[2]}; }

texture::TextureSet set_with_waves()
{
    texture::TextureSet set;
    set.wave_sources.resize(10);
    set.wave_frequencies.resize(10);
    texture::wave_sources(10, set.wave_sources.data(), set.wave_frequencies.data());
    return set;
}

texture::Pattern compiled(const scene::Pattern& description, texture::TextureSet& set,
                          scene::PovRay povray = scene::PovRay::V37)
{
    const auto kind = plan::pattern_kind(description.name.empty() ? "bozo" : description.name);
    REQUIRE(kind);
    return plan::compile_pattern(description, nullptr, *kind, 2, povray, set.warps);
}

}  // namespace

TEST_CASE("noise agrees with the measured points", "[texture][noise]")
{
    for (const Measured& m : measured("noise_vectors.txt")) {
        const glm::dvec3 p = point(m);
        INFO(p.x << ' ' << p.y << ' ' << p.z);
        for (int generator = 1; generator <= 3; ++generator)
            CHECK(texture::noise(p, generator) ==
                  Approx(m.numbers[2 + static_cast<std::size_t>(generator)]).margin(6e-16).epsilon(0));
        const glm::dvec3 v = texture::vector_noise(p);
        for (int k = 0; k < 3; ++k)
            CHECK(v[k] == Approx(m.numbers[6 + static_cast<std::size_t>(k)]).margin(6e-13).epsilon(0));
    }
}

TEST_CASE("patterns agree with the measured values", "[texture][pattern]")
{
    for (const Measured& m : measured("pattern_vectors.txt")) {
        texture::TextureSet set = set_with_waves();
        const texture::Pattern pattern = compiled(test::read_statement(m.statement).pattern, set);
        const glm::dvec3 p = point(m);
        const double v = texture::pattern_value(set, pattern, texture::warp_point(set, pattern, p), {});
        INFO(m.statement << " at " << p.x << ' ' << p.y << ' ' << p.z);
        if (std::isnan(m.numbers[3])) {  // the cubic warp of the origin
            CHECK(std::isnan(v));
            continue;
        }
        // Far outside, high powers are chaotic: late digits depend on the order of multiplications (spec 4, 5.6).
        if (m.statement.find("exponent") != std::string::npos) {
            CHECK(v == Approx(m.numbers[3]).epsilon(1e-7));
            continue;
        }
        CHECK(v == Approx(m.numbers[3]).margin(2e-12).epsilon(1e-11));
    }
}

TEST_CASE("turbulence of marble and wood agrees with the values that POV-Ray 3.8 has", "[texture][pattern]")
{
    for (const Measured& m : measured("pattern_vectors_38.txt")) {
        texture::TextureSet set;
        const texture::Pattern pattern = compiled(test::read_statement(m.statement).pattern, set, scene::PovRay::V38);
        const glm::dvec3 p = point(m);
        INFO(m.statement << " at " << p.x << ' ' << p.y << ' ' << p.z);
        CHECK(texture::pattern_value(set, pattern, texture::warp_point(set, pattern, p), {}) ==
              Approx(m.numbers[3]).margin(2e-12).epsilon(1e-11));
    }
}

TEST_CASE("warps agree with the measured points", "[texture][warp]")
{
    for (const Measured& m : measured("warp_vectors.txt")) {
        texture::TextureSet set;
        const texture::Pattern pattern = compiled(test::read_statement(m.statement).pattern, set);
        const glm::dvec3 q = texture::warp_point(set, pattern, point(m));
        INFO(m.statement << " at " << m.numbers[0] << ' ' << m.numbers[1] << ' ' << m.numbers[2]);
        for (int k = 0; k < 3; ++k)
            CHECK(q[k] == Approx(m.numbers[3 + static_cast<std::size_t>(k)]).margin(1e-9).epsilon(0));
    }
}

TEST_CASE("normals agree with the measured ones", "[texture][normal]")
{
    for (const Measured& m : measured("normal_vectors.txt")) {
        if (m.statement.find("_map") != std::string::npos || m.statement.find('{') != std::string::npos) continue;
        texture::TextureSet set = set_with_waves();
        const test::Statement statement = test::read_statement(m.statement);
        set.patterns.push_back(compiled(statement.pattern, set));
        texture::Normal normal;
        normal.pattern = 0;
        normal.amount = numbers::single(statement.amount);
        normal.accuracy = numbers::single(statement.accuracy);
        set.normals.push_back(normal);
        texture::Surroundings around;
        const glm::dvec3 n = texture::perturb(set, 0, {0, 0, -1}, point(m), around);
        INFO(m.statement << " at " << m.numbers[0] << ' ' << m.numbers[1]);
        // The table has five digits, measured at places of six; the worst is off by less than 4e-5.
        for (int k = 0; k < 3; ++k)
            CHECK(n[k] == Approx(m.numbers[3 + static_cast<std::size_t>(k)]).margin(5e-5).epsilon(0));
    }
}
