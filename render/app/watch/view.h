#pragma once

#include "render/app/watch/place/number_edits.h"
#include "render/scene/description.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace app {

/// What a page changes of a scene without its text.
struct View {
    /// About the point in the middle of the picture, from the scene's own camera.
    struct Orbit {
        double yaw_deg = 0, pitch_deg = 0;
        double dolly = 1;          ///< factor of the distance
        double right = 0, up = 0;  ///< shares of the picture by which it is moved
        bool still() const { return yaw_deg == 0 && pitch_deg == 0 && dolly == 1 && right == 0 && up == 0; }
        bool operator==(const Orbit&) const = default;
    };
    /// Points with dot(normal, p) > offset are taken away.
    struct Cut {
        glm::dvec3 normal{0, 0, -1};
        double offset = 0;
        bool operator==(const Cut&) const = default;
    };
    std::optional<double> clock;
    std::map<std::string, double> declared;
    std::map<std::string, NumberEdits> numbers;  ///< by file, absolute without "." and ".."
    Orbit orbit;
    std::optional<Cut> cut;
    std::uint64_t request = 0;  ///< the page's number of its last change, told with the picture

    bool same_text(const View& other) const
    {
        return clock == other.clock && declared == other.declared && numbers == other.numbers;
    }
};

/// The camera moved.
/// \param distance  from the eye to what it turns about
scene::Camera moved(const scene::Camera& camera, const View::Orbit& orbit, double distance);

/// A `camera` block that says the same; what it cannot say (a mesh, a normal, a bokeh) is named in a comment.
std::string camera_text(const scene::Camera& camera);

/// Every solid of the scene without what lies beyond the plane. Surfaces without an inside are left out of what is cut:
/// a copy that is clipped by it.
void cut_open(scene::Description& description, const View::Cut& cut);

}  // namespace app
