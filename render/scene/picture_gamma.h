#pragma once

#include "render/image/transfer_curve.h"
#include "render/scene/statement.h"

#include <optional>

namespace scene {

/// `gamma` as written in the statement of a picture (a number or srgb); nothing: not written.
inline std::optional<image::TransferCurve> written_gamma(const Statement& statement)
{
    const StatementItem* gamma = item_of(statement, "gamma");
    if (gamma == nullptr) return std::nullopt;
    if (std::holds_alternative<std::string>(gamma->operands[0])) return image::TransferCurve::srgb();
    return image::TransferCurve::power(static_cast<float>(number_of(gamma->operands[0])));
}

}  // namespace scene
