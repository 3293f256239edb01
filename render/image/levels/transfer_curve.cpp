#include "render/image/levels/transfer_curve.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <cmath>

namespace image {

namespace {

/// How far an exponent may be from 1 and still count as 1 (spec 2, 10.2: File_Gamma 1.005 is the identity, 1.02 is
/// not).
constexpr float kIdentityExponent = 0.01f;

/// The first language version with gamma handling always on.
constexpr int kGammaVersion = 370;

/// ITU-R's curves: a straight piece of this slope up to `knee`, then scale * x^0.45 - (scale - 1).
struct Television {
    float knee, scale;
    static constexpr float kSlope = 4.5f, kExponent = 0.45f;
    float encode(float x) const { return x < knee ? x * kSlope : scale * numbers::pow(x, kExponent) - (scale - 1.0f); }
    float decode(float x) const
    {
        return x < knee * kSlope ? x / kSlope : numbers::pow((x + (scale - 1.0f)) / scale, 1.0f / kExponent);
    }
};
constexpr Television kBt709{0.018f, 1.099f}, kBt2020{0.018053968510807f, 1.09929682680944f};

}  // namespace

TransferCurve TransferCurve::power(float decoding_gamma)
{
    if (std::fabs(1.0f - 1.0f / decoding_gamma) <= kIdentityExponent) return linear();
    return {Kind::Power, decoding_gamma};
}

float TransferCurve::encode(float x) const
{
    switch (kind) {
    case Kind::Linear: return x;
    case Kind::Power: return numbers::pow(std::max(x, 0.0f), 1.0f / gamma);
    case Kind::Bt709: return kBt709.encode(x);
    case Kind::Bt2020: return kBt2020.encode(x);
    case Kind::Srgb: break;
    }
    return x <= 0.0031308f ? x * 12.92f : 1.055f * numbers::pow(x, 1.0f / 2.4f) - 0.055f;
}

float TransferCurve::decode(float x) const
{
    switch (kind) {
    case Kind::Linear: return x;
    case Kind::Power: return numbers::pow(std::max(x, 0.0f), gamma);
    case Kind::Bt709: return kBt709.decode(x);
    case Kind::Bt2020: return kBt2020.decode(x);
    case Kind::Srgb: break;
    }
    return x < 0.04045f ? x / 12.92f : numbers::pow((x + 0.055f) / 1.055f, 2.4f);
}

Transcoder::Transcoder(const TransferCurve& working, const TransferCurve& file) : working_(working), file_(file)
{
    const bool both_powers = working.kind == TransferCurve::Kind::Power && file.kind == TransferCurve::Kind::Power;
    if (working == file) {
        working_ = file_ = TransferCurve::linear();
    } else if (both_powers) {
        working_ = TransferCurve::linear();
        file_ = TransferCurve::power(file.gamma / working.gamma);
    }
}

OutputCurves output_curves(const std::optional<TransferCurve>& assumed, int version, const TransferCurve& file_gamma,
                           const TransferCurve& display_gamma)
{
    if (assumed) return {*assumed, file_gamma};
    if (version >= kGammaVersion) return {TransferCurve::linear(), file_gamma};
    return {display_gamma,
            display_gamma};  // gamma handling off: values pass unchanged, the file is tagged all the same
}

}  // namespace image
