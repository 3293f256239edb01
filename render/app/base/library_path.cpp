#include "render/app/base/library_path.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace app {

std::vector<std::string> default_library_path()
{
    std::vector<std::string> folders;
    if (const char* given = std::getenv("WHITTLE_LIBRARY_PATH")) {
        std::istringstream list(given);
        for (std::string folder; std::getline(list, folder, ':');)
            if (!folder.empty()) folders.push_back(folder);
        return folders;
    }
    for (const char* root : {"/usr/share", "/usr/local/share"}) {
        for (const char* name : {"povray-3.7", "povray"}) {
            const std::filesystem::path base = std::filesystem::path(root) / name;
            std::error_code ignored;
            if (!std::filesystem::is_directory(base / "include", ignored)) continue;
            folders.push_back(base.string());
            if (std::filesystem::is_directory(base / "ini", ignored)) folders.push_back((base / "ini").string());
            folders.push_back((base / "include").string());
            return folders;
        }
    }
    return folders;
}

}  // namespace app
