#pragma once

#include "render/scene/solids/bicubic_patch.h"
#include "render/scene/solids/blob.h"
#include "render/scene/solids/height_field.h"
#include "render/scene/solids/isosurface.h"
#include "render/scene/solids/julia_fractal.h"
#include "render/scene/solids/lathe.h"
#include "render/scene/solids/lemon.h"
#include "render/scene/solids/ovus.h"
#include "render/scene/solids/parametric.h"
#include "render/scene/solids/polygon.h"
#include "render/scene/solids/polynomial_surface.h"
#include "render/scene/solids/prism.h"
#include "render/scene/solids/sor.h"
#include "render/scene/solids/sphere_sweep.h"
#include "render/scene/solids/superellipsoid.h"
#include "render/scene/solids/text.h"
#include "render/scene/base/source_ref.h"

#include <concepts>
#include <iterator>
#include <variant>

/// Parameters of the solids that are drawn by shapes of their own: as the author gave them, defaults filled in.
namespace scene {

/// What the parameters of a solid must have: the keywords that begin it, and lines of a dump.
template <class T>
concept SolidParameters = std::default_initializable<T> && requires(const T& parameters, DumpWriter& out)
{
    {
        *std::begin(T::kKeywords)
        } -> std::convertible_to<std::string_view>;
    parameters.dump(out);
};

// What they may have beside that, each a `static constexpr bool`.
template <class T>
concept TakesSturm = T::kTakesSturm;  ///< `sturm` may stand among the modifiers
template <class T>
concept TakesHierarchy = T::kTakesHierarchy;  ///< `hierarchy` may
template <class T>
concept ForgetsInverse = T::kForgetsInverse;  ///< that it is inverted, at the end of its block and where it is moved

/// A variant of what meets the concept: the compiler names the solid that does not.
template <SolidParameters... Solids>
using SolidList = std::variant<Solids...>;

/// Every solid of the kind, in the order of their names: a new one is a line here and the #include of its file. Its
/// grammar is parser/grammar/core/solid_reader.h's read_solid(); docs/extending.md shows one from end to end.
using AnySolid = SolidList<BicubicPatch, Blob, HeightField, Isosurface, JuliaFractal, Lathe, Ovus, Parametric, Polygon,
                           PolynomialSurface, Prism, Sor, SphereSweep, Superellipsoid, Text, Lemon>;

/// A solid as it was given; Object::shape is what is drawn of it.
struct WrittenSolid {
    std::string_view keyword;  ///< one of kKeywords
    AnySolid parameters;
    SourceRef source;
};

}  // namespace scene
