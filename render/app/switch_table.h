#pragma once

#include "render/app/settings.h"

#include <string>

namespace app {

/// One switch with its sign, as in +W640 or -A. Throws OptionError for one that is not known.
void apply_switch(Settings& settings, const std::string& word);

}  // namespace app
