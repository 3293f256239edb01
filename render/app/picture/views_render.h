#pragma once

#include "render/app/picture/picture_run.h"

#include <functional>
#include <string>

namespace app {

/// From one plan to the pictures of many cameras.
struct ViewsTask {
    Run& run;
    LastResort& last_resort;
    const scene::Description& description;  ///< its objects may be gone
    plan::CompiledScene& compiled;          ///< with the scene's own camera
    const std::string path;                 ///< that the picture would have without views; empty: standard output
    const std::function<std::unique_ptr<plan::CompiledScene>(int k)> moment;  ///< see PictureTask
    const int moments;
    const LayersTask layers;
    /// How a picture of these cameras is written, and what it is made from.
    const std::function<image::FileSettings(const std::string& cameras)> file;
    /// Whether +C leaves a picture that is there.
    const std::function<bool(const std::string& path, const std::string& fingerprint)> done;
};

/// Returns the exit status.
int render_views(const ViewsTask& task, StageTimes& times);

/// --dump=views: the cameras as statements.
void print_views(const ViewsTask& task);

}  // namespace app
