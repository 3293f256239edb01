#pragma once

#include "render/kernel/queue/ray_queue.h"
#include "render/kernel/tile/air.h"
#include "render/kernel/tile/geometry.h"
#include "render/texture/texture_set.h"

#include <cstdint>
#include <vector>

/// What the stages did to the rays of a sample (docs/tools/explain.md). Colours have numbers, ColorSlots of the
/// record's own.
namespace trace {

/// What stood between a hit and a lamp.
struct RecordedShadow {
    int asked = 0, blocked = 0, filtered = 0;  ///< shadow rays, those that ended and those that something dimmed
    std::uint32_t surface = csg::kNoSurface;   ///< of what the first of them met; none: that is not known
    double distance = 0;                       ///< to it, from the hit
};

/// A lamp that a hit asked.
struct RecordedLamp {
    std::uint32_t number;  ///< in CompiledScene::lights
    glm::dvec3 direction;
    glm::vec3 color;  ///< before shadows
    RecordedShadow shadow;
};

/// What one source of light gave to a layer. Exact: in order they sum up to what the row had.
struct RecordedGain {
    enum Source : std::int32_t { Below = -3, Photons = -2, Surroundings = -1 };  ///< or the number of a lamp
    std::int32_t source;
    glm::dvec3 sum;
    glm::dvec3 diffuse;  ///< of a lamp; the rest of the sum is highlights
};

/// A layer of a texture at a hit.
struct RecordedRow {
    scene::Color pigment;
    float own;  ///< share of it that is its own colour
    glm::dvec3 normal;
    const texture::Finish* finish;
    glm::vec3 filter, glow;  ///< what the layers above let through; ambient light and emission
    std::vector<RecordedGain> gains;
};

/// The air of a ray, when one more of its effects has been found.
struct RecordedAir {
    enum class Effect : std::uint8_t { InteriorMedia, Rainbows, Media, Fog };
    Effect effect;
    Air so_far;
};

/// A texture of several: colour `slot` is that of child `entry` of a texture map (TextureSet::children), of a part of a
/// blob, or of a corner of a mesh's face.
struct RecordedEntry {
    ColorSlot slot;
    std::uint32_t entry;
    bool of_map;
};

struct RecordedRay {
    ColorSlot slot;  ///< of its colour
    int level;       ///< levels in use with it
    RayState state;
    Hit met;
    glm::dvec3 point{0}, normal{0};  ///< of the surface, toward the viewer
    bool from_inside = false;
    bool ends = false;             ///< its colour is `seen` or that of its rows, without a node
    scene::Color seen{};           ///< the sky; black where it met what has no texture, or an ink line
    std::vector<RecordedAir> air;  ///< the last one has all of it
    std::vector<RecordedLamp> lamps;
    std::vector<RecordedRow> rows;
};

/// Whose a node is: rows `first` to `last` of a ray are its own light.
struct RecordedOwner {
    std::uint32_t ray, first, last;
};

struct Record {
    std::vector<RecordedRay> rays;       ///< in the order in which they were traced; tiles one behind the other
    std::vector<ShadeNode> nodes;        ///< as RayQueue has them
    std::vector<ShadeTerm> terms;        ///< the same
    std::vector<RecordedOwner> owners;   ///< by node
    std::vector<RecordedEntry> entries;  ///< of maps within maps the outer one first
    std::vector<ColorSlot> camera;       ///< colours of the camera's rays
    int without_ray = 0;                 ///< samples of a lens that have none and count as black
    ColorSlot slots = 0;                 ///< how many there are
};

}  // namespace trace
