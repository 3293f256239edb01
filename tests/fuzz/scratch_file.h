#pragma once

#include "tests/fuzz/target.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>

namespace fuzz {

/// A file in memory where the system has such a folder, for readers that want a path. Removed at the end.
class ScratchFile {
public:
    explicit ScratchFile(const std::string& ending)
    {
        std::error_code ignored;
        const std::filesystem::path memory = "/dev/shm", folder = std::filesystem::is_directory(memory, ignored)
                                                                      ? memory
                                                                      : std::filesystem::temp_directory_path();
        path_ = (folder / ("whittle-fuzz-" + std::to_string(getpid()) + ending)).string();
    }
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;
    ~ScratchFile() { std::remove(path_.c_str()); }

    const std::string& path() const { return path_; }

    const std::string& holding(const Bytes& bytes) const
    {
        std::FILE* file = std::fopen(path_.c_str(), "wb");
        const bool written = file != nullptr &&
                             (bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size());
        require(written && std::fclose(file) == 0, "cannot write the scratch file");
        return path_;
    }

private:
    std::string path_;
};

}  // namespace fuzz
