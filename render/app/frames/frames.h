#pragma once

#include "render/app/options/settings.h"

#include <vector>

namespace app {

struct Frame {
    int number = 0;
    float clock = 0.0f;
};

/// What an animation's options come to (spec 1, 18.8).
struct FrameList {
    bool animation = false;  ///< off: one frame, no number in the file name
    std::vector<Frame> frames;
    int initial_frame = 0,
        final_frame = 0;  ///< as a scene sees them: cyclic ones end with a frame that is not rendered
    int last_frame = 0;   ///< that is rendered, without a subset
    double clock_delta = 0.0;
    bool clock_on = false;
    int digits = 1;  ///< of the number in file names
};

/// Throws OptionError for frames that cannot be.
FrameList frames_of(const Settings& settings);

}  // namespace app
