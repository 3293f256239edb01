#pragma once

#include "render/app/frames/frames.h"
#include "render/app/report/console_reporter.h"
#include "render/app/run/cancellation.h"
#include "render/image/files.h"
#include "render/picture/render.h"

#include <optional>
#include <string>

namespace app {

/// What the frames of a run share.
struct Run {
    const Settings& settings;
    const FrameList list;
    const image::Files files;
    Streams& streams;
    ConsoleReporter& reporter;
    Cancellation& cancel;
    Remains& remains;
    std::optional<std::string> input;  ///< the scene's text, if it came from standard input
    bool told_far = false;             ///< that something is drawn which POV-Ray leaves out; once a run
};

}  // namespace app
