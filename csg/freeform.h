#pragma once

#include "csg/freeform/bicubic_patch.h"
#include "csg/freeform/blob.h"
#include "csg/freeform/conic_prism.h"
#include "csg/freeform/height_field.h"
#include "csg/freeform/isosurface.h"
#include "csg/freeform/julia.h"
#include "csg/freeform/lathe.h"
#include "csg/freeform/ovus.h"
#include "csg/freeform/parametric.h"
#include "csg/freeform/polygon.h"
#include "csg/freeform/sor.h"
#include "csg/freeform/sphere_sweep.h"
#include "csg/freeform/superellipsoid.h"

#include <memory>
#include <utility>
#include <variant>

namespace csg {

/// Shapes that answer through one call each: their own work outweighs it, and they stay out of what is inlined into every
/// query. Each lives in its own space. A new one is a file in freeform/, a name in this list and its grammar.
struct FreeformShape {
    std::variant<BicubicPatch, Blob, ConicPrism, HeightField, Isosurface, Julia, Lathe, Ovus, Parametric, Polygon, Sor, SphereSweep, Superellipsoid> kind;

    /// Box that POV-Ray tells of the shape, moved: around the shape's bounds or what it has as extent().
    Aabb extent(const Transform& moved) const;
};

template <class T, class... Args>
std::shared_ptr<const FreeformShape> make_freeform(Args&&... args)
{
    return std::make_shared<const FreeformShape>(FreeformShape{T(std::forward<Args>(args)...)});
}

}  // namespace csg
