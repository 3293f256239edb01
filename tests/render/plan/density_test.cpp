#include "parser/parse.h"
#include "render/plan/textures/textures.h"
#include "render/texture/evaluate.h"
#include "tests/support/csv_table.h"
#include "tests/support/temporary_folder.h"

#include <catch2/catch.hpp>

#include <fstream>

// Density files and objects as patterns against POV-Ray's answers; the file is 3x4x5, sample (37x + 91y + 53z + 11) mod
// 256.
namespace {

void write_big_endian(std::ofstream& out, std::uint64_t value, int bytes)
{
    for (int k = bytes - 1; k >= 0; --k) out.put(static_cast<char>(value >> (8 * k) & 255));
}

/// `bytes` a sample; each byte of a sample is the same, so that its share of the most is too.
void write_density(const std::string& path, int bytes)
{
    std::ofstream out(path, std::ios::binary);
    for (const std::uint64_t size : {3u, 4u, 5u}) write_big_endian(out, size, 2);
    for (unsigned z = 0; z < 5; ++z)
        for (unsigned y = 0; y < 4; ++y)
            for (unsigned x = 0; x < 3; ++x)
                for (int k = 0; k < bytes; ++k) out.put(static_cast<char>((37 * x + 91 * y + 53 * z + 11) % 256));
}

struct Compiled {
    texture::TextureSet set;
    std::uint32_t pattern = 0;

    Compiled(const std::string& folder, const std::string& pigment)
    {
        parser::Options options;
        options.library_path = {folder};
        const scene::Description scene =
            parser::parse_text("#version 3.7; sphere { 0, 1 pigment { " + pigment + " } }", "test.pov", options).scene;
        std::vector<scene::Unsupported> notes;
        plan::TextureCompiler compiler(scene, plan::Quality(), set, notes);
        pattern = set.pigments
                      .at(compiler.pigment(
                          std::get<std::vector<scene::Layer>>(scene.objects.at(0).texture->kind).at(0).pigment))
                      .pattern;
        CHECK(notes.empty());
    }
    double at(const glm::dvec3& p) const { return texture::raw_pattern(set, set.patterns.at(pattern), p, {}); }
};

}  // namespace

TEST_CASE("densities answer as POV-Ray's do", "[plan][density]")
{
    const support::TemporaryFolder folder;
    for (const int bytes : {1, 2, 4}) {
        write_density(folder / "cells.df3", bytes);
        for (int interpolate = 0; interpolate < 3; ++interpolate) {
            const Compiled compiled(folder.path(),
                                    "density_file df3 \"cells.df3\" interpolate " + std::to_string(interpolate));
            for (const auto& row : test_support::csv_table(WHITTLE_TEST_DATA "/densities.csv")) {
                const glm::dvec3 p{std::stod(row[0]), std::stod(row[1]), std::stod(row[2])};
                INFO(bytes << " bytes, interpolate " << interpolate << " at " << row[0] << ' ' << row[1] << ' '
                           << row[2]);
                const double expected = std::stod(row[3 + static_cast<std::size_t>(interpolate)]);
                CHECK(compiled.at(p) ==
                      Approx(expected).margin(interpolate == 2 ? 1e-7 : 1e-10));  // cubic: single precision
            }
            CHECK(compiled.at({1.0, 0.5, 0.5}) == 0.0);
            CHECK(compiled.at({0.5, -1e-9, 0.5}) == 0.0);
        }
    }
}

TEST_CASE("a density file of a length that fits nothing is told", "[plan][density]")
{
    const support::TemporaryFolder folder;
    std::ofstream(folder / "short.df3", std::ios::binary) << std::string("\0\1\0\1\0\2x", 7);
    CHECK_THROWS_WITH(Compiled(folder.path(), "density_file df3 \"short.df3\""), Catch::Contains("no density file"));
}

TEST_CASE("an object as a pattern is 1 inside", "[plan][object]")
{
    const Compiled compiled(".", "object { difference { sphere { 0, 1 } box { 0, 2 } } rgb 0, rgb 1 }");
    CHECK(compiled.at({-0.5, 0.1, 0.1}) == 1.0);
    CHECK(compiled.at({0.3, 0.3, 0.3}) == 0.0);
    CHECK(compiled.at({-2, 0, 0}) == 0.0);
}
