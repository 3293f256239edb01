#pragma once

#include "render/kernel/radiosity/gather_scratch.h"

namespace trace {

struct Context;

namespace radiosity {

/// Answers the first `count` of GatherScratch::requests, of the bounce that the context is at: from samples, or by
/// gathering new ones (spec 6, 4.3). What a pass finds goes to its Filling; without one nothing is kept.
void find_ambient(Context& context, std::size_t count);

}  // namespace radiosity
}  // namespace trace
