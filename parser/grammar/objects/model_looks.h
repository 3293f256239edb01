#pragma once

#include "parser/grammar/objects/mesh_lists.h"
#include "render/model/base/model.h"

/// What a file says its faces look like, as textures of the mesh (docs/tools/meshes.md).
namespace parser {

/// Textures of the materials that their file tells of; kNone: of others. Reads the files that the model names, which
/// stand in `folder`.
std::vector<std::uint32_t> textures_told(MeshState& s, const scene::SourceRef& at, const std::string& path,
                                         model::Model& model);

/// Colours of corners become a texture of the mesh; faces from `first` on, which were made of the model's, show it.
void paint_corners(MeshState& s, const scene::SourceRef& at, const std::string& path, const model::Model& model,
                   std::size_t first);

/// Where all faces show one texture that their file tells, it is the object's: what the statement says further changes
/// it.
void settle_look(MeshState& s, scene::Object& object);

}  // namespace parser
