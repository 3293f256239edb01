#include "render/app/output/whole_text.h"

#include "render/app/options/settings.h"
#include "render/image/picture_writer.h"
#include "render/image/pixels/passing_failure.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace app {

void check_place(const std::string& path)
{
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    if (!std::filesystem::is_directory(folder))
        throw OptionError(fmt::format("cannot write '{}': there is no folder '{}'", path, folder.string()));
    if (std::filesystem::is_directory(path)) throw OptionError(fmt::format("cannot write '{}': it is a folder", path));
    if (access(folder.c_str(), W_OK) != 0 || (access(path.c_str(), F_OK) == 0 && access(path.c_str(), W_OK) != 0))
        throw OptionError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
    // Of root, and of file systems that are full or of the system's own, access() knows less than trying does.
    const image::Replacement trial(path);
    if (!std::ofstream(trial.temporary(), std::ios::binary).put('\n').flush())
        throw OptionError(fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
}

void put_bytes(const std::string& path, const std::string& bytes)
{
    image::Replacement file(path);
    std::ofstream out(file.temporary(), std::ios::binary);
    out << bytes;
    if (!out.flush()) image::fail_by_system(errno, fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
    out.close();
    file.put_in_place();
}

}  // namespace app
