#pragma once

#include "csg/base/types.h"

namespace light {

/// What a light is projected through: only points that see it in front of the light are lit. Asked from many threads.
struct Projector {
    virtual ~Projector() = default;
    /// Where the ray meets the object first, at a depth of at least 1e-4; negative: nowhere.
    virtual double depth(const csg::Ray& ray) const = 0;
};

}  // namespace light
