#pragma once

#include "render/app/options/settings.h"
#include "render/image/files.h"
#include "render/picture/render.h"

#include <functional>
#include <string>

namespace app {

/// A scene's picture, made in memory and looked at while it grows.
struct StillTask {
    const Settings& settings;
    plan::CompiledScene& scene;  ///< its options' size and window are changed meanwhile
    const image::FileSettings& file;
    double seconds_before = 0.0;  ///< that reading and planning took
    const std::atomic<bool>& cancel;
    std::function<void(const std::string&)> note;  ///< told of what a user should know
    /// Shown what there is, now and then, from any thread but never two at once; empty: nobody looks. Before the
    /// picture itself come coarse ones, which take a tenth of its time.
    std::function<void(const image::Image&)> preview = {};
};

/// What trace::render() leaves in `picture`, which is made. Same bytes whether somebody looks or not.
trace::RenderStatistics draw_still(const StillTask& task, image::Image& picture);

/// How threads and kernel of a render are chosen.
trace::RenderOptions render_options(const Settings& settings, const std::atomic<bool>& cancel);

/// Options of a picture that has one pixel for `step` times `step` of the whole one's; of the same size without
/// antialiasing where it is 1.
plan::Options coarse_options(const plan::Options& whole, int step);

}  // namespace app
