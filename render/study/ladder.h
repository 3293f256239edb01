#pragma once

#include "render/plan/compiled_scene.h"
#include "render/picture/sampling/sampled_render.h"

#include <functional>
#include <string>
#include <vector>

namespace study {

/// What a picture is made from, on its way through a setting.
struct Trial {
    scene::Description scene;
    plan::Options options;
    trace::SamplingGoal goal;                            ///< of many samples; all 0: as options.antialiasing says
    std::function<void(plan::CompiledScene&)> compiled;  ///< what is changed behind the plan; may be empty
    bool denoise = false;                                ///< of paths alone

    bool sampled() const { return goal.samples > 0 || goal.error > 0.0 || goal.seconds > 0.0; }
};

/// One rung: a setting of one kind.
struct Setting {
    std::string family;                 ///< "antialiasing, method 1", ...
    std::string name;                   ///< as one asks for it: "+A0.3 +AM1 +R3", "area_light 9, 9"
    std::function<void(Trial&)> apply;  ///< to the scene as it is given
    std::vector<std::string> switches;  ///< that ask POV-Ray for the same; empty: its text would have to change
    double asked_error = 0.0;           ///< levels of 255 that it promises; 0: none
    double asked_seconds = 0.0;         ///< that it is to take; 0: none
    bool newer = false;                 ///< POV-Ray 3.8's alone
};

/// The settings that a scene has a use for; those of an effect that it lacks are left out.
/// \param compiled  the scene as given
/// \param rays  of its picture
/// \param paths  those of the path tracer too
std::vector<Setting> ladder(const scene::Description& scene, const plan::CompiledScene& compiled,
                            const trace::RayCounts& rays, bool paths = false);

/// The scene as what it describes: many samples, depth without end that matters, all else as given; or by paths.
void make_truth(Trial& trial, double error, double seconds, bool paths = false);

}  // namespace study
