#include "render/app/base/library_path.h"

#include "render/app/base/text.h"
#include "render/image/codecs/module_path.h"

#include <cstdlib>
#include <filesystem>

namespace app {
namespace {

using namespace std::string_literals;

/// `share` of the prefix that the program is installed or unpacked below, in `bin` or somewhere in `lib`: what stands
/// there came with it, so it is looked at first.
std::string own_share()
{
    for (std::filesystem::path folder = image::program_file().parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
        if (folder.filename() == "bin" || folder.filename() == "lib") return (folder.parent_path() / "share").string();
    return "/usr/share";
}

}  // namespace

std::vector<std::string> default_library_path()
{
    std::vector<std::string> folders;
    if (const char* given = std::getenv("WHITTLE_LIBRARY_PATH")) {
        for (const std::string_view folder : pieces_of(given, ':'))
            if (!folder.empty()) folders.emplace_back(folder);
        return folders;
    }
    for (const std::string& root : {own_share(), "/usr/share"s, "/usr/local/share"s}) {
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
