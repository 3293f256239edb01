#pragma once

#include "function/program.h"
#include "render/scene/base/dump_writer.h"

#include <array>

namespace scene {

/// What functions of the place in the picture say of each ray of a camera (POV-Ray 3.8: user_defined): x from -0.5 at
/// the left to 0.5 at the right, y from below to above. World, moved by no transformation; a direction of any length.
struct UserCamera {
    std::array<function::FunctionPtr, 3> location, direction;  ///< null: the camera's vector is used

    void dump(DumpWriter& out) const
    {
        for (const auto& [name, functions] : {std::pair{"location", &location}, {"direction", &direction}})
            for (const function::FunctionPtr& one : *functions)
                if (one) out.steps(name, one);
    }
};

}  // namespace scene
