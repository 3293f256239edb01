#pragma once

#include "csg/freeform/freeform.h"
#include "csg/base/hit.h"
#include "csg/items/world_data.h"

/// Depths at which POV-Ray's solids tell of crossings (spec 5a, 2.3; measured for every kind, docs/faithful.md). Here
/// they tell of all, unless WorldData::faithful asks for POV-Ray's.
namespace csg {

struct DepthRange {
    double from = 0.0;  ///< nearer crossings are not told; distances from the ray's start, in the world
    double to = 2e10;   ///< nor are farther ones: half of the size that POV-Ray gives to what has no end
    static constexpr double kFar = 1e7;  ///< `to` of many kinds

    bool holds(double t) const { return t >= from && t <= to; }
};

inline DepthRange depth_range_of(const SolidStore& store, PartId part)
{
    switch (kind_of(part)) {
    case SolidKind::Sphere:
    case SolidKind::Plane:
    case SolidKind::Torus:
    case SolidKind::Quadric:
    case SolidKind::Disc:
    case SolidKind::Triangle:
    case SolidKind::Extrusion: return {.to = DepthRange::kFar};
    case SolidKind::Freeform: {
        constexpr double kBlob = 0.01;
        const auto& kind = store.all<Freeform>()[index_of(part)].shape->kind;
        if (std::holds_alternative<Blob>(kind)) return {kBlob, DepthRange::kFar};
        if (std::holds_alternative<ConicPrism>(kind) || std::holds_alternative<Lathe>(kind) ||
            std::holds_alternative<Sor>(kind) || std::holds_alternative<SphereSweep>(kind) ||
            std::holds_alternative<Superellipsoid>(kind))
            return {.to = DepthRange::kFar};
        return {};
    }
    // Limits of the others are in lengths of their own space or of the largest box: a thing so small beside its
    // distance is not seen.
    case SolidKind::Ellipsoid:
    case SolidKind::Box:
    case SolidKind::OrientedBox:
    case SolidKind::Cylinder:
    case SolidKind::Cone:
    case SolidKind::Mesh:
    case SolidKind::Polynomial: break;
    }
    return {};
}

inline DepthRange depth_range_of(const WorldData& world, const Hit& hit)
{
    const WorldData& of = hit.instance == Hit::kNoInstance ? world : *world.instances[hit.instance].world;
    return depth_range_of(of.store, hit.part);
}

}  // namespace csg
