#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace plan {

/// A step that leaves out what the picture does not show. Each can be switched off; no byte of a picture changes
/// (docs/lean.md).
enum class LeanStep : std::uint8_t {
    Operands,      ///< operands of CSG that cannot matter
    EmptyObjects,  ///< objects whose operands leave nothing to draw
    Bounds,        ///< bounded_by that holds all of its object
    BlackLights,   ///< lights without colour
    UnseenLights,  ///< lights that nothing receives
    ClearAir,      ///< what dims light in the air, where nothing does
    BlackMedia,    ///< media that neither glow nor dim
    Photons,       ///< photons without a target
    HitDetails,    ///< what no texture looks at about a hit
    Interiors,     ///< groups of lights, fading and media inside of objects, where there are none
    ClearSurfaces  ///< shading surfaces that let all light through as it is
};
inline constexpr std::size_t kLeanSteps = 11;

/// Which steps are taken: all as a rule.
class LeanSteps {
public:
    bool takes(LeanStep step) const { return (off_ >> static_cast<unsigned>(step) & 1u) == 0; }
    void switch_off(LeanStep step) { off_ |= 1u << static_cast<unsigned>(step); }
    static LeanSteps none()
    {
        LeanSteps steps;
        for (std::size_t i = 0; i < kLeanSteps; ++i) steps.switch_off(static_cast<LeanStep>(i));
        return steps;
    }

private:
    std::uint32_t off_ = 0;
};

/// What the step leaves out, for texts.
constexpr std::string_view name_of(LeanStep step)
{
    switch (step) {
    case LeanStep::Operands: return "operands that cannot matter";
    case LeanStep::EmptyObjects: return "objects with nothing to draw";
    case LeanStep::Bounds: return "bounded_by that holds its object";
    case LeanStep::BlackLights: return "black lights";
    case LeanStep::UnseenLights: return "lights that nothing receives";
    case LeanStep::ClearAir: return "fog and media in the air, for shadows";
    case LeanStep::BlackMedia: return "media that neither glow nor dim";
    case LeanStep::Photons: return "photons without a target";
    case LeanStep::HitDetails: return "directions and coordinates about hits";
    case LeanStep::Interiors: return "light groups, fading and media inside of objects";
    case LeanStep::ClearSurfaces: return "the shading of surfaces that let all light through";
    }
    return {};
}

}  // namespace plan
