#pragma once

namespace app {

/// Gives this thread and those that begin after it deep stacks: nests of declared textures and solids are gone through
/// by calls. Memory is taken as it is reached; where what the process may have is limited (ulimit -v), stacks stay
/// smaller, and so do the nests that the plan accepts. Call once, before other threads begin.
void deepen_stacks();

}  // namespace app
