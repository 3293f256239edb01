#pragma once

#include "csg/tree/program.h"
#include "render/scene/object.h"

#include <cstdint>
#include <optional>
#include <vector>

/// Operands of unions and merges that some kinds of rays go past, though they see the object (spec 3, 14; 5a, 10.2).
namespace plan {

/// A union without shadow has flags of its own, or nothing but operands without shadow.
bool shadowless(const scene::Object& object);

/// Kinds of rays (bit(RayKind)) that go past an operand because of its own flags. Those of differences and
/// intersections don't count, nor does `no_shadow`; `no_image` does in a merge alone.
std::uint8_t hidden_from(const scene::Object& operand, scene::CsgOp in);

/// Kinds of rays that see the same of a tree, in groups that make up all kinds; one group where nothing is hidden.
std::vector<std::uint8_t> views_of(const csg::Tree& tree);

/// What a kind of ray sees of a tree; nullopt: nothing. What is hidden still counts where the others of an intersection
/// or difference ask what they are inside of: those become what is drawn of each operand, clipped by the others.
std::optional<csg::Tree> seen_by(const csg::Tree& tree, std::uint8_t kind);

}  // namespace plan
