#pragma once

#include "render/app/output/scratch_folder.h"
#include "render/image/files.h"

#include <cstdio>
#include <fstream>
#include <string>

namespace app {

/// Standard output gets its picture through a file of its own: picture libraries want to seek.
class StreamedFile {
public:
    explicit StreamedFile(image::FileType type) : path_(folder_ / ("picture" + std::string(image::extension(type)))) {}
    const std::string& path() const { return path_; }
    void send(std::FILE* stream) const
    {
        std::ifstream in(path_, std::ios::binary);
        char block[65536];
        while (in.read(block, sizeof block) || in.gcount() > 0)
            std::fwrite(block, 1, static_cast<std::size_t>(in.gcount()), stream);
        if (std::fflush(stream) != 0 || std::ferror(stream)) throw image::FileError("cannot write to standard output");
    }

private:
    ScratchFolder folder_;
    std::string path_;
};

}  // namespace app
