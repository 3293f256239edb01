#include "render/image/levels/transfer_curve.h"


namespace image {

namespace {

/// The first language version with gamma handling always on.
constexpr int kGammaVersion = 370;

}  // namespace

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
