#include "parser/parse.h"
#include "render/plan/geometry/extent.h"
#include "render/plan/probe.h"
#include "tests/support/csv_table.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace {

using Row = std::vector<std::string>;

std::vector<Row> table(const std::string& name)
{
    return test_support::csv_table(std::string(WHITTLE_TEST_DATA "/") + name);
}

glm::dvec3 vector(const std::string& text)
{
    glm::dvec3 v(0.0);
    REQUIRE(std::sscanf(text.c_str(), "<%lf,%lf,%lf>", &v.x, &v.y, &v.z) == 3);
    return v;
}

/// The object of a statement; nothing if it is of a kind that is not drawn yet.
std::optional<scene::Object> object_of(const std::string& text)
{
    const parser::Result read = parser::parse_text(text, "test.pov", {});
    if (!read.scene.unsupported.empty() || read.scene.objects.size() != 1) return std::nullopt;
    return read.scene.objects.front();
}

/// Kept from row to row: a table asks the same object often.
plan::ObjectProbe* probe_of(const std::string& text)
{
    static std::map<std::string, std::unique_ptr<plan::ObjectProbe>> known;
    const auto [at, fresh] = known.try_emplace(text);
    if (fresh)
        if (const auto object = object_of(text)) at->second = std::make_unique<plan::ObjectProbe>(*object);
    return at->second.get();
}

}  // namespace

TEST_CASE("extents are those that POV-Ray tells", "[plan]")
{
    int checked = 0;
    for (const Row& row : table("extents.csv")) {
        const auto object = object_of(row[0]);
        if (!object) continue;
        INFO(row[0]);
        const csg::Aabb box = plan::described_extent(*object);
        for (int k = 0; k < 3; ++k) {
            CHECK(box.lower[k] == Approx(std::stod(row[static_cast<std::size_t>(1 + k)])).epsilon(1e-6).margin(2e-7));
            CHECK(box.upper[k] == Approx(std::stod(row[static_cast<std::size_t>(4 + k)])).epsilon(1e-6).margin(2e-7));
        }
        ++checked;
    }
    CHECK(checked > 55);
}

TEST_CASE("a text's extent grows by the thousandth of a degree that POV-Ray turns it", "[plan]")
{
    // min_extent and max_extent of POV-Ray 3.7.0.10; along z ours are 1e-6 inside of them.
    const std::filesystem::path folder = "/usr/share/povray-3.7/include";
    if (!std::filesystem::exists(folder / "timrom.ttf")) return;
    parser::Options options;
    options.library_path.push_back(folder.string());
    const parser::Result read = parser::parse_text(
        "text{ttf \"timrom.ttf\" \"Whittle\" .3,0 rotate 33*z scale <1.3,2,1>}", "test.pov", options);
    const csg::Aabb box = plan::described_extent(read.scene.objects.front());
    const double lower[3] = {-0.492840141, -0.026859473, -0.000054267},
                 upper[3] = {3.321403027, 4.474572182, 0.300013155};
    for (int k = 0; k < 3; ++k) {
        CHECK(box.lower[k] == Approx(lower[k]).margin(k == 2 ? 2e-6 : 1e-6));
        CHECK(box.upper[k] == Approx(upper[k]).margin(k == 2 ? 2e-6 : 1e-6));
    }
}

TEST_CASE("inside() answers as POV-Ray", "[plan]")
{
    int checked = 0;
    for (const Row& row : table("inside.csv")) {
        plan::ObjectProbe* probe = probe_of(row[0]);
        if (!probe) continue;
        INFO(row[0] << " at " << row[1]);
        CHECK(probe->inside(vector(row[1])) == (row[2] == "1"));
        ++checked;
    }
    CHECK(checked > 500);
}

TEST_CASE("trace() meets what POV-Ray meets", "[plan]")
{
    int checked = 0;
    for (const Row& row : table("trace.csv")) {
        plan::ObjectProbe* probe = probe_of(row[0]);
        if (!probe) continue;
        INFO(row[0] << " from " << row[1] << " along " << row[2]);
        const auto answer = probe->trace(vector(row[1]), glm::normalize(vector(row[2])));
        CHECK(answer.hit == (row[3] == "1"));
        if (!answer.hit || row[3] != "1") continue;
        const auto told = [&](std::size_t at) {
            return glm::dvec3(std::stod(row[at]), std::stod(row[at + 1]), std::stod(row[at + 2]));
        };
        CHECK(glm::length(answer.point - told(4)) < 1e-6);
        CHECK(glm::length(answer.normal - told(7)) < 1e-5);
        ++checked;
    }
    CHECK(checked > 500);
}
