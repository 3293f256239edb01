#pragma once

#include "function/program.h"
#include "render/scene/base/dump_writer.h"

#include <array>

namespace scene {

/// `user_defined` of a pigment or density: a colour of functions of x, y, z (spec 7b, 2).
struct ColorFunctions {
    std::array<function::FunctionPtr, 5> parts;  ///< red, green, blue, filter, transmit; null: 0 everywhere

    bool clear() const { return parts[3] || parts[4]; }  ///< light may pass
    void dump(DumpWriter& out) const
    {
        for (const function::FunctionPtr& part : parts)
            if (part) out.steps(part);
            else out.word("-");
    }
};

}  // namespace scene
