#pragma once

#include "csg/freeform/revolution/spindle_torus.h"
#include "csg/solids/solid.h"
#include "render/scene/object.h"

namespace plan {

/// Whether it is a solid of its own, csg::SpindleTorus, and which.
bool has_spindle(const scene::Torus& torus);
csg::SpindleTorus spindle_torus(const scene::Torus& torus);

/// A described primitive in world space. Not for meshes, CSG and lights. on_surface: something asks for coordinates on
/// its surface, so that a sphere has to know how it was turned. sides_by_order: which side of a triangle is which goes
/// by the order of its corners alone, as POV-Ray 3.8 has it. by: whose last bits its frame has.
csg::Solid world_solid(const scene::Shape& shape, const csg::Transform& to_world, bool on_surface = false,
                       bool sides_by_order = false, csg::Roundings by = csg::Roundings::Own);

}  // namespace plan
