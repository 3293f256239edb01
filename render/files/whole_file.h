#pragma once

#include <cstdio>
#include <optional>
#include <string>

namespace files {

/// All bytes of a file, of one that does not say its size, too. Throws std::system_error with the system's number where
/// it cannot be opened or a read fails half way; a folder is EISDIR.
std::string whole_file(const std::string& path);
/// All that is left of a stream, a pipe for one. Throws as above.
std::string rest_of(std::FILE* stream);
/// As whole_file(); nothing where it cannot be read.
std::optional<std::string> whole_file_if(const std::string& path);

/// Whether a failure of this number lies with the machine as it is now, not with the file: a full disk, a server that
/// is away. Another try may go well.
bool failure_may_pass(int number);

}  // namespace files
