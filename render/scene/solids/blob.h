#pragma once

#include "render/scene/base/dump_writer.h"
#include "render/scene/textures/texture.h"

#include <cstdint>
#include <vector>

namespace scene {

/// Where the strengths of components add up to the threshold (reference manual: Blob).
struct Blob {
    static constexpr std::string_view kKeywords[] = {"blob"};
    static constexpr bool kTakesSturm = true, kTakesHierarchy = true;

    struct Component {
        /// Plain: `component`, the old way of writing a sphere, without modifiers.
        enum class Kind : std::uint8_t { Plain, Sphere, Cylinder } kind = Kind::Sphere;
        glm::dvec3 center{0.0}, end{0.0};  ///< end: of a cylinder's axis
        double radius = 1.0, strength = 1.0;
        Shared<csg::Transform> transform;  ///< to the blob's space
        TexturePtr texture;                ///< null: the blob's
    };

    double threshold = 1.0;
    std::vector<Component> components;

    void dump(DumpWriter& out) const;
};

}  // namespace scene
