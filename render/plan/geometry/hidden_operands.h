#pragma once

#include "csg/tree/program.h"
#include "render/scene/object.h"

#include <cstdint>
#include <optional>
#include <vector>

/// Operands of unions, merges and inverted intersections that some kinds of rays go past, though they see the object
/// (spec 3, 14; 5a, 10.2).
namespace plan {

/// An object without shadow has a flag of its own or is a union, not inverted, of nothing but operands without shadow.
bool shadowless(const scene::Object& object);

/// Flags of an operand, those that it has from what holds it included.
struct HidingFlags {
    bool no_image, no_reflection, no_radiosity;
};

/// Kinds of rays (bit(RayKind)) that go past an operand of a merge because of its flags. `no_shadow` doesn't count.
std::uint8_t hidden_from(const HidingFlags& flags);

/// Kinds of rays that see the same of a tree, in groups that make up all kinds; one group where nothing is hidden.
std::vector<std::uint8_t> views_of(const csg::Tree& tree);

/// What a kind of ray sees of a tree; nullopt: nothing. What is hidden still counts where the others of an intersection
/// or difference ask what they are inside of: those become what is drawn of each operand, clipped by the others.
std::optional<csg::Tree> seen_by(const csg::Tree& tree, std::uint8_t kind);

}  // namespace plan
