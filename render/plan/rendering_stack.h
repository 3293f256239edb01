#pragma once

#include <cstddef>

namespace plan {

/// Bytes of stack of every thread that renders: how deep nests may be that are gone through by calls. TBB's usual size
/// until the program says otherwise, before other threads begin.
inline std::size_t& rendering_stack()
{
    static std::size_t bytes = std::size_t{4} << 20;
    return bytes;
}

}  // namespace plan
