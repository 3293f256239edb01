// Accuracy of solvers as steps of a report: docs/error_and_time.md.
#include "csg/freeform/freeform.h"
#include "render/study/ladder.h"
#include "render/study/solver_accuracy.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

namespace {

scene::Description solved(const std::string& text)
{
    return parser::parse_text("#version 3.7; camera { location -4*z look_at 0 }\n" + text, "t.pov", {}).scene;
}

const scene::Object& operand(const scene::Object& object, std::size_t i)
{
    return (*std::get<scene::Csg>(object.shape).operands)[i];
}

double accuracy(const scene::Object& object)
{
    const auto& kind = std::get<scene::Freeform>(object.shape).shape->kind;
    if (const auto* surface = std::get_if<csg::Isosurface>(&kind)) return surface->terms().accuracy;
    return std::get<csg::Parametric>(kind).terms().accuracy;
}

const std::string kSurface =
    "isosurface { function { x*x + y*y + z*z - 1 } accuracy 0.01 contained_by { box { -2, 2 } } }\n";

}  // namespace

TEST_CASE("accuracy is scaled however deep, and copies go on sharing", "[study][solvers]")
{
    const scene::Description given =
        solved("#declare Both = difference { union { " + kSurface +
               " box { 0, 1 } } sphere { 0, .5 } }\n"
               "object { Both } object { Both translate 3*x }\n"
               "parametric { function { u } function { v } function { u*v } <0,0>, <1,1> accuracy 0.02 }\n");
    scene::Description scene = given;
    study::scale_accuracy(scene.objects, 0.1);
    REQUIRE(scene.objects.size() == 3);
    CHECK(accuracy(operand(operand(scene.objects[0], 0), 0)) == Approx(0.001));
    CHECK(accuracy(scene.objects[2]) == Approx(0.002));
    CHECK(std::get<scene::Csg>(scene.objects[0].shape).operands ==
          std::get<scene::Csg>(scene.objects[1].shape).operands);
    CHECK(accuracy(operand(operand(given.objects[0], 0), 0)) == Approx(0.01));  // the scene as given stays
    CHECK(accuracy(given.objects[2]) == Approx(0.02));
}

TEST_CASE("the steps of julia sets are scaled, and no longer than the set itself", "[study][solvers]")
{
    scene::Description scene = solved("julia_fractal { <.1,.8,0,.02> precision 30 max_iteration 9 }\n");
    const auto terms = [&] {
        return std::get<csg::Julia>(std::get<scene::Freeform>(scene.objects[0].shape).shape->kind).terms();
    };
    study::scale_accuracy(scene.objects, 0.1);
    CHECK(terms().precision == Approx(300));
    CHECK(terms().iterations == 9);
    study::scale_accuracy(scene.objects, 1000.0);
    CHECK(terms().precision == 1.0);
}

TEST_CASE("only scenes with solvers have their accuracy in the ladder", "[study][solvers]")
{
    const auto has = [](const std::string& text) {
        const scene::Description scene = solved(text);
        const plan::CompiledScene compiled = plan::compile(scene, plan::Options{});
        for (const study::Setting& setting : study::ladder(scene, compiled, {}))
            if (setting.family.find("accuracy") != std::string::npos) return true;
        return false;
    };
    CHECK(has(kSurface));
    CHECK(has("union { sphere { 2*x, 1 } julia_fractal { <.1,.8,0,.02> precision 30 } }"));
    CHECK_FALSE(has("sphere { 0, 1 }"));
}
