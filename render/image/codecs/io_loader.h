#pragma once

#include "render/image/codecs/io_module.h"

#include <future>
#include <mutex>

namespace image {

/// The module that holds OpenImageIO, loaded once: in the background from start(), else by the first get(). Its 260
/// shared libraries take some 0.2 s, so nothing that can do without it loads it.
class IoLoader {
public:
    /// Throws FileError at once if there is no such module.
    void start();
    /// Waits for the module. Throws FileError if it cannot be loaded.
    const IoModule& get();

private:
    std::once_flag once_;
    std::shared_future<const IoModule*> module_;
};

}  // namespace image
