#pragma once

#include <functional>
#include <pthread.h>

namespace app {

/// Gives this thread and those that begin after it deep stacks: nests of declared textures and solids are gone through
/// by calls. Memory is taken as it is reached; where what the process may have is limited (ulimit -v), stacks stay
/// smaller, and so do the nests that the plan accepts. Call once, before other threads begin.
void deepen_stacks();

/// The same for one piece of work, in a process whose other threads are not ours to change: on a thread of its own,
/// which nobody waits for. Throws std::system_error where none can begin. What the work throws ends the process.
void start_on_deep_stack(std::function<void()> work);

/// pthread_create(); throws std::system_error where none can begin. Of a std::thread malloc would map an arena, for it
/// frees memory in the new thread.
pthread_t start_thread(void* (*work)(void*), void* of, const pthread_attr_t* attributes = nullptr);

}  // namespace app
