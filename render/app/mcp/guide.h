#pragma once

#include "render/app/mcp/tools.h"

namespace app::mcp {

/// The list of resources, as the protocol has it.
json resource_list();
/// One of them; null: there is none of this address.
json resource_contents(const std::string& uri);

/// What a client is told of the server when they meet.
const char* instructions();

}  // namespace app::mcp
