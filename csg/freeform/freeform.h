#pragma once

#include "csg/freeform/surface/bicubic_patch.h"
#include "csg/freeform/field/blob.h"
#include "csg/freeform/sweep/conic_prism.h"
#include "csg/freeform/surface/height_field.h"
#include "csg/freeform/field/isosurface.h"
#include "csg/freeform/field/julia.h"
#include "csg/freeform/revolution/lathe.h"
#include "csg/freeform/revolution/ovus.h"
#include "csg/freeform/surface/parametric.h"
#include "csg/freeform/surface/polygon.h"
#include "csg/freeform/revolution/sor.h"
#include "csg/freeform/sweep/sphere_sweep.h"
#include "csg/freeform/surface/superellipsoid.h"

#include <memory>
#include <utility>
#include <variant>

namespace csg {

/// Shapes that answer through one call each: their own work outweighs it, and they stay out of what is inlined into
/// every query. Each lives in its own space. A new one is a file in freeform/, a name in this list and its grammar.
struct FreeformShape {
    std::variant<BicubicPatch, Blob, ConicPrism, HeightField, Isosurface, Julia, Lathe, Ovus, Parametric, Polygon, Sor,
                 SphereSweep, Superellipsoid>
        kind;

    /// Box that POV-Ray tells of the shape, moved: around the shape's bounds or what it has as extent().
    Aabb extent(const Transform& moved) const;
};

template <class T, class... Args>
std::shared_ptr<const FreeformShape> make_freeform(Args&&... args)
{
    return std::make_shared<const FreeformShape>(FreeformShape{T(std::forward<Args>(args)...)});
}

}  // namespace csg
