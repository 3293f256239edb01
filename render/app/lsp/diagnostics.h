#pragma once

#include "language/names/files.h"
#include "render/app/lsp/positions.h"
#include "render/app/lsp/reading.h"

#include <map>

namespace app::lsp {

/// Diagnostics in the protocol's form, by path of the text that they are about.
using Diagnostics = std::map<std::string, std::vector<json>>;

/// What reading told: a message's word is underlined, and what led there is named with its places.
Diagnostics diagnostics_of(const Reading& reading, language::Files& files, Encoding encoding);

/// What a text's tokens alone say, for an include file that no open scene reads: brackets without their partners, what
/// is no token.
std::vector<json> token_diagnostics(const language::Document& document, Encoding encoding);

}  // namespace app::lsp
