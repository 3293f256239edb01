#pragma once

#include "parser/parse.h"
#include "render/app/frames/frames.h"
#include "render/app/options/settings.h"
#include "render/image/files.h"
#include "render/plan/compiled_scene.h"
#include "render/picture/render.h"

namespace app {

/// What the settings mean for each stage.
parser::Options parser_options(const Settings& settings, const FrameList& list, const Frame& frame);
plan::Options plan_options(const Settings& settings);
image::FileSettings file_settings(const Settings& settings, const scene::Description& description);
trace::Isa isa_of(const Settings& settings);
/// As many as were asked for, else the allocation's, else one for each core that the process may run on.
int threads_of(const Settings& settings);

/// Throws OptionError where options of a picture do not go together, before anything is read.
void refuse_contradictions(const Settings& settings);

/// +I- or +Istdin.
bool from_standard_input(const Settings& settings);

}  // namespace app
