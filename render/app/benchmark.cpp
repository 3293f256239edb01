#include "render/app/benchmark.h"

#include "render/app/options/ini_file.h"
#include "render/app/base/library_path.h"

#include <filesystem>

namespace app {

void apply_benchmark(Settings& settings)
{
    constexpr const char* kScene = "scenes/advanced/benchmark/benchmark";
    for (const std::string& folder : default_library_path()) {
        const std::string base = folder + "/" + kScene;
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(base + ".pov", ignored) || !read_ini_file(settings, base + ".ini"))
            continue;
        settings.input_file = base + ".pov";
        settings.output_file.clear();
        settings.output_to_file = false;
        settings.not_acted_on.clear();
        return;
    }
    throw OptionError("the benchmark scene is not installed: it is in Debian's package povray-examples");
}

}  // namespace app
