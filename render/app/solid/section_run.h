#pragma once

#include "render/app/solid/bodies.h"
#include "render/solid/files/drawing.h"

namespace app {

struct SectionRequest {
    solid::CuttingPlane plane;
    std::vector<std::string> out;  ///< .svg, .dxf
    double tolerance = 0.01;       ///< scene units
    double seconds = 60.0;         ///< of an object
    bool json = false;
};

/// The plane that a text like "y,0.5" names. Throws OptionError.
solid::CuttingPlane cutting_plane(const std::string& text);

/// Draws what a plane cuts of a scene's objects, and prints what was found. Returns the exit status.
int draw_section(const BodyRequest& bodies, const SectionRequest& request, Cancellation& cancel);

}  // namespace app
