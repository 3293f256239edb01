#pragma once

#include "render/app/run/cancellation.h"
#include "render/scene/description.h"
#include "render/scene/object.h"
#include "render/solid/mesh/refinement.h"

#include <array>
#include <chrono>
#include <string>
#include <vector>

/// What files of parts have in common.
namespace app {

/// The colour of the first plain pigment that is found in an object, sRGB from 0 to 1; the scene's numbers are taken as
/// linear light. False: there is none.
bool color_of(const scene::Object& object, std::array<double, 3>& out);

/// The colours at points of an object whose first pigment is a pattern, alike; empty where it is none.
std::vector<std::array<double, 3>> colors_at(const scene::Object& object, const scene::Description& description,
                                             const std::vector<glm::vec3>& points);

using PartClock = std::chrono::steady_clock;

/// Options with which nothing is refined later than `seconds` after `start`, or once the run is cancelled.
solid::RefineOptions refine_options(double tolerance, int cells, PartClock::time_point start, double seconds,
                                    const Cancellation& cancel);

/// Warns that a part is `worst` off, and why.
void tell_too_far(const std::string& part, const char* what, double worst, double tolerance,
                  const solid::RefineFacts& facts);

}  // namespace app
