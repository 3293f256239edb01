#pragma once

#include "render/scene/object.h"

namespace plan {

/// The box that min_extent() and max_extent() tell of an object, by POV-Ray's rules (spec 5a, 7): not the tightest one;
/// unbounded sides lie at +-1e10, and single precision shows.
csg::Aabb described_extent(const scene::Object& object);

/// Whether an operand or a clip is turned inside out, so that it does not bound what it is part of. Patches, polygons
/// and the julia fractals of 3.7 never count as turned, whether `inverse` or subtracted; meshes do (spec 5a, 7.3).
bool box_turned(const scene::Object& operand, bool subtracted = false);

/// Whether an object's box has its lower corner above its upper one: a sphere of negative radius, until it is stretched
/// (spec 5a, 5.1).
bool box_inside_out(const scene::Object& object);

/// described_extent() of an object that stands in the space `parent`. `growth`: of boxes turned into the world from
/// there.
csg::Aabb placed_extent(const scene::Object& object, const csg::Transform& parent, const scene::BoxGrowth& growth);

/// Whether POV-Ray found a box for the quadric that an object is, if only an endless one: then it drops its bounds
/// (spec 5a, 9.2).
bool finds_quadric_box(const scene::Object& object, const scene::Quadric& quadric);

}  // namespace plan
