#pragma once

#include "numbers/functions/functions.h"
#include "numbers/functions/lane_functions.h"

#include <numbers>

/// How much of a pigment a metallic finish gives to what it mirrors (7.8). V is double or lanes::Double.
namespace texture {

/// W of 7.8: 0 head-on, 1 at grazing angles; `cosine` of the angle to the normal.
template <class V>
inline V grazing_weight(const V& cosine)
{
    using numbers::lanes::choose;
    const V none(0.0), full(1.0), least(-1.0);
    const V x = numbers::acos(choose(cosine < least, least, cosine)) / V(std::numbers::pi / 2.0), q = x - V(1.12);
    const V weight = V(0.014567225) / (q * q) - V(0.011612903);
    return choose(cosine >= full, none, choose(weight < none, none, choose(full < weight, full, weight)));
}

/// What the tint's distance from white is multiplied by; `metallic` of the finish.
template <class V>
inline V metallic_share(const V& metallic, const V& cosine)
{
    return metallic * (V(1.0) - grazing_weight(cosine));
}

}  // namespace texture
