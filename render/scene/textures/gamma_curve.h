#pragma once

#include "render/image/levels/transfer_curve.h"

#include <cstdint>
#include <string_view>

namespace scene {

/// A curve of levels as written, a picture's `gamma` or the scene's assumed_gamma: a number, srgb, bt709 or bt2020
/// (spec 2, 10.1; spec 7b, 8).
struct GammaCurve {
    enum class Kind : std::uint8_t { Power, Srgb, Bt709, Bt2020 } kind = Kind::Power;
    double exponent = 1.0;  ///< Power only

    static constexpr std::string_view kNames[] = {"power", "srgb", "bt709", "bt2020"};
    std::string_view name() const { return kNames[static_cast<int>(kind)]; }
    image::TransferCurve curve() const
    {
        switch (kind) {
        case Kind::Srgb: return image::TransferCurve::srgb();
        case Kind::Bt709: return image::TransferCurve::bt709();
        case Kind::Bt2020: return image::TransferCurve::bt2020();
        case Kind::Power: break;
        }
        return image::TransferCurve::power(static_cast<float>(exponent));
    }
};

}  // namespace scene
