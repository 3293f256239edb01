#pragma once

#include "render/app/run/cancellation.h"
#include "render/scene/description.h"
#include "render/scene/object.h"
#include "render/solid/mesh/refinement.h"

#include <algorithm>
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

/// Makes a part again with twice as many cells, up to `most_cells`, until no place of the object is farther from it
/// than the tolerance: a coarse lattice may overlook something narrow. `make` is given the options, sets `facts`, and
/// returns how far the object is off the part.
template <class Facts, class Make>
void make_finer(solid::RefineOptions& options, int most_cells, Facts& facts, const Make& make)
{
    for (;; options.cells = std::min(2 * options.cells, most_cells)) {
        facts = {};
        const double off = make(options);
        if (off <= options.tolerance || facts.full || facts.late || options.cells >= most_cells) return;
    }
}

/// Warns that a part is `worst` off, and why.
void tell_too_far(const std::string& part, const char* what, double worst, double tolerance,
                  const solid::RefineFacts& facts);

}  // namespace app
