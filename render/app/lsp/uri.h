#pragma once

#include <string>

namespace app::lsp {

/// `file:///a%20b` -> `/a b`; other schemes get a path of their own that no file has.
std::string path_of_uri(const std::string& uri);
std::string uri_of_path(const std::string& path);

}  // namespace app::lsp
