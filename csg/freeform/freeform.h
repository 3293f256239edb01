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

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <variant>

namespace csg {

class ShapeMadeLater;

/// Shapes that answer through one call each: their own work outweighs it, and they stay out of what is inlined into
/// every query. Each lives in its own space. A new one is a file in freeform/, a name in this list and its grammar.
struct FreeformShape {
    std::variant<BicubicPatch, Blob, ConicPrism, HeightField, Isosurface, Julia, Lathe, Ovus, Parametric, Polygon, Sor,
                 SphereSweep, Superellipsoid>
        kind;
    /// Of a description, which may be copied often or never be drawn: `kind` tells only what it was described by.
    std::shared_ptr<ShapeMadeLater> later = nullptr;

    /// Box that POV-Ray tells of the shape, moved: around the shape's bounds or what it has as extent().
    Aabb extent(const Transform& moved) const;
};

template <class T, class... Args>
std::shared_ptr<const FreeformShape> make_freeform(Args&&... args)
{
    return std::make_shared<const FreeformShape>(FreeformShape{T(std::forward<Args>(args)...)});
}

/// What a description stands for, made by the first that asks.
class ShapeMadeLater {
public:
    explicit ShapeMadeLater(std::function<std::shared_ptr<const FreeformShape>()> make) : make_(std::move(make)) {}

    std::shared_ptr<const FreeformShape> shape()
    {
        std::call_once(once_, [this] {
            shape_ = make_();
            make_ = nullptr;  // with what it kept
        });
        return shape_;
    }

private:
    std::function<std::shared_ptr<const FreeformShape>()> make_;
    std::once_flag once_;
    std::shared_ptr<const FreeformShape> shape_;
};

/// A description of what `make` makes; `described` is all that can be asked before.
template <class T, class F>
std::shared_ptr<const FreeformShape> make_freeform_later(T described, F make)
{
    auto later = std::make_shared<ShapeMadeLater>([make = std::move(make)] { return make_freeform<T>(make()); });
    return std::make_shared<const FreeformShape>(FreeformShape{std::move(described), std::move(later)});
}

/// The shape itself, or what it describes.
inline std::shared_ptr<const FreeformShape> drawn_shape(const std::shared_ptr<const FreeformShape>& shape)
{
    return shape->later ? shape->later->shape() : shape;
}

}  // namespace csg
