#pragma once

#include "render/app/farm/measure.h"

#include <optional>
#include <vector>

namespace app {

/// What every frame of a job will cost, and how far off that may be.
struct JobEstimate {
    std::vector<FrameCost> frames;  ///< as the job lists them
    std::optional<double> error;    ///< share of the sum, expected; none where too few frames tell it
    int measured = 0;               ///< frames that were rendered for it, small, or are finished
    double spent = 0.0;             ///< processor seconds that this took
};

/// From every k-th frame as a small picture, or from finished tasks where the job names some. Says on standard error
/// what it does. An empty one was cancelled.
JobEstimate estimate_job(const FarmJob& job, const Cancellation& cancel);

/// Values at 0, 1, ... `count` - 1 from those that are known, by lines between them.
/// \param known ascending places with values; at least one
std::vector<double> between(const std::vector<std::pair<std::size_t, double>>& known, std::size_t count);

/// How far the known values are from the lines between their neighbours, as a share of their sum; none for fewer than
/// three, which are on their lines whatever they are.
std::optional<double> unevenness(const std::vector<std::pair<std::size_t, double>>& known);

}  // namespace app
