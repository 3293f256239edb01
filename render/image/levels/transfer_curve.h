#pragma once

#include "numbers/functions/functions.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace image {

/// ITU-R's curves: a straight piece of this slope up to `knee`, then scale * x^0.45 - (scale - 1).
struct TelevisionCurve {
    float knee, scale;
    static constexpr float kSlope = 4.5f, kExponent = 0.45f;
    float encode(float x) const { return x < knee ? x * kSlope : scale * numbers::pow(x, kExponent) - (scale - 1.0f); }
    float decode(float x) const
    {
        return x < knee * kSlope ? x / kSlope : numbers::pow((x + (scale - 1.0f)) / scale, 1.0f / kExponent);
    }
};
inline constexpr TelevisionCurve kBt709{0.018f, 1.099f}, kBt2020{0.018053968510807f, 1.09929682680944f};

/// How a light level is stored: `encode` maps linear light to the stored value, `decode` maps it back (spec 2, 10.2).
/// Single precision, as POV-Ray computes it; nothing is clamped above 1.
struct TransferCurve {
    enum class Kind { Linear, Power, Srgb, Bt709, Bt2020 };
    Kind kind = Kind::Linear;
    float gamma = 1.0f;  ///< Power only: the decoding exponent, stored^gamma is linear light

    static TransferCurve linear() { return {}; }
    static TransferCurve srgb() { return {Kind::Srgb, 2.2f}; }
    /// ITU-R BT.709-6 and BT.2020-2 (12 bits).
    static TransferCurve bt709() { return {Kind::Bt709, 1.9f}; }
    static TransferCurve bt2020() { return {Kind::Bt2020, 1.9f}; }
    /// Within 1 % of an exponent of 1 the curve is the identity, so that negative values survive, as in POV-Ray (spec
    /// 2, 10.2: File_Gamma 1.005 is the identity, 1.02 is not).
    static TransferCurve power(float decoding_gamma)
    {
        constexpr float kIdentityExponent = 0.01f;
        if (std::fabs(1.0f - 1.0f / decoding_gamma) <= kIdentityExponent) return linear();
        return {Kind::Power, decoding_gamma};
    }

    float encode(float linear) const
    {
        switch (kind) {
        case Kind::Linear: return linear;
        case Kind::Power: return numbers::pow(std::max(linear, 0.0f), 1.0f / gamma);
        case Kind::Bt709: return kBt709.encode(linear);
        case Kind::Bt2020: return kBt2020.encode(linear);
        case Kind::Srgb: break;
        }
        return linear <= 0.0031308f ? linear * 12.92f : 1.055f * numbers::pow(linear, 1.0f / 2.4f) - 0.055f;
    }
    float decode(float stored) const
    {
        switch (kind) {
        case Kind::Linear: return stored;
        case Kind::Power: return numbers::pow(std::max(stored, 0.0f), gamma);
        case Kind::Bt709: return kBt709.decode(stored);
        case Kind::Bt2020: return kBt2020.decode(stored);
        case Kind::Srgb: break;
        }
        return stored < 0.04045f ? stored / 12.92f : numbers::pow((stored + 0.055f) / 1.055f, 2.4f);
    }
    /// The exponent that comes nearest, for a file's gAMA entry: 2.2 for sRGB, 1.9 for those of television.
    float approximate_gamma() const { return kind == Kind::Linear ? 1.0f : gamma; }
    friend bool operator==(const TransferCurve&, const TransferCurve&) = default;
};

/// From the scene's working space to a file's values: encode_file(decode_work(x)). Equal curves cancel and two power
/// laws become one, which keeps values that a decode and an encode in turn would lose.
class Transcoder {
public:
    Transcoder() = default;
    Transcoder(const TransferCurve& working, const TransferCurve& file);
    /// Whether every value stays as it is.
    bool keeps() const { return working_ == TransferCurve() && file_ == TransferCurve(); }
    float to_file(float working) const { return file_.encode(working_.decode(working)); }
    float to_working(float file) const { return working_.encode(file_.decode(file)); }

private:
    TransferCurve working_, file_;
};

/// The curves of a picture, chosen at the end of the parse (spec 2, 10.1 and 10.4).
struct OutputCurves {
    TransferCurve working, file;
};

/// \param assumed       the scene's assumed_gamma, nothing if it gives none
/// \param version       the language version in force at the end of the text, times 100; a scene that names none is 362
/// \param file_gamma    option File_Gamma
/// \param display_gamma option Display_Gamma: tags the file where gamma handling is off
OutputCurves output_curves(const std::optional<TransferCurve>& assumed, int version, const TransferCurve& file_gamma,
                           const TransferCurve& display_gamma);

}  // namespace image
