#pragma once

#include "render/app/run/run.h"
#include "render/app/run/scene_queries.h"
#include "render/app/run/stage_options.h"

namespace app {

/// How a scene is read where no picture is made of it: its first frame, with answers to what it asks, and what it would
/// write is left alone.
class SceneReading {
public:
    /// \param cancel when set, reading ends with parser::Cancelled; outlives this, as do the settings
    SceneReading(const Settings& settings, const std::atomic<bool>& cancel)
        : queries_(threads_of(settings), cancel, isa_of(settings))
    {
        const FrameList list = frames_of(settings);
        options = parser_options(settings, list, list.frames.front());
        options.queries = &queries_;
        options.cancel = &cancel;
        options.write_nothing = true;
    }
    SceneReading(const SceneReading&) = delete;
    SceneReading& operator=(const SceneReading&) = delete;

    parser::Options options;

private:
    SceneQueries queries_;
};

}  // namespace app
