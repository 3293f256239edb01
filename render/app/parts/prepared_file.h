#pragma once

#include "render/picture/passes/prepared.h"

#include <optional>
#include <string>

namespace app {

/// Reads what --prepare has left beside a picture for its parts. Nothing: it is not there or, as `other` says then, is
/// damaged or of another fingerprint.
std::optional<trace::Prepared> read_prepared(const std::string& path, const std::string& fingerprint, bool& other);

/// Throws image::FileError.
void write_prepared(const std::string& path, const std::string& fingerprint, const trace::Prepared& prepared);

}  // namespace app
