#include "render/app/watch/web_module.h"

#include "render/image/codecs/module_path.h"

#include <stdexcept>

namespace app {

std::unique_ptr<web::Server> start_web_server(int port, const std::string& token, web::Host& host)
{
    const auto entry =
        reinterpret_cast<web::StartServer>(image::module_entry(web::kWebModuleName, web::kWebModuleEntry));
    std::string why;
    std::unique_ptr<web::Server> server(entry(port, token.c_str(), host, why));
    if (!server) throw std::runtime_error("cannot serve the page: " + why);
    return server;
}

}  // namespace app
