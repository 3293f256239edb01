#pragma once

#include "parser/parse.h"
#include "render/plan/compiled_scene.h"

#include <cstdint>

namespace app {

/// A number that differs, as good as surely, where two pictures may: of the options that change a pixel, the version of
/// the program and the contents of the files read.
std::uint64_t picture_identity(const parser::Options& options, const plan::Options& planned,
                               const parser::Result& parsed);

}  // namespace app
