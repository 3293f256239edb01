#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace app::mcp {

/// What a piece of work may take.
struct ChildLimits {
    double seconds = 20.0;                      ///< of the clock; then it is asked to end, and a second later ended
    std::size_t memory = std::size_t{2} << 30;  ///< bytes that it may have in memory
    std::size_t output = std::size_t{4} << 20;  ///< bytes that are kept of each of its two outputs
};

struct ChildResult {
    int status = 1;          ///< as a process exits
    bool late = false;       ///< it was ended for its time
    bool too_large = false;  ///< and for its memory
    bool cancelled = false;  ///< it was ended because nobody waits any more
    int signal = 0;          ///< that ended it otherwise; 0: none
    std::string out, err;
};

/// Runs work in a process of its own, a copy of this one: whatever a scene makes of it, memory, time, a crash, ends
/// with it. This process must have one thread. The work prints as a command does. `wanted` is called while it runs,
/// some times a second and whenever the client says something; false ends it. `listen` is the client's file at that
/// time, which is watched; -1: there is nothing to hear.
ChildResult run_child(const ChildLimits& limits, const std::function<int()>& work, const std::function<int()>& listen,
                      const std::function<bool()>& wanted);

}  // namespace app::mcp
