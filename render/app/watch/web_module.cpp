#include "render/app/watch/web_module.h"

#include "render/image/codecs/module_path.h"

#include <dlfcn.h>

#include <stdexcept>

namespace app {

std::unique_ptr<web::Server> start_web_server(int port, const std::string& token, web::Host& host)
{
    const auto module = image::find_module(web::kWebModuleName);
    if (!module) throw std::runtime_error(image::missing_module(web::kWebModuleName));
    void* const handle = dlopen(module->c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) throw std::runtime_error(std::string("cannot load the server: ") + dlerror());
    const auto entry = reinterpret_cast<web::StartServer>(dlsym(handle, web::kWebModuleEntry));
    if (entry == nullptr) throw std::runtime_error(std::string("the server is not ours: ") + dlerror());
    std::string why;
    std::unique_ptr<web::Server> server(entry(port, token.c_str(), host, why));
    if (!server) throw std::runtime_error("cannot serve the page: " + why);
    return server;
}

}  // namespace app
