#pragma once

#include "render/kernel/radiosity/gather_scratch.h"

namespace trace {

struct Context;

namespace radiosity {

/// Makes samples for the requests that `which` names, bit by bit: GatherScratch::made and kept (spec 6, 4.4). Their
/// rays share tiles.
void gather(Context& context, std::uint64_t which);

}  // namespace radiosity
}  // namespace trace
