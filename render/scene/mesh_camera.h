#pragma once

#include "render/scene/base/dump_writer.h"
#include "render/scene/base/source_ref.h"

#include <memory>
#include <vector>

namespace scene {

/// A camera whose rays leave the faces of meshes (reference manual: Mesh Camera; spec 2, 5).
struct MeshCamera {
    /// Which face a pixel shows: its number in one mesh for each ray, in all of them one after the other, in meshes
    /// side by side, or the face at its place in texture coordinates.
    enum class Distribution : std::uint8_t { MeshPerRay, AllInOne, SideBySide, ByUv };
    struct Member {
        std::shared_ptr<const Object> object;  ///< its shape is a Mesh
        std::string_view keyword;              ///< mesh or mesh2
    };

    int rays_per_pixel = 1;
    Distribution distribution = Distribution::MeshPerRay;
    double max_distance = 0.0;   ///< scene units, what is farther is sky; 0: no limit
    std::vector<Member> meshes;  ///< one at least
    bool smooth = false;         ///< ByUv: along the normals of vertices
    SourceRef source;

    void dump(DumpWriter& out) const;
};

}  // namespace scene
