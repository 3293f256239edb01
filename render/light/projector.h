#pragma once

namespace csg {
class World;
}

namespace light {

/// What a light is projected through: only points that see it in front of the light are lit. Asked from many threads.
struct Projector {
    virtual ~Projector() = default;
    /// The object by itself.
    virtual csg::World world() const = 0;
};

}  // namespace light
