#pragma once

#include "render/image/pixels/picture.h"

#include <string>

namespace image {

/// A failure that lies with the machine as it is now, not with the file: a full disk, a server that is away, a file
/// that went between being found and being read. Another try may go well.
struct PassingFailure : FileError {
    using FileError::FileError;
};

/// Throws the failure of this number in the system's words, or `text` in their place.
[[noreturn]] void fail_by_system(int number, const std::string& text = {});

/// Throws the same failure, of the same kind, with `what` in front.
[[noreturn]] void fail_named(const std::string& what, const FileError& error);

}  // namespace image
