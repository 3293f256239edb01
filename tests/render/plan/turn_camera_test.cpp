#include "render/plan/turn_camera.h"

#include "parser/parse.h"

#include <catch2/catch.hpp>

// A plan whose camera was changed is the plan of a scene with that camera: what --dump=plan prints, and where it
// stands.
namespace {

constexpr const char* kScene = R"(#version 3.7;
    sphere { <0, 0, -5>, 2 pigment { rgbt 0.9 } interior { ior 1.2 } }
    sphere { <0, 0, 5>, 2 pigment { rgbt 0.9 } interior { ior 1.5 } }
    light_source { <-5, 8, -6>, 1 }
)";

scene::Description scene_with(const std::string& camera)
{
    return parser::parse_text(kScene + camera, "test.pov", {}).scene;
}

}  // namespace

TEST_CASE("a turned camera is planned as one that was there from the start", "[plan][camera]")
{
    const std::string places[] = {"camera { location <0, 0, -5> }", "camera { location <0, 0, 5> direction -z }",
                                  "camera { location <0, 0, -0.1> }", "camera { orthographic location <0, 0, -5> }",
                                  "camera { location <0, 9, 0> direction -y up z aperture 0.5 blur_samples 5 }"};
    for (const bool samples : {false, true}) {
        plan::Options options;
        options.free_sampling = samples;
        plan::CompiledScene turned = plan::compile(scene_with(places[0]), options);
        for (const std::string& place : places) {
            INFO(place);
            const plan::CompiledScene alone = plan::compile(scene_with(place), options);
            plan::turn_camera(turned, scene_with(place).camera);
            CHECK(plan::dump(turned) == plan::dump(alone));
            CHECK(turned.camera_interiors == alone.camera_interiors);
            CHECK(turned.start_holders.size() == alone.start_holders.size());
            CHECK(turned.camera.blur_samples == alone.camera.blur_samples);
            CHECK(turned.camera.direction == alone.camera.direction);
            CHECK(turned.tolerance.hit == alone.tolerance.hit);
        }
    }
}
