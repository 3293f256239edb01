#pragma once

#include "parser/constants.h"
#include "parser/parse.h"
#include "render/app/watch/passes.h"
#include "render/app/watch/view.h"

#include <string>
#include <vector>

namespace app {

/// What pages are told besides blocks, as JSON of one line.
std::string messages_event(int generation, bool wrong, const std::vector<scene::Message>& messages);

/// \param total seconds from the save on
std::string done_event(int generation, double total, const PassTimes& times, const trace::RayCounts* rays);

/// The sliders: the clock, and the constants that the scene asks for with #ifdef.
/// \param camera the text of it
std::string controls_event(const View& view, double clock, const std::vector<parser::SceneConstant>& constants,
                           const std::string& camera);

}  // namespace app
