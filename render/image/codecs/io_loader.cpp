#include "render/image/codecs/io_loader.h"

#include "render/image/codecs/module_path.h"
#include "render/image/pixels/picture.h"

#include <thread>

namespace image {

void IoLoader::start()
{
    std::call_once(once_, [this] {
        if (!find_module(kIoModuleName)) throw FileError(missing_module(kIoModuleName));
        std::packaged_task<const IoModule*()> load(
            [] { return reinterpret_cast<const IoModule* (*)()>(module_entry(kIoModuleName, kIoModuleEntry))(); });
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
