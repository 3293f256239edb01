#pragma once

#include "render/app/run/run.h"
#include "render/app/run/last_resort.h"
#include "render/app/layers/layers_file.h"
#include "render/app/report/report.h"
#include "render/plan/compiled_scene.h"

#include <functional>
#include <memory>
#include <string>

namespace app {

/// From a compiled scene to the picture file: traced as a whole, or in strips of rows where the memory does not hold
/// it.
struct PictureTask {
    Run& run;
    LastResort& last_resort;
    const plan::CompiledScene& compiled;
    const image::FileSettings file;
    const std::string path;  ///< of the picture; empty: standard output or standard error
    /// The scene at moment k of so many that the picture is the mean of; moment 0 is `compiled`.
    const std::function<std::unique_ptr<plan::CompiledScene>(int k)> moment = {};
    const int moments = 1;
    const LayersTask layers = {};
    /// Given the whole picture, which then goes into no file; empty: it is written.
    const std::function<void(const image::Image&)> take = {};
};

/// Returns the exit status; what was done is kept where it is cancelled. Throws for what ends the run.
int render_picture(const PictureTask& task, StageTimes& times);

}  // namespace app
