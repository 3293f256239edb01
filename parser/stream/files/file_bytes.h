#pragma once

#include "render/scene/base/message.h"

#include <string>

namespace parser {

class TokenStream;

/// All of a file that the scene names at `at`. Throws an Error there if it cannot be read, a PassingError if another
/// try may go well: it was found, so it went, or is on a disk that is away.
std::string bytes_of_file(TokenStream& in, const scene::SourceRef& at, const std::string& path);

/// Fails at `at` for the system's number of a failure: for now, where another try may go well.
[[noreturn]] void fail_to_read(TokenStream& in, const scene::SourceRef& at, const std::string& path, int number);

}  // namespace parser
