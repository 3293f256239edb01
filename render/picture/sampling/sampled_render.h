#pragma once

#include "render/picture/render.h"
#include "render/picture/sampling/sampled_picture.h"

#include <functional>

namespace trace {

class PathFeatures;

/// When a picture of many samples is done: what comes first of those that are given.
struct SamplingGoal {
    std::uint32_t samples = 0;  ///< in each pixel, more than it has already; 0: as the error or the time asks
    double error = 0.0;         ///< of the picture, in shown levels (0 to 255), root mean square over colours; 0: none
    double seconds = 0.0;       ///< from now on; 0: no matter. A first pass is taken whatever it costs
    std::function<double()> clock;  ///< seconds since any moment, asked by all threads; empty: the steady clock's
    std::uint32_t seed = 0;         ///< another one: other samples, independent of these
    bool even = false;              ///< all pixels get as many, whatever their spread
};

/// Traces passes of samples until the goal is met: docs/error_and_time.md. The same samples for any number of threads
/// and any instruction set, unless the time ends it. Of `options` blocks and `done` are not looked at, but for
/// `others`.
/// \param after_pass called with the share of the goal that is met, when all pixels are as they are shown; may be empty
/// \param features of the paths are added here; null: nobody asks
RenderStatistics render_sampled(const plan::CompiledScene& scene, const RenderOptions& options,
                                const SamplingGoal& goal, const ShownLevel& shown, SampledPicture& picture,
                                const std::function<void(double)>& after_pass = {}, PathFeatures* features = nullptr);

}  // namespace trace
