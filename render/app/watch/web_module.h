#pragma once

#include "render/web/web.h"

#include <memory>
#include <string>

namespace app {

/// Opens the module of render/web and starts its server. Throws std::runtime_error with the reason where it cannot.
std::unique_ptr<web::Server> start_web_server(int port, const std::string& token, web::Host& host);

}  // namespace app
