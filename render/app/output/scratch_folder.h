#pragma once

#include "render/image/pixels/picture.h"

#include <stdlib.h>

#include <filesystem>
#include <string>

namespace app {

/// An empty folder for files on their way, removed with all it holds at the end. Throws FileError.
class ScratchFolder {
public:
    ScratchFolder() : path_((std::filesystem::temp_directory_path() / ("whittle-" + std::string(6, 'X'))).string())
    {
        if (mkdtemp(path_.data()) == nullptr)
            throw image::FileError("cannot make a folder in '" + std::filesystem::temp_directory_path().string() + "'");
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string operator/(const std::string& name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

}  // namespace app
