#pragma once

#include "csg/solids/solid.h"

#include <array>
#include <type_traits>
#include <utility>

/// Solids of which a ray that begins on them meets no more, whatever their shape.
namespace csg {

template <class T>
inline constexpr bool kMetOnce = std::is_same_v<T, Plane> || std::is_same_v<T, Disc> || std::is_same_v<T, Triangle>;
template <class T>
inline constexpr bool kConvex = std::is_same_v<T, Sphere> || std::is_same_v<T, Ellipsoid> || std::is_same_v<T, Box> ||
                                std::is_same_v<T, OrientedBox> || std::is_same_v<T, Cylinder>;

/// inward: it goes into the solid
template <class T>
constexpr bool leaves_for_good(bool inward)
{
    return kMetOnce<T> || (kConvex<T> && !inward);
}

/// The same of a kind of solid: bit 0 for rays that go out, bit 1 for those that go in.
inline std::uint32_t leaving_ways(SolidKind kind)
{
    static constexpr auto kTable = []<std::size_t... i>(std::index_sequence<i...>)
    {
        return std::array{(leaves_for_good<std::variant_alternative_t<i, Solid>>(false) ? 1u : 0u) +
                          (leaves_for_good<std::variant_alternative_t<i, Solid>>(true) ? 2u : 0u)...};
    }
    (std::make_index_sequence<kSolidKinds>());
    return kTable[static_cast<std::size_t>(kind)];
}

}  // namespace csg
