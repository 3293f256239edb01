#pragma once

#include "render/app/options/settings.h"
#include "render/image/levels/quantise.h"
#include "render/picture/render.h"

#include <functional>
#include <memory>
#include <string>

namespace app {

/// A picture of many samples, pass after pass, moment after moment, as --samples, --error, --time, --integrator=path
/// and Shutter ask for it.
struct SampledTask {
    const Settings& settings;
    const plan::CompiledScene& scene;  ///< at moment 0
    std::shared_ptr<const trace::IndirectLight> indirect;
    const image::Encoding& encoding;  ///< of the file: errors are measured in its levels
    double seconds_before = 0.0;      ///< that went before the picture: --time counts them
    /// The scene at moment k of so many that the picture is the mean of.
    std::function<std::unique_ptr<plan::CompiledScene>(int k)> moment = {};
    int moments = 1;
    std::function<trace::RenderOptions()> options = {};
    std::vector<bool> others = {};  ///< RenderOptions::others
    std::function<void(const std::string&)> note = {};
    /// The picture is as it is shown now, and so far on.
    std::function<void(double share, bool by_samples)> after_pass = {};
    std::function<void(double share)> progress = {};
};

/// \param picture has the picture's size and holds all rows
trace::RenderStatistics draw_samples(const SampledTask& task, image::Image& picture);

}  // namespace app
