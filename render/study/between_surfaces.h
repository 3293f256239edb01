#pragma once

#include "render/study/page.h"

#include <string>

namespace study {

/// HTML: what stands in for light between surfaces beside paths, in one plot, and what each reaches in equal time.
/// Empty where nothing of it was measured.
std::string between_surfaces(const Section& section, double wanted);

}  // namespace study
