#include "parser/base/queries.h"
#include "parser/parse.h"
#include "render/plan/geometry/extent.h"
#include "render/plan/probe.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// data/language.txt: scenes of a line or two, and what POV-Ray 3.7 does with them.
namespace {

struct Case {
    std::string text, debug;
    bool raw = false, accepted = true;
    int line = 0;  // that POV-Ray names; 0: it names none, or another than the mistake's
};

std::vector<Case> cases()
{
    std::ifstream in(WHITTLE_TEST_DATA "/language.txt");
    std::vector<Case> all;
    bool verdict = false;
    for (std::string line; std::getline(in, line);) {
        if (line == "---") {
            all.emplace_back();
            verdict = true;
        } else if (all.empty()) {
            continue;
        } else if (verdict) {
            Case& one = all.back();
            one.raw = line.rfind("raw ", 0) == 0;
            if (one.raw) line = line.substr(4);
            one.accepted = line == "accept";
            if (line.size() > 7 && !one.accepted) one.line = std::stoi(line.substr(7));
            verdict = false;
        } else if (line.rfind("> ", 0) == 0) {
            all.back().debug += line.substr(2) + '\n';
        } else {
            all.back().text += line + '\n';
        }
    }
    return all;
}

/// What a scene asks while it is read, answered as the program does.
class Answers final : public parser::SceneQueries {
public:
    parser::ObjectHit trace(const ObjectPtr& object, const glm::dvec3& origin, const glm::dvec3& direction,
                            const scene::Description&) override
    {
        const plan::ObjectProbe::Answer answer = plan::ObjectProbe(*object).trace(origin, direction);
        return {answer.hit, answer.point, answer.normal};
    }
    bool inside(const ObjectPtr& object, const glm::dvec3& point, const scene::Description&) override
    {
        return plan::ObjectProbe(*object).inside(point);
    }
    csg::Aabb extent(const ObjectPtr& object) override { return plan::described_extent(*object); }
    glm::dvec3 turbulence(const glm::dvec3& point, int octaves, double lambda, double omega) override
    {
        return plan::turbulence(point, octaves, lambda, omega);
    }
    function::Values evaluate(const function::FunctionPtr& called, const double* arguments,
                              const scene::Description& so_far) override
    {
        return plan::FunctionProbe(called, so_far).evaluate(arguments);
    }
    void evaluate(const function::FunctionPtr& called, std::span<const glm::dvec3> points,
                  std::span<function::Values> values, const scene::Description& so_far) override
    {
        plan::FunctionProbe(called, so_far).evaluate(points, values);
    }
};

std::string trimmed(std::string text)
{
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

}  // namespace

TEST_CASE("what POV-Ray accepts and rejects, and what it prints", "[parser][language]")
{
    const std::string prologue = "#version 3.7; global_settings{assumed_gamma 1} sphere{0,1}\n";
    const std::vector<Case> all = cases();
    CHECK(all.size() > 800);
    for (std::size_t i = 0; i < 2 * all.size(); ++i) {
        const Case& one = all[i / 2];
        Answers answers;
        parser::Options options;
        options.queries = &answers;
        options.image_width = options.image_height = 4;  // as in make_language.py
        options.blocks = i % 2 == 0;
        options.povray = scene::PovRay::V37;  // which refuses what only 3.8 reads
        INFO(one.text << (options.blocks ? "" : " read word by word"));
        std::string debug, error;
        try {
            const parser::Result result =
                parser::parse_text((one.raw ? "" : prologue) + trimmed(one.text), "t.pov", options);
            for (const parser::Message& message : result.messages)
                if (message.severity == parser::Severity::Debug) debug += message.text;
        } catch (const parser::Error& failed) {
            error = failed.what();
        }
        INFO(error);
        CHECK(error.empty() == one.accepted);
        if (one.accepted) CHECK(trimmed(debug) == trimmed(one.debug));
        else if (one.line > 0)
            CHECK(error.rfind("t.pov:" + std::to_string(one.line + (one.raw ? 0 : 1)) + ":", 0) == 0);
    }
}

TEST_CASE("every standard include file can be included", "[parser][language]")
{
    const std::filesystem::path folder = "/usr/share/povray-3.7/include";
    if (!std::filesystem::is_directory(folder)) return;  // the package is optional
    parser::Options options;
    options.library_path = {folder.string()};
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".inc") continue;
        INFO(entry.path());
        // Some ask for these two, as their own texts say.
        const std::string text = "#version 3.7; global_settings { assumed_gamma 1 } #include \"colors.inc\" #include "
                                 "\"shapes.inc\" #include \"" +
                                 entry.path().filename().string() + "\" sphere { 0, 1 }";
        CHECK_NOTHROW(parser::parse_text(text, "test.pov", options));
    }
}
