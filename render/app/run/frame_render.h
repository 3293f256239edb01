#pragma once

#include "render/app/run/frames.h"
#include "render/app/report/console_reporter.h"
#include "render/app/run/render_command.h"
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

/// One frame from the scene file to the picture file. Returns the exit status; throws for what ends the run.
int render_frame(Run& run, const Frame& frame);

trace::Isa isa_of(const Settings& settings);

/// +I- or +Istdin.
bool from_standard_input(const Settings& settings);

}  // namespace app
