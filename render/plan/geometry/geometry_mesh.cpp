#include "render/plan/geometry/geometry.h"

#include <tuple>

namespace plan {
namespace {

/// POV-Ray takes shorter inside vectors for absent (spec 5b, 3.6).
constexpr double kShortest = 1e-10;

}  // namespace

bool mesh_is_solid(const scene::MeshData& mesh)
{
    const glm::dvec3 v = glm::abs(mesh.inside_vector);
    return mesh.has_inside_vector && (v.x >= kShortest || v.y >= kShortest || v.z >= kShortest);
}

/// The mesh in its own space, made once for all that show it.
const GeometryCompiler::SharedMesh& GeometryCompiler::shared_mesh(const std::shared_ptr<const scene::MeshData>& mesh)
{
    const auto [known, fresh] = meshes_.try_emplace(mesh.get());
    SharedMesh& shared = known->second;
    if (!fresh) return shared;
    shared.source = mesh;
    csg::MeshInput input{mesh->vertices, mesh->normals, mesh->uvs, {}, mesh_is_solid(*mesh)};
    input.faces.reserve(mesh->faces.size());
    // Faces name textures by place in a list that may hold one texture many times.
    using Corners = std::array<const scene::Texture*, 3>;
    std::map<Corners, std::uint32_t> slots;
    auto last = slots.end();
    for (const scene::MeshData::Face& face : mesh->faces) {
        std::array<scene::TexturePtr, 3> textures;
        for (std::size_t k = 0; k < 3; ++k)
            if (face.texture[k] != scene::MeshData::kNone) textures[k] = mesh->textures[face.texture[k]];
        const Corners key{textures[0].get(), textures[1].get(), textures[2].get()};
        if (slots.empty() || last->first != key) {  // neighbours mostly look alike
            bool is_new = false;
            std::tie(last, is_new) = slots.try_emplace(key, static_cast<std::uint32_t>(slots.size()));
            if (is_new) shared.slots.push_back(textures);
        }
        input.faces.push_back({face.vertex, face.normal, face.uv, last->second});
    }
    shared.shape = std::make_shared<csg::MeshShape>(input);
    return shared;
}

/// textures_stay: the mesh itself has uv_mapping; that of a union or its like around it comes too late (spec 5b, 3.5).
csg::PartId GeometryCompiler::mesh_part(const scene::Mesh& mesh, const Inherited& own, bool textures_stay)
{
    const SharedMesh& shared = shared_mesh(mesh.data);
    csg::Mesh made;
    made.shape = shared.shape;
    made.frame = own.to_world;
    if (mesh_is_solid(*mesh.data)) made.inside_vector = mesh.data->inside_vector;
    if (sharing_ != nullptr && own.uv_mapping && !textures_stay) sharing_->fails = true;  // copies move them on
    const auto in_world = [&](const scene::TexturePtr& texture) {
        return texture && !textures_stay && !clipping_ ? moved(texture, own.to_world) : PlacedTexture{texture};
    };
    std::vector<std::array<PlacedTexture, 3>> slots;
    for (const auto& [first, second, third] : shared.slots)
        slots.push_back({in_world(first), in_world(second), in_world(third)});
    Inherited faces = own;
    faces.opaque_outside = opaque_outside(slots, own);
    for (const auto& corners : slots) {
        made.blends = made.blends || corners[0] != corners[1] || corners[0] != corners[2];
        made.surfaces.push_back(clipping_ ? csg::kNoSurface : mesh_surface(corners, faces));
    }
    return world_->store.add(made, made.surfaces.empty() ? csg::kNoSurface : made.surfaces.front());
}

/// Whether a mesh with the textures of its faces, or a blob, is opaque, so that its `interior_texture` lets no light
/// through (spec 3, 13.2).
bool GeometryCompiler::opaque_outside(const std::vector<std::array<PlacedTexture, 3>>& slots, const Inherited& own)
{
    if (!own.interior_texture || clipping_) return false;  // nothing would change
    if (sharing_ != nullptr) {                             // copies may have other textures
        sharing_->fails = true;
        return false;
    }
    const auto opaque = [&](const PlacedTexture& texture) {
        const std::uint32_t known = textures_.texture(texture);
        return known == kNone || out_.textures.textures[known].stops_light;
    };
    if (!opaque(own.texture ? own.texture : default_texture_)) return false;
    for (const auto& corners : slots)
        for (const PlacedTexture& texture : corners)
            if (texture && !opaque(texture)) return false;
    return true;
}

csg::SurfaceId GeometryCompiler::mesh_surface(const std::array<PlacedTexture, 3>& corners, const Inherited& own)
{
    std::array<Inherited, 3> of_corner{own, own, own};
    for (std::size_t k = 0; k < 3; ++k)
        if (corners[k]) of_corner[k].texture = corners[k];
    if (corners[0] == corners[1] && corners[0] == corners[2]) return surface(of_corner[0]);
    return surface(of_corner[0], {of_corner[1].texture, of_corner[2].texture});
}

}  // namespace plan
