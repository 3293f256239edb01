#pragma once

#include "csg/freeform/surface/bicubic_patch.h"
#include "csg/freeform/field/blob.h"
#include "csg/freeform/sweep/conic_prism.h"
#include "csg/freeform/surface/height_field.h"
#include "csg/freeform/field/isosurface.h"
#include "csg/freeform/field/julia.h"
#include "csg/freeform/revolution/lathe.h"
#include "csg/freeform/revolution/lemon.h"
#include "csg/freeform/revolution/ovus.h"
#include "csg/freeform/surface/parametric.h"
#include "csg/freeform/surface/polygon.h"
#include "csg/freeform/revolution/sor.h"
#include "csg/freeform/revolution/spindle_torus.h"
#include "csg/freeform/sweep/sphere_sweep.h"
#include "csg/freeform/surface/superellipsoid.h"

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <variant>

namespace csg {

class ShapeMadeLater;

/// A shape that a query reaches through a function call. Its own work outweighs the call, and its code is not inlined
/// into every query. Each shape lives in its own space. A new one is a file in freeform/, a name in this list and its
/// grammar (README.md).
struct FreeformShape {
    template <class T>
    explicit FreeformShape(T shape, std::shared_ptr<ShapeMadeLater> made_later = nullptr)
        : kind(std::in_place_type<T>, std::move(shape)), later(std::move(made_later))
    {}
    ~FreeformShape();
    FreeformShape(const FreeformShape&) = delete;
    FreeformShape& operator=(const FreeformShape&) = delete;

    std::variant<BicubicPatch, Blob, ConicPrism, HeightField, Isosurface, Julia, Lathe, Lemon, Ovus, Parametric,
                 Polygon, Sor, SphereSweep, SpindleTorus, Superellipsoid>
        kind;
    /// Set for a shape that is costly to make: a description may be copied often, or never be drawn. `kind` then holds
    /// only what the shape was described by.
    std::shared_ptr<ShapeMadeLater> later;

    /// The box that POV-Ray's min_extent() and max_extent() tell of the shape under a transformation: the shape's own
    /// extent() if it has one, else the box around its bounds.
    Aabb extent(const Transform& moved) const;
};

template <class T, class... Args>
std::shared_ptr<const FreeformShape> make_freeform(Args&&... args)
{
    return std::make_shared<const FreeformShape>(T(std::forward<Args>(args)...));
}

/// Makes a shape when it is first asked for; from any thread.
class ShapeMadeLater {
public:
    explicit ShapeMadeLater(std::function<std::shared_ptr<const FreeformShape>()> make) : make_(std::move(make)) {}

    std::shared_ptr<const FreeformShape> shape()
    {
        std::call_once(once_, [this] {
            shape_ = make_();
            make_ = nullptr;  // frees what it captured
        });
        return shape_;
    }

private:
    std::function<std::shared_ptr<const FreeformShape>()> make_;
    std::once_flag once_;
    std::shared_ptr<const FreeformShape> shape_;
};

/// A shape that `make` returns when it is first needed. Until then only `described` can be asked.
template <class T, class F>
std::shared_ptr<const FreeformShape> make_freeform_later(T described, F make)
{
    auto later = std::make_shared<ShapeMadeLater>([make = std::move(make)] { return make_freeform<T>(make()); });
    return std::make_shared<const FreeformShape>(std::move(described), std::move(later));
}

/// The shape to draw: made now if it was only described so far.
inline std::shared_ptr<const FreeformShape> drawn_shape(const std::shared_ptr<const FreeformShape>& shape)
{
    return shape->later ? shape->later->shape() : shape;
}

}  // namespace csg
