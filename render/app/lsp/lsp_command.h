#pragma once

#include <string>
#include <vector>

namespace app {

/// `whittle lsp`: a language server on standard input and output until its client ends it or is gone. Returns the exit
/// status.
int lsp_command(const std::vector<std::string>& arguments);
std::string lsp_help();

}  // namespace app
