#pragma once

#include "parser/constants.h"
#include "parser/parse.h"
#include "render/app/frames/frames.h"
#include "render/app/watch/passes.h"
#include "render/app/watch/view.h"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

/// What pages are told besides blocks, as JSON of one line.
std::string messages_event(int generation, bool wrong, const std::vector<scene::Message>& messages);

/// A text that is going to be read.
/// \param read_at  when, in milliseconds since 1970
std::string text_event(int generation, const std::string& file, std::int64_t read_at);

/// A picture that is going to be traced.
/// \param text  when the text that it is of was read
/// \param clock  that it is of
/// \param request  View::request
std::string scene_event(int generation, int width, int height, std::int64_t text, double clock, std::uint64_t request);

/// \param total seconds from the save on
std::string done_event(int generation, double total, const PassTimes& times, const trace::RayCounts* rays);

/// The sliders: the clock, the constants that the scene asks for with #ifdef, and the numbers that were set.
/// \param camera the text of it
/// \param frames of the animation that the options tell; where they tell none, a page plays the clock from 0 to 1
std::string controls_event(const View& view, double clock, const std::vector<parser::SceneConstant>& constants,
                           const std::string& camera, const FrameList& frames);

}  // namespace app
