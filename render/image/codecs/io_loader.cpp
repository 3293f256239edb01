#include "render/image/codecs/io_loader.h"

#include "render/image/pixels/picture.h"
#include "render/image/codecs/module_path.h"

#include <dlfcn.h>

#include <filesystem>
#include <thread>

namespace image {

namespace {

const IoModule* load_module(const std::filesystem::path& module)
{
    void* handle = dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL);  // lazy: 0.20 s of work instead of 0.215
    if (!handle) throw FileError(std::string("cannot load the picture file library: ") + dlerror());
    using Entry = const IoModule* (*)();
    const auto entry = reinterpret_cast<Entry>(dlsym(handle, kIoModuleEntry));
    if (!entry) throw FileError(std::string("the picture file library is not ours: ") + dlerror());
    return entry();
}

}  // namespace

void IoLoader::start()
{
    std::call_once(once_, [this] {
        const std::optional<std::filesystem::path> module = find_module(kIoModuleName);
        if (!module) throw FileError(missing_module(kIoModuleName));
        std::packaged_task<const IoModule*()> load([path = *module] { return load_module(path); });
        module_ = load.get_future().share();
        std::thread(std::move(load)).detach();  // unlike std::async, a program that stops early does not wait for it
    });
}

const IoModule& IoLoader::get()
{
    start();
    return *module_.get();
}

}  // namespace image
