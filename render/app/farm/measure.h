#pragma once

#include "render/app/farm/job.h"
#include "render/app/farm/size_model.h"
#include "render/app/run/cancellation.h"

#include <map>
#include <string>

namespace app {

/// Renders a frame with a thread, in a picture that is `scale` as wide and high, and tells what it cost. Throws
/// std::runtime_error with the renderer's words where it fails.
SizedCost measure_frame(const FarmJob& job, const Frame& frame, double scale, const Cancellation& cancel);

/// Costs by frame of the tasks whose --json files lie in a folder; frames that were skipped or not finished are not
/// told. Throws OptionError where the folder cannot be read.
std::map<int, FrameCost> finished_frames(const std::string& folder);

}  // namespace app
