#include "parser/parse.h"
#include "render/plan/geometry/extent.h"
#include "render/plan/probe.h"
#include "render/scene/solids.h"
#include "tests/support/csv_table.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <map>
#include <set>
#include <string>

// Every freeform solid against what POV-Ray answers for it: data/shapes.csv, by data/make_shapes.py.
namespace {

using Row = std::vector<std::string>;

/// Statements by name.
std::map<std::string, std::string> statements()
{
    std::map<std::string, std::string> all;
    std::ifstream file(WHITTLE_TEST_DATA "/shapes.txt");
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::size_t kind = line.find('\t'), text = line.find('\t', kind + 1);
        all.emplace(line.substr(0, kind), line.substr(text + 1));
    }
    return all;
}

/// How far a hit may be from POV-Ray's, where more than rounding parts them: POV-Ray's own error, found by its
/// accuracy.
double tolerance_of(const std::string& name)
{
    static const std::map<std::string, double> kWider = {};
    const auto found = kWider.find(name);
    return found == kWider.end() ? 1e-6 : found->second;
}

/// Rays of 24 that may go another way. Hypercomplex julia sets reach their bounding sphere, where the last bit of a
/// coordinate says in or out, and POV-Ray's normals of some functions depend on rays traced before: 7 at most were
/// measured.
int strays_of(const std::string& name)
{
    return name.rfind("julia_h_", 0) == 0 && name != "julia_h_sqr" && name != "julia_h_pwr" ? 7 : 0;
}

/// Kinds that are not drawn yet: a shape that is drawn must not stand here.
const std::set<std::string> kUnsupported = {};

struct Shape {
    scene::Object object;
    std::unique_ptr<plan::ObjectProbe> probe;
    int rays = 0, strays = 0;
};

glm::dvec3 vector(const Row& row, std::size_t at)
{
    return {std::stod(row[at]), std::stod(row[at + 1]), std::stod(row[at + 2])};
}

bool near(const glm::dvec3& a, const glm::dvec3& b, double slack)
{
    return glm::length(a - b) <= slack * (1.0 + glm::length(b));
}

}  // namespace

TEST_CASE("freeform solids answer as POV-Ray's do", "[plan][shapes]")
{
    std::map<std::string, Shape> shapes;
    for (const auto& [name, text] : statements()) {
        const parser::Result read = parser::parse_text(text, name, {});
        if (!read.scene.unsupported_objects.empty()) {
            INFO(name);
            CHECK(kUnsupported.contains(read.scene.unsupported_objects.front().details->unsupported));
            continue;
        }
        INFO(name);
        REQUIRE(read.scene.objects.size() == 1);
        Shape& shape = shapes[name];
        shape.object = read.scene.objects.front();
        CHECK((shape.object.details->written == nullptr ||
               !kUnsupported.contains(std::string(shape.object.details->written->keyword))));
        shape.probe = std::make_unique<plan::ObjectProbe>(shape.object);
    }
    for (const Row& row : test_support::csv_table(WHITTLE_TEST_DATA "/shapes.csv")) {
        const auto found = shapes.find(row[0]);
        if (found == shapes.end()) continue;
        Shape& shape = found->second;
        if (row[1] == "extent") {
            const csg::Aabb box = plan::described_extent(shape.object);
            INFO(row[0] << ": extent " << box.lower.x << " " << box.lower.y << " " << box.lower.z << ", " << box.upper.x
                        << " " << box.upper.y << " " << box.upper.z);
            CHECK(near(box.lower, vector(row, 2), 1e-6));
            CHECK(near(box.upper, vector(row, 5), 1e-6));
        } else if (row[1] == "ray") {
            const glm::dvec3 way = vector(row, 5);
            const auto answer = shape.probe->trace(vector(row, 2), way / glm::length(way));
            const double slack = tolerance_of(row[0]);
            const bool agrees = answer.hit == (row[8] == "1") &&
                                (!answer.hit || (near(answer.point, vector(row, 9), slack) &&
                                                 near(answer.normal, vector(row, 12), 10 * slack)));
            ++shape.rays;
            if (!agrees && ++shape.strays <= strays_of(row[0])) continue;
            if (!agrees) {
                UNSCOPED_INFO(row[0] << ": from " << row[2] << "," << row[3] << "," << row[4] << " along " << row[5]
                                     << "," << row[6] << "," << row[7] << ": POV-Ray " << row[8] << " at " << row[9]
                                     << "," << row[10] << "," << row[11] << " normal " << row[12] << "," << row[13]
                                     << "," << row[14] << "; here " << answer.hit << " at " << answer.point.x << ","
                                     << answer.point.y << "," << answer.point.z << " normal " << answer.normal.x << ","
                                     << answer.normal.y << "," << answer.normal.z);
            }
            CHECK(agrees);
        } else {
            const bool inside = shape.probe->inside(vector(row, 2));
            INFO(row[0] << ": inside " << row[2] << "," << row[3] << "," << row[4]);
            CHECK(inside == (row[5] == "1"));
        }
    }
    for (const auto& [name, shape] : shapes) {
        INFO(name);
        CHECK(shape.rays == 24);
    }
}
