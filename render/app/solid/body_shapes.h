#pragma once

#include "render/solid/measure/body.h"
#include "render/solid/mesh/deviation.h"
#include "render/solid/mesh/mesher.h"
#include "render/solid/mesh/triangle_mesh.h"
#include "render/solid/section/contour.h"
#include "render/solid/section/section_check.h"

#include <vector>

/// A body's mesh and its section as they leave the program, by whichever door: refined until they are looked at and
/// found near enough.
namespace app {

constexpr int kMostCells = 128, kMostCutCells = 1024;  ///< of a lattice along the longest side

struct BodyMesh {
    solid::TriangleMesh mesh;
    solid::MeshFacts facts;
    solid::Deviation off;
    int cells = 0;  ///< of the lattice at last

    double worst() const;  ///< off, either way; scene units
};

/// \param extent  of the body
/// \param options  with the cells of the first lattice, which grow where something narrow was overlooked
BodyMesh mesh_within(const solid::Body& body, const csg::Aabb& extent, solid::RefineOptions options);

struct BodySection {
    std::vector<solid::Loop> loops;
    solid::RefineFacts facts;
    solid::SectionCheck off;
    int cells = 0;  ///< of the lattice at last

    double worst() const;  ///< off, either way; scene units
};

/// \param plane  beside faces of the body that lie in it (solid::beside_faces)
BodySection section_within(const solid::Body& body, const csg::Aabb& extent, const solid::CuttingPlane& plane,
                           solid::RefineOptions options);

}  // namespace app
