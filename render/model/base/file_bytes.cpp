#include "render/model/base/file_bytes.h"

#include "render/model/base/model.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace model {

std::string bytes_of_file(const std::string& path)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) throw ModelError(std::strerror(errno), 0);
    struct stat known = {};
    const bool plain = fstat(fileno(file.get()), &known) == 0 && S_ISREG(known.st_mode) && known.st_size > 0;
    // One byte more than it should hold, so that a plain file takes one look.
    constexpr std::size_t kPiece = std::size_t{1} << 20;
    std::size_t piece = plain ? static_cast<std::size_t>(known.st_size) + 1 : kPiece;
    std::string bytes;
    for (bool more = true; more; piece = kPiece) {
        const std::size_t before = bytes.size();
        bytes.resize(before + piece);
        const std::size_t got = std::fread(bytes.data() + before, 1, piece, file.get());
        bytes.resize(before + got);
        more = got == piece;
    }
    if (std::ferror(file.get()) != 0) throw ModelError("it cannot be read", 0);
    return bytes;
}

}  // namespace model
