#pragma once

#include "parser/stream/values/value.h"

#include <cstddef>

namespace parser {

/// Added to subscripts and sizes before they are cut to an integer: 0.9999999999999 means 1 (spec 1, 11).
inline constexpr double kSubscriptSlack = 1e-10;

inline constexpr std::size_t kNoElement = ~std::size_t{0};

/// Where the element of these subscripts stands; kNoElement: one is outside, or there are more or fewer of them than
/// the array has dimensions.
inline std::size_t element_index(const Array& array, const double* subscripts, std::size_t count)
{
    if (array.sizes.size() != count) return kNoElement;
    std::size_t index = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double at = subscripts[i] + kSubscriptSlack;
        if (!(at >= 0.0 && at < array.sizes[i])) return kNoElement;
        index = index * array.sizes[i] + static_cast<std::size_t>(at);
    }
    return index;
}

/// dimension_size(): 0 where there is no such dimension.
inline double size_of_dimension(const Array& array, double which)
{
    return which >= 1.0 && which < static_cast<double>(array.sizes.size()) + 1.0
               ? array.sizes[static_cast<std::size_t>(which) - 1]
               : 0.0;
}

}  // namespace parser
