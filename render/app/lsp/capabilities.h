#pragma once

#include "render/app/lsp/positions.h"

namespace app::lsp {

/// UTF-8 where the client offers it, else the protocol's UTF-16.
Encoding encoding_for(const json& initialize);

/// The result of `initialize`.
json capabilities(Encoding encoding);

}  // namespace app::lsp
